// SPDX-License-Identifier: Apache-2.0
#include <functional>
#include <gmock/gmock.h>
#include <sys/mount.h>
#include <unistd.h>

#include "results/cases.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"
#include "facies/results/folder.hpp"

namespace facies::results {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// What the refusal says; fails the test if there is none.
std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const UsageError& error) {
    return error.what();
  }
  ADD_FAILURE() << "was not refused";
  return "";
}

class Folder : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    out_ = folder_ / "out";
  }
  /// A folder as a run leaves it.
  void fill() const {
    prepare_folder(out_, false);
    write_file(out_ / "summary.json", "{}");
    write_file(out_ / "fields" / "01-tension.vtu", "x");
    write_file(out_ / "figures" / "rest.png", "x");
    write_file(out_ / "fields.pvd.part", "killed while writing");
  }
  [[nodiscard]] static std::size_t n_files(const fs::path& where) {
    std::size_t n = 0;
    for (const auto& entry : fs::recursive_directory_iterator(where))
      n += entry.is_directory() ? 0U : 1U;
    return n;
  }

  fs::path out_;
};

TEST_F(Folder, IsMadeWithItsPartsAndNothingElse) {
  prepare_folder(out_, false);
  EXPECT_TRUE(fs::is_directory(out_ / "fields"));
  EXPECT_TRUE(fs::is_directory(out_ / "figures"));
  EXPECT_EQ(n_files(out_), 0U);
}

TEST_F(Folder, MayExistWhenItIsEmptyOrHasATrailingSlash) {
  fs::create_directory(out_);
  prepare_folder(out_, false);
  EXPECT_TRUE(fs::is_directory(out_ / "fields"));
  prepare_folder(folder_ / "other/", false);
  EXPECT_TRUE(fs::is_directory(folder_ / "other" / "fields"));
}

TEST_F(Folder, WithResultsIsKeptUnlessForced) {
  fill();
  EXPECT_THAT(refusal([&] { prepare_folder(out_, false); }), HasSubstr("--force"));
  EXPECT_EQ(n_files(out_), 4U);
  prepare_folder(out_, true);
  EXPECT_EQ(n_files(out_), 0U);
  EXPECT_TRUE(fs::is_directory(out_ / "figures"));
}

TEST_F(Folder, WithForeignThingsIsNeverTouched) {
  fill();
  write_file(out_ / "thesis.tex", "years of work");
  for (const bool force : {false, true}) {
    const std::string text = refusal([&] { prepare_folder(out_, force); });
    EXPECT_THAT(text, HasSubstr("thesis.tex"));
    EXPECT_EQ(n_files(out_), 5U);
  }
}

TEST_F(Folder, TakesFoldersAndLinksInsideForForeign) {
  fill();
  fs::create_directories(out_ / "fields" / "mine");
  EXPECT_THAT(refusal([&] { prepare_folder(out_, true); }), HasSubstr("fields/mine"));
  fs::remove(out_ / "fields" / "mine");
  write_file(folder_ / "elsewhere.csv", "x");
  fs::create_symlink(folder_ / "elsewhere.csv", out_ / "landmarks.csv");
  EXPECT_THAT(refusal([&] { prepare_folder(out_, true); }), HasSubstr("landmarks.csv"));
  fs::remove(out_ / "landmarks.csv");
  fs::remove_all(out_ / "fields");
  fs::create_directory_symlink(folder_, out_ / "fields");
  EXPECT_THAT(refusal([&] { prepare_folder(out_, true); }), HasSubstr("fields"));
  EXPECT_TRUE(fs::exists(folder_ / "elsewhere.csv"));
}

TEST_F(Folder, OfPicturesOfAFaceHoldsNothingElse) {
  prepare_picture_folder(out_, false);
  EXPECT_TRUE(fs::is_empty(out_));
  prepare_picture_folder(out_, false);
  write_file(out_ / "bones.png", "x");
  write_file(out_ / "skin.png.part", "killed while writing");
  EXPECT_THAT(refusal([&] { prepare_picture_folder(out_, false); }),
              HasSubstr("holds pictures of a face; expected an empty or new folder"));
  EXPECT_EQ(n_files(out_), 2U);
  prepare_picture_folder(out_, true);
  EXPECT_TRUE(fs::is_empty(out_));
  write_file(out_ / "holiday.png", "x");
  EXPECT_THAT(refusal([&] { prepare_picture_folder(out_, true); }),
              HasSubstr("something that facies info did not write: holiday.png"));
  EXPECT_EQ(n_files(out_), 1U);
}

