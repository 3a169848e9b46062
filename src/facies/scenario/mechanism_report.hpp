// SPDX-License-Identifier: Apache-2.0
// From the jaw and the contacts of a model to plain data for reports.
#pragma once

#include <optional>

#include "facies/results/mechanism.hpp"
#include "facies/scenario/build_model.hpp"

namespace facies::scenario {

/// The jaw at a state; nothing where the model has none.
[[nodiscard]] std::optional<results::JawMeasure> measure_jaw(const FaceModel& model,
                                                             const mechanics::State& state);

/// Every contact of the model at a state.
[[nodiscard]] std::vector<results::ContactMeasure> measure_contacts(const FaceModel& model,
                                                                    const mechanics::State& state);

/// How the jaw settled; nothing where the model has none.
[[nodiscard]] std::optional<results::SettlingMeasure> measure_settling(const FaceModel& model);

}  // namespace facies::scenario
