// SPDX-License-Identifier: Apache-2.0
// The projection onto distortional strains, holzapfel2000 Eqs. 6.90 and 6.168-6.172.
#include "facies/material/tissue.hpp"

namespace facies::material {

namespace {

/// J^(-2/3) of C = F^T F.
double distortional_factor(const Sym3<double>& C) {
  return 1.0 / std::cbrt(determinant(C));
}

double fibre_stretch(const Sym3<double>& C_bar, const Sym3<double>& A0) {
  return std::sqrt(double_dot(C_bar, A0));
}

/// What a fibre adds per volume of tissue.
FibreResponse respond(const Fibre& fibre, double lambda_bar) {
  FibreResponse f = fibre.law->respond(lambda_bar, fibre.alpha);
  f.psi *= fibre.share;
  f.dpsi_dlambda_bar *= fibre.share;
  f.d2psi_dlambda_bar2 *= fibre.share;
  return f;
}

/// Adds psi_f(lambda_bar) with lambda_bar^2 = C_bar : a0 (x) a0 and its derivatives by C_bar.
void add_fibre(const Fibre& fibre, const Sym3<double>& C_bar, LawResponse& sum) {
  const Sym3<double> A0 = dyad(fibre.a0);
  const double lambda_bar = fibre_stretch(C_bar, A0);
  const FibreResponse f = respond(fibre, lambda_bar);
  const double stress = f.dpsi_dlambda_bar / lambda_bar;
  const double stiffness = (f.d2psi_dlambda_bar2 - stress) / (lambda_bar * lambda_bar);
  const StressVoigt A0_voigt = stress_voigt(A0);
  sum.psi += f.psi;
  sum.S_bar += stress * A0_voigt;
  sum.C4_bar += (stiffness * A0_voigt) * A0_voigt.transpose();
}

}  // namespace

double distortional_energy(const Law& law, std::span<const Fibre> fibres, const Sym3<double>& C) {
  const Sym3<double> C_bar = scaled(C, distortional_factor(C));
  double psi = law.energy(C_bar);
  for (const Fibre& fibre : fibres) {
    psi += respond(fibre, fibre_stretch(C_bar, dyad(fibre.a0))).psi;
  }
  return psi;
}

StressVoigt distortional_stress(const Law& law, std::span<const Fibre> fibres,
                                const Sym3<double>& C) {
  const double g = distortional_factor(C);
  const Sym3<double> C_bar = scaled(C, g);
  StressVoigt S_bar = law.stress(C_bar);
  for (const Fibre& fibre : fibres) {
    const Sym3<double> A0 = dyad(fibre.a0);
    const double lambda_bar = fibre_stretch(C_bar, A0);
    S_bar += (respond(fibre, lambda_bar).dpsi_dlambda_bar / lambda_bar) * stress_voigt(A0);
  }
  return g * (S_bar - (S_bar.dot(strain_voigt(C)) / 3.0) * stress_voigt(inverse(C)));
}

Response distortional_response(const Law& law, std::span<const Fibre> fibres,
                               const Sym3<double>& C) {
  const double g = distortional_factor(C);
  const Sym3<double> C_bar = scaled(C, g);
  LawResponse bar = law.respond(C_bar);
  for (const Fibre& fibre : fibres)
    add_fibre(fibre, C_bar, bar);

  // With P = I - 1/3 C^-1 (x) C:  S = g P:S_bar  and
  // C4 = g^2 P:C4_bar:P^T + 2/3 t (C^-1 (.) C^-1 - 1/3 C^-1 (x) C^-1) - 2/3 (C^-1 (x) S + S (x) C^-1),  t = g S_bar:C.
  // Everything but C4_bar and C^-1 (.) C^-1 is C^-1 (x) w + w (x) C^-1 with one vector w.
  const Sym3<double> C_inv = inverse(C);
  const StressVoigt p = stress_voigt(C_inv);
  const StrainVoigt C_strain = strain_voigt(C);
  const double t = g * bar.S_bar.dot(C_strain);

  Response response;
  response.psi = bar.psi;
  response.S = g * bar.S_bar - (t / 3.0) * p;
  response.C4 = (g * g) * bar.C4_bar;
  const StressVoigt C4_C = response.C4 * C_strain;
  const StressVoigt w =
      (C_strain.dot(C4_C) / 18.0 - t / 9.0) * p - C4_C / 3.0 - (2.0 / 3.0) * response.S;
  response.C4 += (2.0 / 3.0 * t) * symmetric_square(C_inv) + p * w.transpose() + w * p.transpose();
  return response;
}

Response volumetric_response(const VolumetricLaw& law, const Sym3<double>& C) {
  const double J = std::sqrt(determinant(C));
  const VolumetricResponse v = law.respond(J);
  const Sym3<double> C_inv = inverse(C);
  const StressVoigt p = stress_voigt(C_inv);
  const double JU = J * v.dU_dJ;
  Response response;
  response.psi = v.U;
  response.S = JU * p;
  response.C4 = (JU + J * J * v.d2U_dJ2) * p * p.transpose() - (2.0 * JU) * symmetric_square(C_inv);
  return response;
}

}  // namespace facies::material
