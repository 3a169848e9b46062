// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"

namespace facies {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, gone afterwards.
class Files : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "facies-test-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

TEST_F(Files, ComeBackAsTheyWereWritten) {
  const std::string content("two\nlines\r\nand a \0 byte", 23);
  write_file(folder_ / "a.txt", content);
  EXPECT_EQ(read_file(folder_ / "a.txt"), content);
}

TEST_F(Files, MayBeEmpty) {
  write_file(folder_ / "empty", "");
  EXPECT_EQ(read_file(folder_ / "empty"), "");
}

TEST_F(Files, AreReplacedAsAWholeAndLeaveNothingBeside) {
  write_file(folder_ / "a.txt", std::string(100000, 'x'));
  write_file(folder_ / "a.txt", "short");
  EXPECT_EQ(read_file(folder_ / "a.txt"), "short");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(Files, CannotBeWrittenBelowAFile) {
  write_file(folder_ / "file", "content");
  try {
    write_file(folder_ / "file" / "below.txt", "x");
    FAIL() << "nothing was thrown";
  } catch (const UsageError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("below.txt: cannot write"), std::string::npos) << message;
    EXPECT_NE(message.find("--out"), std::string::npos) << message;
  }
  EXPECT_EQ(read_file(folder_ / "file"), "content");
}

TEST_F(Files, CannotBeWrittenWhereAFolderStands) {
  fs::create_directory(folder_ / "taken");
  write_file(folder_ / "taken" / "inside", "content");
  EXPECT_THROW(write_file(folder_ / "taken", "x"), UsageError);
  EXPECT_EQ(read_file(folder_ / "taken" / "inside"), "content");
  EXPECT_EQ(entries(), 1U) << "a temporary file was left behind";
}

TEST_F(Files, ThatDoNotExistAreNamed) {
  try {
    (void)read_file(folder_ / "missing.node");
    FAIL() << "nothing was thrown";
  } catch (const DataError& error) {
    EXPECT_EQ(std::string(error.what()), (folder_ / "missing.node").string() + ": no such file");
  }
}

TEST_F(Files, AreNotFolders) {
  EXPECT_THROW((void)read_file(folder_), DataError);
}

}  // namespace
}  // namespace facies
