// SPDX-License-Identifier: Apache-2.0
// Volumetric law of the authors' public ArtiSynth code (not of the paper):
//
//   U = kappa/2 (J - 1)^2,   dU/dJ = kappa (J - 1),   d2U/dJ2 = kappa
//
//   code    paper   unit  meaning
//   kappa   kappa   kPa   bulk modulus at rest
//   J       J       -     volume over reference volume
//
// Validity     near J = 1; stable at any expansion, but only finite energy stands against J = 0.
// Departures   from flynn2015 Eqs. 1-2: there kappa/2 (ln J)^2 (volumetric_log). The public code also enforces
//              J = 1 for each element as a constraint, which makes kappa nearly irrelevant; this law does not.
// Parameters   as for volumetric_log.
#include "facies/material/catalog.hpp"

namespace facies::material {

namespace {

class VolumetricQuadratic final : public VolumetricLaw {
 public:
  explicit VolumetricQuadratic(double kappa) : kappa_(kappa) {}

  [[nodiscard]] VolumetricResponse respond(double J) const override {
    return {0.5 * kappa_ * (J - 1.0) * (J - 1.0), kappa_ * (J - 1.0), kappa_};
  }

 private:
  double kappa_;
};

}  // namespace

VolumetricSpec volumetric_quadratic() {
  VolumetricSpec spec;
  spec.name = "volumetric_quadratic";
  spec.summary = "kappa/2 (J - 1)^2, as in the authors' public code";
  spec.source = "artisynth_models, badinface demo";
  spec.parameters = {{"kappa", "kPa", "bulk modulus at rest", {}, 0.0, true}};
  spec.example = {{"kappa", 250.0}};
  spec.make = [](const Parameters& values) {
    return std::make_unique<const VolumetricQuadratic>(values.at("kappa"));
  };
  return spec;
}

}  // namespace facies::material
