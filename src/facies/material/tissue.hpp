// SPDX-License-Identifier: Apache-2.0
// The distortional response of a tissue: a matrix law plus any number of fibre families, projected once.
#pragma once

#include <span>

#include "facies/material/law.hpp"

namespace facies::material {

/// One fibre family at a point: its law, unit reference direction, activation (0..1), and how much of the volume there is fibre.
struct Fibre {
  const FibreLaw* law = nullptr;
  Vec3 a0 = Vec3::UnitX();
  double alpha = 0.0;
  double share = 1.0;
};

/// Second Piola-Kirchhoff stress and its tangent.
struct Response {
  double psi = 0.0;  ///< [kPa]
  StressVoigt S;     ///< 2 dpsi/dC [kPa]
  Mat6 C4;           ///< 2 dS/dC = dS/dE [kPa]
};

/// psi(C_bar) + sum share psi_f of the distortional part of C [kPa].
[[nodiscard]] double distortional_energy(const Law& law, std::span<const Fibre> fibres,
                                         const Sym3<double>& C);

/// Its S and C4 with respect to C (holzapfel2000 Eqs. 6.90 and 6.168). C symmetric positive definite.
[[nodiscard]] Response distortional_response(const Law& law, std::span<const Fibre> fibres,
                                             const Sym3<double>& C);

/// S alone: what a residual needs, cheaper than distortional_response.
[[nodiscard]] StressVoigt distortional_stress(const Law& law, std::span<const Fibre> fibres,
                                              const Sym3<double>& C);

/// S = dU/dJ J C^-1 and its tangent for a volumetric law evaluated pointwise. For single-point drivers and tests:
/// elements use the mean dilatation instead (mechanics/solid.hpp).
[[nodiscard]] Response volumetric_response(const VolumetricLaw& law, const Sym3<double>& C);

}  // namespace facies::material
