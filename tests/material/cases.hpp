// SPDX-License-Identifier: Apache-2.0
// What the tests of laws run over: every law of the catalog with its example and with every preset that names it.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "facies/material/catalog.hpp"

namespace facies::material {

/// One law with one set of values.
template <class Spec>
struct Case {
  const Spec* spec = nullptr;
  std::string label;
  Parameters values;
};

template <class Spec>
std::ostream& operator<<(std::ostream& out, const Case<Spec>& which) {
  return out << which.label;
}

template <class Spec>
std::vector<Case<Spec>> cases_of(std::span<const Spec> specs) {
  std::vector<Case<Spec>> cases;
  for (const Spec& spec : specs) {
    cases.push_back({&spec, spec.name + "_example", with_defaults(spec.parameters, spec.example)});
    for (const Preset& preset : presets()) {
      if (preset.law != spec.name) continue;
      Parameters values = preset.values;
      values.erase("kappa");
      cases.push_back({&spec, preset.name, with_defaults(spec.parameters, values)});
    }
  }
  return cases;
}

/// The label as the name of a test.
struct LabelOf {
  template <class Info>
  std::string operator()(const Info& info) const {
    return info.param.label;
  }
};

}  // namespace facies::material
