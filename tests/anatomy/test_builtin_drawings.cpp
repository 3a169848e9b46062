// SPDX-License-Identifier: Apache-2.0
// The files of the built-in face, and what is told about wrong ones.
#include <gmock/gmock.h>

#include "anatomy/builtin_files.hpp"
#include <gtest/gtest.h>

#include "facies/anatomy/builtin_drawings.hpp"
#include "facies/anatomy/builtin_face.hpp"
#include "facies/anatomy/table.hpp"

namespace facies::anatomy {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// What is told of these files.
std::string told_of(const BuiltinFiles& files) {
  try {
    (void)read_drawings(files.path());
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

/// What is told after `old` became `with` in a file.
std::string told_after(const std::string& file, const std::string& old, const std::string& with) {
  BuiltinFiles files;
  files.replace(file, old, with);
  return told_of(files);
}

TEST(BuiltinDrawings, AreReadWithoutProblems) {
  const Drawings drawings = read_drawings(builtin_folder());
  EXPECT_EQ(drawings.inner.size(), drawings.skin.points.size());
  for (const DrawnMuscle& muscle : drawings.muscles) {
    EXPECT_TRUE(std::ranges::any_of(drawings.fibres, [&](const DrawnFibre& fibre) {
      return fibre.muscle == muscle.name;
    })) << muscle.name;
  }
  for (const auto& file : drawings.files)
    EXPECT_TRUE(std::filesystem::exists(file)) << file;
}

TEST(BuiltinDrawings, HaveTheInnerSurfaceBehindTheSkin) {
  const Drawings drawings = read_drawings(builtin_folder());
  for (std::size_t i = 0; i < drawings.inner.size(); ++i) {
    const double depth = (drawings.inner[i] - drawings.skin.points[i]).norm();
    EXPECT_GT(depth, 0.5) << drawings.skin.names[i];
    EXPECT_LT(depth, 40.0) << drawings.skin.names[i];
  }
}

TEST(BuiltinDrawings, WithAMissingColumnNameIt) {
  EXPECT_THAT(told_after("muscle-paths.csv", "up_mm", "upp_mm"),
              AllOf(HasSubstr("muscle-paths.csv:9: no column 'up_mm'"),
                    HasSubstr("did you mean 'upp_mm'?")));
  // Names that come from a table that cannot be read are not missed elsewhere.
  EXPECT_THAT(told_after("muscles.csv", "name,", "nam,"), Not(HasSubstr("muscle-paths.csv")));
  EXPECT_THAT(told_after("face-landmarks.csv", "name,", "nam,"), Not(HasSubstr("pairs.csv")));
  EXPECT_THAT(told_after("landmarks.csv", "name,", "nam,"), Not(HasSubstr("measures.csv")));
}

TEST(BuiltinDrawings, WithAMissingFileNameIt) {
  const BuiltinFiles files;
  std::filesystem::remove(files.path() / "pairs.csv");
  std::filesystem::remove(files.path() / "skin.json");
  EXPECT_THAT(told_of(files), AllOf(HasSubstr("pairs.csv"), HasSubstr("skin.json")));
}

TEST(BuiltinDrawings, WithTextForANumberSayWhere) {
  EXPECT_THAT(told_after("muscle-paths.csv", "ZYG,1,fibre,58.6,16,", "ZYG,1,fibre,far,16,"),
              HasSubstr("muscle-paths.csv:10:13: 'far'; expected a number"));
  EXPECT_THAT(told_after("muscle-paths.csv", "58.6,16,0.9", "58.6,16,1.9"),
              HasSubstr("muscle-paths.csv:10:21: 1.9; expected 0 (the skin's surface) to 1"));
  EXPECT_THAT(told_after("measures.csv", ",125.5,", ",nan,"),
              HasSubstr("'nan'; expected a number"));
}

TEST(BuiltinDrawings, WithUnknownNamesSuggestTheNearest) {
  EXPECT_THAT(told_after("muscle-paths.csv", "ZYG,1", "ZYX,1"),
              AllOf(HasSubstr("muscle-paths.csv:10:1: 'ZYX'; expected a muscle of muscles.csv"),
                    HasSubstr("did you mean 'ZYG'?")));
  EXPECT_THAT(told_after("face-landmarks.csv", "lip0.6,", "lip0.66,"),
              HasSubstr("'lip0.66'; expected a point of skin.json"));
  EXPECT_THAT(told_after("landmarks.csv", "prn,k3.0", "prn,k3.99"),
              HasSubstr("'k3.99'; expected a point of skin.json"));
  EXPECT_THAT(told_after("pairs.csv", "RMC,LMC", "RMC,LMX"),
              AllOf(HasSubstr("pairs.csv:2:5: 'LMX'"), HasSubstr("did you mean 'LMC'?")));
  EXPECT_THAT(told_after("regions.csv", "orbit,", "orbits,"),
              AllOf(HasSubstr("'orbits'; expected a node set"), HasSubstr("'orbit'?")));
  EXPECT_THAT(told_after("regions.csv", "e2.0:3", "e2.0:9"), HasSubstr("e2.5; expected a point"));
}

TEST(BuiltinDrawings, WithImpossibleEntriesSayWhatIsPossible) {
  EXPECT_THAT(told_after("muscle-paths.csv", "OOP,1,ring,0,", "OOP,1,rope,0,"),
              HasSubstr("'rope'; expected fibre, ring or loop"));
  EXPECT_THAT(told_after("muscle-paths.csv", "OOP,1,ring,0,-8.5", "OOP,1,ring,2,-8.5"),
              HasSubstr("expected 0: half a ring begins and ends in the midline"));
  EXPECT_THAT(told_after("landmarks.csv", "prn,k3.0,middle", "prn,k3.0,left"),
              HasSubstr("'left'; expected middle or both"));
  EXPECT_THAT(told_after("landmarks.csv", "prn,k3.0,middle", "prn,k3.0,both"),
              HasSubstr("k3.0 is in the midline; expected middle"));
  EXPECT_THAT(told_after("landmarks.csv", "prn,k3.0,middle", "prn,k3.2,middle"),
              HasSubstr("k3.2 is not in the midline; expected both"));
  EXPECT_THAT(told_after("landmarks.csv", "prn,k3.0,", "prn,k4.0,"),
              HasSubstr("a name that no other row has"));
}

TEST(BuiltinDrawings, WithImpossibleSkinSayWhatIsPossible) {
  EXPECT_THAT(told_after("skin-thickness.csv", "1.60,1.35", "15.5,1.35"),
              HasSubstr("15.5 mm; expected skin of 0.3 mm to 3 mm"));
  EXPECT_THAT(told_after("skin-thickness.csv", "1.60,1.35", "thick,0"),
              AllOf(HasSubstr("'thick'; expected a number"), HasSubstr("0 mm; expected skin")));
  EXPECT_THAT(told_after("skin-thickness.csv", "f3.0:2", "f3.0:4"),
              HasSubstr("f3.4 is in forehead already; expected each point in one region"));
  EXPECT_THAT(told_after("skin-thickness.csv", "f3.0:2", "f33.0"), HasSubstr("f33.0"));
  EXPECT_THAT(told_after("skin-thickness.csv", ",f3.0:2,", ",,"), HasSubstr("no point"));
  BuiltinFiles files;
  files.write("skin-thickness.csv", "region,points,male_mm,female_mm,source\n");
  EXPECT_THAT(told_of(files), HasSubstr("skin-thickness.csv: no region"));
}

TEST(BuiltinDrawings, WithACurveOfOnePointAskForTwo) {
  BuiltinFiles files;
  files.append("tension-lines.csv", "lonely,10,20");
  files.append("muscle-paths.csv", "ZYG,lonely,fibre,40,0,0.5");
  EXPECT_THAT(told_of(files), AllOf(HasSubstr("lonely of 1 point(s); expected at least 2"),
                                    HasSubstr("ZYG.lonely of 1 point(s)")));
}

TEST(BuiltinDrawings, NeedAnInnerPointForEachOfTheSkin) {
  EXPECT_THAT(told_after("inner.json", "\"w2\"", "\"w3\""), HasSubstr("inner.json"));
  EXPECT_THAT(told_after("skin.json", "\"about\"", "\"abuot\""), HasSubstr("skin.json/abuot"));
}

TEST(BuiltinDrawings, WithACurveThatLeavesTheFaceNameItsPoint) {
  BuiltinFiles files;
  files.replace("muscle-paths.csv", "ZYG,1,fibre,58.6,16", "ZYG,1,fibre,158.6,16");
  files.append("tension-lines.csv", "eye,33,46");
  files.append("tension-lines.csv", "eye,33,-20");
  std::string told;
  try {
    (void)make_builtin_face("size=coarse", files.path());
  } catch (const DataError& error) {
    told = error.what();
  }
  EXPECT_THAT(told, AllOf(HasSubstr("muscle-paths.csv:10:13: (158.6, 16) is not on the face"),
                          HasSubstr("(33, 46) is not on the face")));
  EXPECT_THAT(told, Not(HasSubstr("(33, -20)")));
}

}  // namespace
}  // namespace facies::anatomy
