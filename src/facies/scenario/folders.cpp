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

/// The files "*.yaml" of a folder, sorted; none where there is no such folder.
std::vector<fs::path> yaml_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The file among `shipped` with that name, else the file at that path. `what` is what ships: "scenario".
fs::path find(const std::string& path_or_name, const std::vector<fs::path>& shipped,
              const std::string& what) {
  std::vector<std::string> names;
  for (const fs::path& file : shipped) {
    names.push_back(file.stem().string());
    if (names.back() == path_or_name) return file;
  }
  std::error_code ignored;
  if (!path_or_name.empty() && fs::exists(path_or_name, ignored)) return path_or_name;
  const bool is_path =
      path_or_name.find('/') != std::string::npos || fs::path(path_or_name).has_extension();
  throw ScenarioError(
      {{path_or_name.empty() ? "''" : path_or_name,
        is_path ? "no such file" : fmt::format("no such file, and no {} of that name ships", what),
        "", did_you_mean(fs::path(path_or_name).stem().string(), names)}});
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
  return yaml_files(home / "scenarios");
}

std::vector<fs::path> shipped_studies(const fs::path& home) {
  return yaml_files(home / "studies");
}

fs::path find_scenario(const std::string& path_or_name, const fs::path& home) {
  return find(path_or_name, shipped_scenarios(home), "scenario");
}

fs::path find_study(const std::string& path_or_name, const fs::path& home) {
  return find(path_or_name, shipped_studies(home), "study");
}

bool can_name_folder(const std::string& name) {
  return !name.empty() && name.size() <= 100 && name.front() != '.' &&
         std::all_of(name.begin(), name.end(), [](unsigned char letter) {
           return letter >= 0x20 && letter != 0x7f && letter != '/' && letter != '\\';
         });
}

}  // namespace facies::scenario