TEST_F(Folder, OfARunIsNoneForPictures) {
  fill();
  EXPECT_THAT(refusal([&] { prepare_picture_folder(out_, true); }),
              HasSubstr("that facies info did not write"));
  EXPECT_EQ(n_files(out_), 4U);
}

TEST_F(Folder, IsNotAFile) {
  write_file(out_, "x");
  EXPECT_THAT(refusal([&] { prepare_folder(out_, true); }), HasSubstr("is a file"));
  EXPECT_EQ(read_file(out_), "x");
  EXPECT_THAT(refusal([&] { prepare_folder(out_ / "below", true); }), HasSubstr("below"));
}

TEST_F(Folder, NeedsAFolderToStandIn) {
  const std::string text = refusal([&] { prepare_folder(folder_ / "a" / "b", false); });
  EXPECT_THAT(text, HasSubstr("there is no folder"));
  EXPECT_THAT(text, HasSubstr("mkdir -p"));
  EXPECT_FALSE(fs::exists(folder_ / "a"));
}

TEST_F(Folder, MustBeWritable) {
  fs::create_directory(out_);
  fs::permissions(folder_, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                               fs::perms::others_read | fs::perms::others_exec);
  fs::permissions(out_, fs::perms::owner_read | fs::perms::owner_exec | fs::perms::group_read |
                            fs::perms::group_exec | fs::perms::others_read |
                            fs::perms::others_exec);
  const uid_t user = geteuid();
  constexpr uid_t nobody = 65534;
  if (user == 0) {
    ASSERT_EQ(seteuid(nobody), 0) << "root may write everywhere, so another user has to try";
  }
  const std::string inside = refusal([&] { prepare_folder(out_, false); });
  const std::string below = refusal([&] { prepare_folder(out_ / "below", false); });
  ASSERT_EQ(seteuid(user), 0);
  EXPECT_THAT(inside, HasSubstr("cannot write"));
  EXPECT_THAT(below, HasSubstr("cannot make the folder"));
  fs::permissions(out_, fs::perms::owner_all);
}

TEST_F(Folder, OnAFullDiskIsRefusedAndLeftAsItWas) {
  const fs::path disk = folder_ / "disk";
  fs::create_directory(disk);
  if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=32k") != 0)
    GTEST_SKIP() << "cannot mount a small disk here";
  fs::create_directory(disk / "old");
  try {
    for (int i = 0; i < 100; ++i)
      write_file(disk / ("fill" + std::to_string(i)), std::string(4096, 'x'));
    ADD_FAILURE() << "the disk did not fill up";
  } catch (const UsageError&) {
    EXPECT_THAT(refusal([&] { prepare_folder(disk / "old", false); }),
                HasSubstr("free some space"));
    EXPECT_THAT(refusal([&] { prepare_folder(disk / "new", false); }),
                HasSubstr("free some space"));
    EXPECT_TRUE(fs::is_empty(disk / "old"));
    EXPECT_FALSE(fs::exists(disk / "new"));
  }
  EXPECT_EQ(::umount(disk.c_str()), 0);
}

TEST(ResultFile, IsKnownByItsName) {
  for (const char* name :
       {"scenario.yaml", "summary.json", "landmarks.csv", "fields.pvd", "motion.pvd", "motion.csv",
        "energy.csv", "fields/12-open_jaw.vtu", "figures/overview.png", "figures/plot-2.svg",
        "log.jsonl", "convergence.txt", "report.html", "summary.json.part"}) {
    EXPECT_TRUE(is_result_file(name)) << name;
  }
  for (const char* name :
       {"", "summary.json~", "notes.csv", "fields/mine.vtu", "figures/deep/rest.png",
        "xsummary.json", "fields/1-a.vtu", "figures/photo.jpg", ".part"}) {
    EXPECT_FALSE(is_result_file(name)) << name;
  }
}

}  // namespace
}  // namespace facies::results
