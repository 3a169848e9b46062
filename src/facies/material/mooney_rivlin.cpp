// SPDX-License-Identifier: Apache-2.0
// Mooney-Rivlin (reduced polynomial) tissue, flynn2015 Eq. 1, distortional part:
//
//   psi = C10 (I1_bar - 3) + C01 (I2_bar - 3) + C20 (I1_bar - 3)^2
//   I1_bar = tr C_bar,   I2_bar = (tr^2 C_bar - tr C_bar^2) / 2
//
//   code    paper   unit  meaning
//   C10     C_10    kPa   half of the initial shear modulus (with C01)
//   C01     -       kPa   term of the second invariant
//   C20     C_20    kPa   stiffening
//   I1_bar  I~_1    -     first invariant of the distortional tensor (the same for B~ and C_bar)
//
// Validity     any stretch; polyconvex for the admitted (non-negative) parameters. Shear modulus at rest 2 (C10 + C01).
// Departures   the paper's law has no C01; it is here because the name promises it, and 0 unless given.
//              The paper's kappa/2 (ln J)^2 is volumetric_log.
// Parameters   hypodermis: flynn2015 Table 2 (suction on facial skin, barbarino2011);
//              isotropic skin: nazari2010 as quoted in Table 1. See presets.cpp.
#include "facies/material/catalog.hpp"

namespace facies::material {

namespace {

class MooneyRivlin final : public Law {
 public:
  MooneyRivlin(double C10, double C01, double C20) : C10_(C10), C01_(C01), C20_(C20) {}

  [[nodiscard]] double energy(const Sym3<double>& C_bar) const override { return psi(C_bar); }
  [[nodiscard]] Dual2<6> energy(const Sym3<Dual2<6>>& C_bar) const override { return psi(C_bar); }

  [[nodiscard]] LawResponse respond(const Sym3<double>& C_bar) const override {
    LawResponse response;
    response.psi = psi(C_bar);
    response.S_bar = stress(C_bar);
    response.C4_bar = (-4.0 * C01_) * symmetric_identity();
    response.C4_bar.topLeftCorner<3, 3>().array() += 8.0 * C20_ + 4.0 * C01_;
    return response;
  }

  [[nodiscard]] StressVoigt stress(const Sym3<double>& C_bar) const override {
    const double I1_bar = trace(C_bar);
    const double dpsi_dI1 = C10_ + 2.0 * C20_ * (I1_bar - 3.0);
    return 2.0 * (dpsi_dI1 + C01_ * I1_bar) * identity_voigt() - (2.0 * C01_) * stress_voigt(C_bar);
  }

 private:
  template <class T>
  [[nodiscard]] T psi(const Sym3<T>& C_bar) const {
    const T I1_bar = trace(C_bar);
    const T I2_bar = 0.5 * (I1_bar * I1_bar - double_dot(C_bar, C_bar));
    const T x = I1_bar - 3.0;
    return C10_ * x + C01_ * (I2_bar - 3.0) + C20_ * x * x;
  }

  double C10_, C01_, C20_;
};

}  // namespace

LawSpec mooney_rivlin() {
  LawSpec spec;
  spec.name = "mooney_rivlin";
  spec.summary = "isotropic tissue, polynomial in the invariants of the distortional strain";
  spec.source = "Flynn et al. 2015, Eq. 1";
  spec.parameters = {
      {"C10",
       "kPa",
       "coefficient of I1_bar - 3; the shear modulus at rest is 2 (C10 + C01)",
       {},
       0.0,
       true},
      {"C01", "kPa", "coefficient of I2_bar - 3", 0.0},
      {"C20", "kPa", "coefficient of (I1_bar - 3)^2: stiffening", 0.0},
  };
  spec.example = {{"C10", 0.4}, {"C01", 0.15}, {"C20", 1.4}};
  spec.make = [](const Parameters& values, const Mat3& /*axes*/) {
    return std::make_unique<const MooneyRivlin>(values.at("C10"), values.at("C01"),
                                                values.at("C20"));
  };
  return spec;
}

}  // namespace facies::material
