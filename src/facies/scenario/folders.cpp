// SPDX-License-Identifier: Apache-2.0
#include "facies/scenario/folders.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "facies/base/error.hpp"
#include "facies/base/text.hpp"

namespace facies::scenario {

namespace {

namespace fs = std::filesystem;

bool is_home(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(folder / "data", ignored) &&
         fs::is_directory(folder / "scenarios", ignored);
}

/// The nearest home above the running program; empty where there is none.
fs::path home_above_program() {
  std::error_code failure;
  fs::path folder = fs::read_symlink("/proc/self/exe", failure).parent_path();
  while (!failure && !folder.empty()) {
    for (const fs::path& candidate : {folder / "share" / "facies", folder}) {
      if (is_home(candidate)) return candidate;
    }
    if (folder == folder.root_path()) break;
    folder = folder.parent_path();
  }
  return {};
}

}  // namespace

fs::path home_folder() {
  if (const char* named = std::getenv("FACIES_DATA"); named != nullptr && *named != '\0') {
    if (is_home(named)) return named;
    throw UsageError(
        {{fmt::format("FACIES_DATA={}", named), "no folder with 'data' and 'scenarios' in it", "",
          "unset FACIES_DATA, or let it name the source tree or share/facies"}});
  }
  if (fs::path above = home_above_program(); !above.empty()) return above;
  if (is_home(FACIES_SOURCE_TREE)) return FACIES_SOURCE_TREE;
  throw DataError({{"facies", "the folders 'data' and 'scenarios' are not to be found", "",
                    "let the environment variable FACIES_DATA name the folder that holds them"}});
}

fs::path data_folder() {
  return home_folder() / "data";
}

std::vector<fs::path> shipped_scenarios(const fs::path& home) {
  std::vector<fs::path> files;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(home / "scenarios", failure)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

fs::path find_scenario(const std::string& path_or_name, const fs::path& home) {
  std::vector<std::string> names;
  for (const fs::path& file : shipped_scenarios(home)) {
    names.push_back(file.stem().string());
    if (names.back() == path_or_name) return file;
  }
  std::error_code ignored;
  if (!path_or_name.empty() && fs::exists(path_or_name, ignored)) return path_or_name;
  const bool is_path =
      path_or_name.find('/') != std::string::npos || fs::path(path_or_name).has_extension();
  throw ScenarioError(
      {{path_or_name.empty() ? "''" : path_or_name,
        is_path ? "no such file" : "no such file, and no scenario of that name ships", "",
        did_you_mean(fs::path(path_or_name).stem().string(), names)}});
}

}  // namespace facies::scenario
