// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <gmock/gmock.h>
#include <string>

#include "support/temporary_folder.hpp"
#include <gtest/gtest.h>

#include "facies/base/text_file.hpp"

namespace facies {
namespace {

using testing::EndsWith;
using testing::SizeIs;

class TextFiles : public ::testing::Test {
 protected:
  TextFile read(const std::string& content) {
    std::ofstream(path(), std::ios::binary) << content;
    return {path(), problems_};
  }

  [[nodiscard]] std::filesystem::path path() const { return folder_.path() / "file.txt"; }

  /// The only problem.
  [[nodiscard]] std::string told() const {
    EXPECT_THAT(problems_.list(), SizeIs(1));
    return problems_.empty() ? "" : to_string(problems_.list()[0]);
  }

  support::TemporaryFolder folder_;
  Problems problems_;
};

TEST_F(TextFiles, AreLinesWithoutTheirEnds) {
  const TextFile file = read("one\r\n\ntwo \nlast");
  ASSERT_EQ(file.n_lines(), 4U);
  EXPECT_EQ(file.line(0), "one");
  EXPECT_EQ(file.line(1), "");
  EXPECT_EQ(file.line(2), "two ");
  EXPECT_EQ(file.line(3), "last");
  EXPECT_TRUE(problems_.empty());
}

TEST_F(TextFiles, KnowWhereTheirPiecesStand) {
  const TextFile file = read("a\n  bc\n");
  EXPECT_THAT(file.where(1), EndsWith("file.txt:2"));
  EXPECT_THAT(file.where(1, file.line(1).substr(2)), EndsWith("file.txt:2:3"));
}

TEST_F(TextFiles, ThatCannotBeUsedSayWhyAndHaveNoLines) {
  EXPECT_FALSE(TextFile(path(), problems_).is_usable());
  EXPECT_THAT(told(), EndsWith("file.txt: no such file"));
  problems_ = {};
  EXPECT_FALSE(read("").is_usable());
  EXPECT_THAT(told(), EndsWith("file.txt: is empty"));
  problems_ = {};
  EXPECT_FALSE(read(std::string("ab\0", 3)).is_usable());
  EXPECT_THAT(told(), EndsWith("file.txt: is not a text file (byte 3)"));
  problems_ = {};
  EXPECT_FALSE(TextFile("/dev/zero", problems_).is_usable());
  EXPECT_EQ(told(), "/dev/zero: is no ordinary file");
}

TEST(Excerpt, ShowsTheBeginningAndNothingUnprintable) {
  EXPECT_EQ(excerpt("a\xff\x7f z"), "'a?? z'");
  EXPECT_EQ(excerpt(std::string(1000, 'x')), "'" + std::string(40, 'x') + "...'");
}

TEST(ProblemsOfOneKind, AreTenAndACount) {
  for (const std::size_t n : {1U, 10U, 11U, 1000U}) {
    ProblemsOfOneKind kind("file.txt", "bad lines");
    EXPECT_TRUE(kind.empty());
    for (std::size_t i = 0; i < n; ++i)
      kind.add({"file.txt:1", "bad", "", ""});
    EXPECT_FALSE(kind.empty());
    Problems all;
    kind.move_to(all);
    EXPECT_THAT(all.list(), SizeIs(std::min<std::size_t>(n, 11)));
    if (n > 10) {
      EXPECT_EQ(to_string(all.list().back()),
                "file.txt: " + std::to_string(n) + " bad lines in all");
    }
  }
}

}  // namespace
}  // namespace facies
