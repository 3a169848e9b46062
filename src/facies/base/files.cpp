// SPDX-License-Identifier: Apache-2.0
#include "facies/base/files.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <unistd.h>

#include "facies/base/error.hpp"

namespace facies {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const fs::path& path, int error) {
  throw UsageError(
      {{path.string(), std::string("cannot write: ") + std::strerror(error), "",
        error == ENOSPC ? "free some space on that disk or choose another folder with --out"
                        : "choose a folder that you may write to with --out"}});
}

/// Writes everything or returns the errno of what went wrong.
int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      return errno;
    }
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(descriptor) == 0 || errno == EINVAL ? 0 : errno;
}

}  // namespace

std::string read_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw DataError({{path.string(), "is a folder", "a file", ""}});
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw DataError(
        {{path.string(), fs::exists(path, ignored) ? "cannot be read" : "no such file", "", ""}});
  }
  std::ostringstream content;
  content << file.rdbuf();
  if (file.bad()) throw DataError({{path.string(), "cannot be read to its end", "", ""}});
  return std::move(content).str();
}

void write_file(const fs::path& path, std::string_view content) {
  fs::path temporary = path;
  temporary += ".part";
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) cannot_write(path, errno);
  int error = write_all(descriptor, content);
  if (::close(descriptor) != 0 && error == 0) error = errno;
  if (error == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(temporary.c_str());
    cannot_write(path, error);
  }
}

}  // namespace facies
