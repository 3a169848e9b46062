// SPDX-License-Identifier: Apache-2.0
// The interfaces of constitutive laws. What each law is, its equation and its source stand in its own .cpp.
//
// A tissue's energy is psi(C_bar) + sum of fibre energies psi_f(lambda_bar) + U(J), with the distortional tensor
// C_bar = J^(-2/3) C and the distortional fibre stretch lambda_bar = sqrt(a0 . C_bar a0). Laws see C_bar,
// lambda_bar and J only; the projection onto the distortional space is done once for their sum (material/tissue.hpp).
#pragma once

#include <limits>

#include "facies/math/dual2.hpp"
#include "facies/math/voigt.hpp"

namespace facies::material {

/// What a distortional law answers at one point.
struct LawResponse {
  double psi = 0.0;   ///< energy per reference volume [kPa]
  StressVoigt S_bar;  ///< 2 dpsi/dC_bar [kPa]
  Mat6 C4_bar;        ///< 4 d2psi/dC_bar dC_bar [kPa]
};

/// A distortional hyperelastic law psi(C_bar). Fixed at construction, stateless, safe to call from any thread.
class Law {
 public:
  Law() = default;
  Law(const Law&) = delete;
  Law& operator=(const Law&) = delete;
  Law(Law&&) = delete;
  Law& operator=(Law&&) = delete;
  virtual ~Law() = default;

  /// psi [kPa] of any symmetric positive definite C_bar.
  [[nodiscard]] virtual double energy(const Sym3<double>& C_bar) const = 0;

  /// The same energy carrying first and second derivatives by the six components of C_bar.
  [[nodiscard]] virtual Dual2<6> energy(const Sym3<Dual2<6>>& C_bar) const = 0;

  /// psi, S_bar and C4_bar. The default differentiates energy() automatically; a closed form overrides it where it is hot.
  [[nodiscard]] virtual LawResponse respond(const Sym3<double>& C_bar) const;

  /// S_bar alone. The default takes it from respond().
  [[nodiscard]] virtual StressVoigt stress(const Sym3<double>& C_bar) const;
};

/// Exact response of a law from its energy by automatic differentiation: what closed forms are checked against.
[[nodiscard]] LawResponse differentiate(const Law& law, const Sym3<double>& C_bar);

/// U, U' and U'' of a volumetric law at J.
struct VolumetricResponse {
  double U = 0.0;        ///< [kPa]
  double dU_dJ = 0.0;    ///< the pressure, positive in tension [kPa]
  double d2U_dJ2 = 0.0;  ///< [kPa]
};

/// A volumetric law U(J), J > 0.
class VolumetricLaw {
 public:
  VolumetricLaw() = default;
  VolumetricLaw(const VolumetricLaw&) = delete;
  VolumetricLaw& operator=(const VolumetricLaw&) = delete;
  VolumetricLaw(VolumetricLaw&&) = delete;
  VolumetricLaw& operator=(VolumetricLaw&&) = delete;
  virtual ~VolumetricLaw() = default;
  [[nodiscard]] virtual VolumetricResponse respond(double J) const = 0;

  /// J beyond which tissue of this law counts as torn: it gives way the more, the more it grows, and a balance that it
  /// finds there is no answer. Infinity for a law that never gives way.
  [[nodiscard]] virtual double tearing_J() const { return std::numeric_limits<double>::infinity(); }
};

/// psi_f and its derivatives by the distortional fibre stretch.
struct FibreResponse {
  double psi = 0.0;                 ///< [kPa]
  double dpsi_dlambda_bar = 0.0;    ///< the nominal fibre stress [kPa]
  double d2psi_dlambda_bar2 = 0.0;  ///< [kPa]
};

/// A fibre law psi_f(lambda_bar, alpha), lambda_bar > 0, activation alpha in 0..1.
class FibreLaw {
 public:
  FibreLaw() = default;
  FibreLaw(const FibreLaw&) = delete;
  FibreLaw& operator=(const FibreLaw&) = delete;
  FibreLaw(FibreLaw&&) = delete;
  FibreLaw& operator=(FibreLaw&&) = delete;
  virtual ~FibreLaw() = default;
  [[nodiscard]] virtual FibreResponse respond(double lambda_bar, double alpha) const = 0;
};

}  // namespace facies::material
