// SPDX-License-Identifier: Apache-2.0
// Runs the built program and catches what it says.
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "facies/base/files.hpp"

namespace facies::cli {

struct Outcome {
  int status = -1;  ///< exit status
  std::string out;
  std::string err;
};

/// A folder of this test alone, removed at its end.
class ProgramTest : public testing::Test {
 protected:
  ProgramTest()
      : folder_(std::filesystem::path(testing::TempDir()) /
                ("facies-" + std::to_string(::getpid()) + "-" +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::create_directories(folder_);
  }
  ~ProgramTest() override { std::filesystem::remove_all(folder_); }

  /// `facies ARGUMENTS` in the folder of this test; the arguments are words of a shell. `before` stands in front.
  [[nodiscard]] Outcome facies(const std::string& arguments, const std::string& before = "") const {
    const std::string command = "cd '" + folder_.string() + "' && " + before +
                                " '" FACIES_PROGRAM "' " + arguments +
                                " >out.txt 2>err.txt </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder_ / "out.txt"),
            read_file(folder_ / "err.txt")};
  }

  void write(const std::string& name, const std::string& text) const {
    write_file(folder_ / name, text);
  }

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace facies::cli
