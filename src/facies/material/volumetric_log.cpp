// SPDX-License-Identifier: Apache-2.0
// Volumetric law of flynn2015, last term of Eqs. 1 and 2:
//
//   U = kappa/2 (ln J)^2,   dU/dJ = kappa ln J / J,   d2U/dJ2 = kappa (1 - ln J) / J^2
//
//   code    paper   unit  meaning
//   kappa   kappa   kPa   bulk modulus at rest
//   J       J       -     volume over reference volume
//
// Validity     0 < J. Infinite energy at J = 0. The tension peaks at J = e; a single element may be held beyond by those
//              around it. At J = e^2 it has fallen to three quarters of the peak: from there on tissue counts as torn
//              (docs/decisions/torn-tissue.md).
// Departures   none in the law; elements evaluate it at their mean dilatation (mechanics/solid.hpp).
// Parameters   flynn2015: 250 kPa skin (Table 1), 50 kPa hypodermis (Table 2).
#include <cmath>
#include <numbers>

#include "facies/material/catalog.hpp"

namespace facies::material {

namespace {

class VolumetricLog final : public VolumetricLaw {
 public:
  explicit VolumetricLog(double kappa) : kappa_(kappa) {}

  [[nodiscard]] VolumetricResponse respond(double J) const override {
    const double log_J = std::log(J);
    return {0.5 * kappa_ * log_J * log_J, kappa_ * log_J / J, kappa_ * (1.0 - log_J) / (J * J)};
  }

  [[nodiscard]] double tearing_J() const override { return std::numbers::e * std::numbers::e; }

 private:
  double kappa_;
};

}  // namespace

VolumetricSpec volumetric_log() {
  VolumetricSpec spec;
  spec.name = "volumetric_log";
  spec.summary = "kappa/2 (ln J)^2, refuses to collapse";
  spec.source = "Flynn et al. 2015, Eqs. 1-2";
  spec.parameters = {{"kappa", "kPa", "bulk modulus at rest", {}, 0.0, true}};
  spec.example = {{"kappa", 250.0}};
  spec.make = [](const Parameters& values) {
    return std::make_unique<const VolumetricLog>(values.at("kappa"));
  };
  return spec;
}

}  // namespace facies::material
