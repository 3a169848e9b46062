// SPDX-License-Identifier: Apache-2.0
// Where facies keeps its own tables and the scenarios and studies that ship with it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace facies::scenario {

/// The folder that holds `data` and `scenarios`: the one that the environment variable FACIES_DATA names, else the
/// nearest one above the program (a source tree, or share/facies beside an installed bin), else the source tree that
/// facies was built from. Throws UsageError where FACIES_DATA names something else, DataError where there is none.
[[nodiscard]] std::filesystem::path home_folder();

/// Tables of ours: home_folder()/data.
[[nodiscard]] std::filesystem::path data_folder();

/// Files of the scenarios that ship with facies, sorted by name.
[[nodiscard]] std::vector<std::filesystem::path> shipped_scenarios(
    const std::filesystem::path& home);

/// The file of a scenario given by path, or by the name of one that ships ("smile-open"). A word without '/' and
/// extension is a name; where both a name and such a file exist the name wins. Throws ScenarioError where there is none.
[[nodiscard]] std::filesystem::path find_scenario(const std::string& path_or_name,
                                                  const std::filesystem::path& home);

/// Files of the studies that ship with facies, sorted by name.
[[nodiscard]] std::vector<std::filesystem::path> shipped_studies(const std::filesystem::path& home);

/// The file of a study; as find_scenario.
[[nodiscard]] std::filesystem::path find_study(const std::string& path_or_name,
                                               const std::filesystem::path& home);

/// Whether a folder may be called so: 1 to 100 letters, none of them '/', '\\' or unprintable, '.' not the first.
[[nodiscard]] bool can_name_folder(const std::string& name);

}  // namespace facies::scenario
