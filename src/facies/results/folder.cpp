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
#include "facies/results/atlas.hpp"

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

/// What a command leaves in its folder.
struct Kind {
  const char* writer;                    ///< "facies"
  const char* what;                      ///< "the results of a run"
  bool (*is_own)(const std::string&);    ///< a file, relative to the folder
  std::span<const char* const> folders;  ///< in it
};

bool is_picture_file(const std::string& relative) {
  return std::ranges::any_of(atlas_files(), [&](const std::string& name) {
    return relative == name || relative == name + ".part";
  });
}

const Kind run_results{"facies", "the results of a run", is_result_file, result_folders};
const Kind face_pictures{"facies info", "pictures of a face", is_picture_file, {}};

/// Everything inside, as paths relative to the folder; links are not followed.
struct Content {
  std::vector<fs::path> results, foreign;
};

Content list_content(const fs::path& folder, const Kind& kind) {
  Content content;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, error);
  if (error) cannot(folder, "read the folder", error);
  for (; entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    const fs::path relative = entry->path().lexically_relative(folder);
    std::error_code unknown;  // what cannot be looked at is foreign
    const fs::file_type type = entry->symlink_status(unknown).type();
    const bool is_folder = type == fs::file_type::directory;
    if (is_folder && std::count(kind.folders.begin(), kind.folders.end(), relative) > 0) continue;
    const bool is_result = type == fs::file_type::regular && kind.is_own(relative.generic_string());
    (is_result ? content.results : content.foreign).push_back(relative);
    if (is_folder) entry.disable_recursion_pending();
  }
  if (error) cannot(folder, "read the folder", error);
  std::sort(content.results.begin(), content.results.end());
  std::sort(content.foreign.begin(), content.foreign.end());
  return content;
}

void check_content(const fs::path& folder, const Content& content, const Kind& kind, bool force) {
  if (!content.foreign.empty()) {
    refuse(
        folder,
        fmt::format("holds {} that {} did not write: {}{}",
                    content.foreign.size() == 1 ? "something"
                                                : fmt::format("{} things", content.foreign.size()),
                    kind.writer, content.foreign.front().generic_string(),
                    content.foreign.size() > 1 ? ", ..." : ""),
        "an empty or new folder",
        fmt::format("choose another folder with --out; {} never removes what it did not write",
                    kind.writer));
  }
  if (!content.results.empty() && !force) {
    refuse(folder, fmt::format("holds {}", kind.what), "an empty or new folder",
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

/// Takes out what is of this kind, as far as that is allowed.
void empty_folder(const fs::path& folder, const Kind& kind, bool force) {
  const Content content = list_content(folder, kind);
  check_content(folder, content, kind, force);
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

namespace {

void prepare(const fs::path& given, const Kind& kind, bool force) {
  const fs::path folder = without_slash(given);
  if (!is_folder(folder)) return make_new(folder, kind.folders);
  empty_folder(folder, kind, force);
  for (const char* name : kind.folders)
    make_folder(folder / name);
}

}  // namespace

void prepare_folder(const fs::path& folder, bool force) {
  prepare(folder, run_results, force);
}

void prepare_picture_folder(const fs::path& folder, bool force) {
  prepare(folder, face_pictures, force);
}

void prepare_study_folder(const fs::path& given, bool force) {
  const fs::path folder = without_slash(given);
  if (!is_folder(folder)) return make_new(folder, {});
  std::error_code ignored;
  if (fs::is_regular_file(folder / study_file, ignored)) return try_writing(folder);
  empty_folder(folder, run_results, force);
  for (const char* name : result_folders)
    fs::remove(folder / name, ignored);
}

}  // namespace facies::results
