// SPDX-License-Identifier: Apache-2.0
#include "facies/results/folder.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"

namespace facies::results {

namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 2> result_folders{"fields", "figures"};

[[noreturn]] void refuse(const fs::path& where, std::string found, std::string expected,
                         std::string hint) {
  throw UsageError({{where.string(), std::move(found), std::move(expected), std::move(hint)}});
}

[[noreturn]] void cannot(const fs::path& where, const char* do_what, const std::error_code& error) {
  refuse(where, fmt::format("cannot {}: {}", do_what, error.message()), "",
         "choose a folder that you may write to with --out");
}

/// Everything inside, as paths relative to the folder; links are not followed.
struct Content {
  std::vector<fs::path> results, foreign;
};

Content list_content(const fs::path& folder) {
  Content content;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, error);
  if (error) cannot(folder, "read the folder", error);
  for (; entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    const fs::path relative = entry->path().lexically_relative(folder);
    std::error_code unknown;  // what cannot be looked at is foreign
    const fs::file_type type = entry->symlink_status(unknown).type();
    const bool is_folder = type == fs::file_type::directory;
    if (is_folder && std::count(result_folders.begin(), result_folders.end(), relative) > 0)
      continue;
    const bool is_result =
        type == fs::file_type::regular && is_result_file(relative.generic_string());
    (is_result ? content.results : content.foreign).push_back(relative);
    if (is_folder) entry.disable_recursion_pending();
  }
  if (error) cannot(folder, "read the folder", error);
  std::sort(content.results.begin(), content.results.end());
  std::sort(content.foreign.begin(), content.foreign.end());
  return content;
}

void check_content(const fs::path& folder, const Content& content, bool force) {
  if (!content.foreign.empty()) {
    refuse(folder,
           fmt::format(
               "holds {} that facies did not write: {}{}",
               content.foreign.size() == 1 ? "something"
                                           : fmt::format("{} things", content.foreign.size()),
               content.foreign.front().generic_string(), content.foreign.size() > 1 ? ", ..." : ""),
           "an empty or new folder",
           "choose another folder with --out; facies never removes what it did not write");
  }
  if (!content.results.empty() && !force) {
    refuse(folder, "holds the results of a run", "an empty or new folder",
           "replace them with --force, or choose another folder with --out");
  }
}

/// Whether files can be made here; a folder's permissions do not tell (read-only or full disks).
void try_writing(const fs::path& folder) {
  const fs::path probe = folder / "summary.json";
  write_file(probe, "{}\n");
  std::error_code ignored;
  fs::remove(probe, ignored);
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (error) cannot(folder, "make the folder", error);
}

void make_new(const fs::path& folder, std::span<const char* const> parts) {
  const fs::path parent = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  std::error_code ignored;
  if (!fs::is_directory(parent, ignored)) {
    refuse(folder, fmt::format("cannot be made: there is no folder {}", parent.string()), "",
           fmt::format("make it first: mkdir -p '{}'", parent.string()));
  }
  make_folder(folder);
  try {
    try_writing(folder);
    for (const char* name : parts)
      make_folder(folder / name);
  } catch (...) {
    fs::remove_all(folder, ignored);  // it was made a moment ago and holds nothing else
    throw;
  }
}

/// "out/" names the same folder as "out", but has an empty last part.
fs::path without_slash(const fs::path& folder) {
  return folder.has_filename() ? folder : folder.parent_path();
}

/// Whether there is such a folder; refuses what is there and is none.
bool is_folder(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (status.type() == fs::file_type::not_found) return false;
  if (error) cannot(folder, "look at the folder", error);
  if (!fs::is_directory(status))
    refuse(folder, "is a file", "a folder", "choose another name with --out");
  return true;
}

/// Takes out what a run left, as far as that is allowed.
void empty_folder(const fs::path& folder, bool force) {
  const Content content = list_content(folder);
  check_content(folder, content, force);
  try_writing(folder);
  std::error_code error;
  for (const fs::path& file : content.results) {
    fs::remove(folder / file, error);
    if (error) cannot(folder / file, "remove the file", error);
  }
}

}  // namespace

bool is_result_file(const std::string& relative) {
  static const std::regex names(
      "(scenario\\.yaml|summary\\.json|landmarks\\.csv|distances\\.csv|tension\\.csv|motion\\.csv|"
      "energy\\.csv|(fields|motion|bones)\\.pvd|"
      "report\\.html|log\\.jsonl|"
      "convergence\\.txt|fields/([0-9]{2,}-[A-Za-z0-9_-]+|bones-fixed)\\.vtu|figures/"
      "[A-Za-z0-9_-]+\\.(png|svg))(\\.part)?");
  return std::regex_match(relative, names);
}

void prepare_folder(const fs::path& given, bool force) {
  const fs::path folder = without_slash(given);
  if (!is_folder(folder)) return make_new(folder, result_folders);
  empty_folder(folder, force);
  for (const char* name : result_folders)
    make_folder(folder / name);
}

void prepare_study_folder(const fs::path& given, bool force) {
  const fs::path folder = without_slash(given);
  if (!is_folder(folder)) return make_new(folder, {});
  std::error_code ignored;
  if (fs::is_regular_file(folder / study_file, ignored)) return try_writing(folder);
  empty_folder(folder, force);
  for (const char* name : result_folders)
    fs::remove(folder / name, ignored);
}

}  // namespace facies::results
