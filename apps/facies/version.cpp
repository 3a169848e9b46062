// SPDX-License-Identifier: Apache-2.0
#include "apps/facies/version.hpp"

#include <Eigen/Core>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "facies/solve/session.hpp"

namespace facies::cli {

std::string version() {
  return FACIES_VERSION;
}

std::vector<std::pair<std::string, std::string>> built_with() {
  return {
      {"compiler", FACIES_COMPILER ", " FACIES_BUILD_TYPE},
      {"solver", solve::solver_versions()},
      {"Eigen",
       fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"yaml-cpp", FACIES_YAML_CPP},
      {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                    NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
      {"fmt",
       fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"Embree", FACIES_EMBREE},
      {"cairo", FACIES_CAIRO},
  };
}

}  // namespace facies::cli
