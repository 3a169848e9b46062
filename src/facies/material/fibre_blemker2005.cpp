// SPDX-License-Identifier: Apache-2.0
// Muscle fibres of flynn2015 Eqs. 4-7 (weiss1996, blemker2005), as an energy of the fibre stretch:
//
//   dpsi_f/dlambda_bar = f_p(lambda_bar) u + alpha sigma_max,   psi_f(1) = 0
//   f_p = 0                                      lambda_bar < 1
//         P1 (exp(P2 (lambda_bar - 1)) - 1)      1 <= lambda_bar < lambda_star
//         P3 lambda_bar + P4                     lambda_bar >= lambda_star,  P3, P4 from C0 and C1 continuity
//
// The paper's 2 W4 lambda_bar is this derivative, and its Eq. 4 the Cauchy stress that follows from the energy:
//   sigma = lambda_bar / J dpsi_f/dlambda_bar (a (x) a - I/3).
//
//   code         paper      unit         meaning
//   sigma_max    sigma_max  kPa          stress of full activation
//   P1, P2       P_1, P_2   1            passive stress coefficient and uncrimping factor
//   lambda_star  lambda*    -            stretch at which the passive stress becomes linear
//   lambda_bar   lambda_f   -            distortional fibre stretch (Eq. 5)
//   alpha        alpha      -            activation, 0..1
//   u            -          kPa          what f_p is measured in: 1 kPa, sigma_max or nothing (`passive`)
//
// Validity     no force-length relation: the active stress never fades with stretch or shortening. The stiffness has a
//              jump at lambda_bar = 1 where passive fibres begin to bear.
// Departures   the paper gives P1 no unit: `passive` decides. "kPa" is Eq. 6 to the letter; "sigma_max" is Blemker's
//              normalised force; "none" is what the public code amounts to (its P1 is 5e-8 kPa, and its passive stress
//              has a further factor 1 / lambda_bar and no cut at 1).
// Parameters   flynn2015 Table 4; the passive ones from the biceps brachii (blemker2005).
#include <cmath>

#include "facies/material/catalog.hpp"

namespace facies::material {

namespace {

/// f_p, its integral from 1 and its slope, all in the unit u of the file head.
struct Passive {
  double integral = 0.0, value = 0.0, slope = 0.0;
};

class FibreBlemker2005 final : public FibreLaw {
 public:
  FibreBlemker2005(const Parameters& values, const std::string& passive)
      : sigma_max_(values.at("sigma_max")),
        P1_(values.at("P1")),
        P2_(values.at("P2")),
        lambda_star_(values.at("lambda_star")),
        unit_(passive == "none" ? 0.0 : (passive == "sigma_max" ? sigma_max_ : 1.0)) {}

  [[nodiscard]] FibreResponse respond(double lambda_bar, double alpha) const override {
    const Passive p = passive(lambda_bar);
    const double active = alpha * sigma_max_;
    return {unit_ * p.integral + active * (lambda_bar - 1.0), unit_ * p.value + active,
            unit_ * p.slope};
  }

 private:
  [[nodiscard]] Passive passive(double lambda_bar) const {
    if (lambda_bar < 1.0) return {};
    if (lambda_bar < lambda_star_) return toe(lambda_bar);
    // The linear part runs on from lambda_star with P3 = slope and P4 = value - slope lambda_star (C0, C1).
    const Passive star = toe(lambda_star_);
    const double beyond = lambda_bar - lambda_star_;
    return {star.integral + beyond * (star.value + 0.5 * star.slope * beyond),
            star.value + star.slope * beyond, star.slope};
  }

  [[nodiscard]] Passive toe(double lambda_bar) const {
    const double x = lambda_bar - 1.0;
    const double grown = std::expm1(P2_ * x);
    return {P1_ * (grown / P2_ - x), P1_ * grown, P1_ * P2_ * (grown + 1.0)};
  }

  double sigma_max_, P1_, P2_, lambda_star_;
  double unit_;  ///< [kPa]
};

}  // namespace

FibreSpec fibre_blemker2005() {
  FibreSpec spec;
  spec.name = "fibre_blemker2005";
  spec.summary =
      "muscle fibres: active stress proportional to activation, passive stress with a toe";
  spec.source = "Flynn et al. 2015, Eqs. 4-7; Weiss et al. 1996; Blemker et al. 2005";
  spec.parameters = {
      {"sigma_max", "kPa", "stress of full activation", {}},
      {"P1", "", "passive stress coefficient, in what `passive` says", {}},
      {"P2", "", "uncrimping factor: how fast the passive stress grows", {}, 0.0, true},
      {"lambda_star", "", "stretch at which the passive stress becomes linear", {}, 1.0, true},
  };
  spec.passive_choices = {"kPa", "sigma_max", "none"};
  spec.example = {{"sigma_max", 100.0}, {"P1", 0.05}, {"P2", 6.6}, {"lambda_star", 1.4}};
  spec.make = [](const Parameters& values, const std::string& passive) {
    return std::make_unique<const FibreBlemker2005>(values, passive);
  };
  return spec;
}

}  // namespace facies::material
