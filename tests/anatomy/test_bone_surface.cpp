// SPDX-License-Identifier: Apache-2.0
// Bones that tissue may lean on, and those that are refused.
#include <array>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "facies/anatomy/bone_surface.hpp"

namespace facies::anatomy {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Quad = std::array<int, 4>;

/// A box of 20 x 30 x 40, its faces counter-clockwise seen from outside.
const std::vector<Quad> box = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5},
                               {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};

class BoneFile : public ::testing::Test {
 protected:
  BoneFile() {
    bone_.name = "bone";
    bone_.file = std::filesystem::path(testing::TempDir()) / "bone.obj";
    bone_.closed = true;
  }

  /// The box with these faces, and more lines after it.
  void write(const std::vector<Quad>& faces, const std::string& more = "") const {
    std::ofstream file(bone_.file);
    for (int corner = 0; corner < 8; ++corner) {
      file << "v " << ((corner & 1) != 0 ? 20 : 0) << " " << ((corner & 2) != 0 ? 30 : 0) << " "
           << ((corner & 4) != 0 ? 40 : 0) << "\n";
    }
    for (const Quad& face : faces)
      file << "f " << face[0] << " " << face[1] << " " << face[2] << " " << face[3] << "\n";
    file << more;
  }

  /// The only problem that the file has, in words; empty for none.
  [[nodiscard]] std::string problem() const {
    Problems problems;
    const mesh::TriangleSurface surface = read_bone_surface(bone_, problems);
    if (problems.empty()) {
      EXPECT_EQ(surface.triangles.size(), 12U);
      return "";
    }
    EXPECT_EQ(problems.list().size(), 1U);
    const Problem& first = problems.list().front();
    EXPECT_EQ(first.where, bone_.file.string());
    return first.found + " / " + first.hint;
  }

  BoneSurface bone_;
};

TEST_F(BoneFile, ThatIsClosedIsTaken) {
  write(box);
  EXPECT_EQ(problem(), "");
}

TEST_F(BoneFile, WithABorderIsRefusedWhereItShouldBeClosed) {
  write({box.begin(), box.end() - 1});
  EXPECT_THAT(problem(), HasSubstr("a border of 4 edges, the first near (20.0, 0.0, 0.0) mm"));
}

TEST_F(BoneFile, WithABorderIsTakenWhereItMayBeOpen) {
  write({box.begin(), box.end() - 1});
  bone_.closed = false;
  Problems problems;
  EXPECT_EQ(read_bone_surface(bone_, problems).triangles.size(), 10U);
  EXPECT_TRUE(problems.empty());
}

TEST_F(BoneFile, ThatIsInsideOutIsRefused) {
  std::vector<Quad> turned = box;
  for (Quad& face : turned)
    std::swap(face[1], face[3]);
  write(turned);
  EXPECT_THAT(problem(), HasSubstr("inside out"));
}

TEST_F(BoneFile, WithOneFaceTheWrongWayRoundIsRefused) {
  std::vector<Quad> turned = box;
  std::swap(turned[2][1], turned[2][3]);
  write(turned);
  EXPECT_THAT(problem(), HasSubstr("4 edges whose two triangles disagree"));
}

TEST_F(BoneFile, ThatRunsThroughItselfIsRefused) {
  write(box, "v 5 5 -5\nv 15 10 -5\nv 10 10 5\nf 9 10 11\n");
  bone_.closed = false;
  EXPECT_THAT(problem(), HasSubstr("1 pair of triangles through each other, counted from 1: "
                                   "2 and 13 near (0.0, 0.0, 0.0) mm"));
}

TEST_F(BoneFile, InMetresIsTakenForWhatItIs) {
  write(box);
  bone_.scale = 0.001;
  EXPECT_THAT(problem(), AllOf(HasSubstr("a bone of 0.05385 mm, 53.85 in the file's unit"),
                               HasSubstr("1 for millimetres")));
}

TEST_F(BoneFile, ThatIsMissingIsNamed) {
  bone_.file = "/no/such/bone.obj";
  Problems problems;
  EXPECT_TRUE(read_bone_surface(bone_, problems).triangles.empty());
  ASSERT_EQ(problems.list().size(), 1U);
  EXPECT_THAT(problems.list()[0].where, HasSubstr("/no/such/bone.obj"));
}

}  // namespace
}  // namespace facies::anatomy
