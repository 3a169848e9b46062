// SPDX-License-Identifier: Apache-2.0
// Measurements of a face, and landmarks that have them.
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>

#include "anatomy/builtin_files.hpp"
#include "support/random.hpp"
#include <gtest/gtest.h>

#include "facies/anatomy/builtin_drawings.hpp"
#include "facies/anatomy/builtin_measures.hpp"

namespace facies::anatomy {
namespace {

using support::Random;
using testing::AllOf;
using testing::HasSubstr;

/// The tables that ship, and where the drawing has their landmarks.
struct Tables {
  MeasureTables tables;
  LandmarkPlaces drawn;

  Tables() {
    const Drawings drawings = read_drawings(builtin_folder());
    tables = drawings.measures;
    for (const SkinLandmark& landmark : tables.landmarks)
      drawn[landmark.name] = drawings.skin.points[at(drawings.skin.index.at(landmark.point))];
  }
  [[nodiscard]] const std::vector<FaceMeasure>& measures() const { return tables.measures; }
  [[nodiscard]] const FaceMeasure& measure(const std::string& key) const {
    return *std::ranges::find(tables.measures, key, &FaceMeasure::key);
  }
};

TEST(Measured, FollowsTheDefinitions) {
  const LandmarkPlaces places{{"a", Vec3(-3.0, 4.0, 12.0)}, {"b", Vec3(1.0, 1.0, 0.0)}};
  FaceMeasure measure;
  measure.a = "a";
  measure.b = "b";
  EXPECT_NEAR(measured(measure, places), 13.0, 1e-12);  // 4, 3, 12
  measure.kind = MeasureKind::forward;                  // -x is anterior
  EXPECT_NEAR(measured(measure, places), 4.0, 1e-12);
  measure.kind = MeasureKind::up;
  EXPECT_NEAR(measured(measure, places), 12.0, 1e-12);
  measure.kind = MeasureKind::width;
  measure.b = "";
  EXPECT_NEAR(measured(measure, places), 8.0, 1e-12);
}

TEST(CompleteValues, AreThePresetWhereNothingIsGiven) {
  const Tables face;
  for (const bool female : {false, true}) {
    const MeasureValues values = complete_values(face.measures(), female, {});
    for (const FaceMeasure& measure : face.measures()) {
      EXPECT_EQ(values.contains(measure.key), measure.rest_of.empty()) << measure.key;
      if (!values.contains(measure.key)) continue;
      EXPECT_EQ(values.at(measure.key), female ? measure.female : measure.male) << measure.key;
    }
  }
}

TEST(CompleteValues, ChangePartsInProportionToTheirHeight) {
  const Tables face;
  const double before = face.measure("face_height").male;
  const MeasureValues values =
      complete_values(face.measures(), false, {{"face_height", 1.05 * before}});
  for (const char* part : {"nose_height", "upper_lip_height", "lower_vermilion", "lower_lip_skin"})
    EXPECT_NEAR(values.at(part), 1.05 * face.measure(part).male, 1e-12) << part;
  EXPECT_NEAR(values.at("mouth_width"), face.measure("mouth_width").male, 1e-12);
  // One that is given itself stays as it was given.
  const MeasureValues both = complete_values(
      face.measures(), false, {{"face_height", 1.05 * before}, {"nose_height", 55.0}});
  EXPECT_EQ(both.at("nose_height"), 55.0);
}

TEST(CompleteValues, LeaveAHeightOpenWhereItsRestIsGiven) {
  const Tables face;
  const MeasureValues values = complete_values(face.measures(), false, {{"chin_height", 33.0}});
  EXPECT_FALSE(values.contains("face_height"));
  EXPECT_EQ(values.at("chin_height"), 33.0);
  const MeasureValues both =
      complete_values(face.measures(), false, {{"chin_height", 33.0}, {"face_height", 128.0}});
  EXPECT_EQ(both.at("face_height"), 128.0);
  // Parts share what the chin leaves of the face.
  const double factor =
      (128.0 - 33.0) / (face.measure("face_height").male - face.measure("chin_height").male);
  EXPECT_NEAR(both.at("nose_height"), factor * face.measure("nose_height").male, 1e-12);
}

TEST(CompleteValues, RefuseWhatIsOutOfItsRange) {
  const Tables face;
  try {
    (void)complete_values(face.measures(), true, {{"mouth_width", 99.0}, {"nose_width", 3.0}});
    FAIL() << "nothing was refused";
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("builtin:mouth_width: 99 mm; expected 40 mm to 62 mm"),
                      HasSubstr("builtin:nose_width: 3 mm; expected 26 mm to 43 mm")));
  }
}

TEST(PlaceLandmarks, GiveEveryMeasureItsValue) {
  const Tables face;
  Random random(5);
  for (int draw = 0; draw < 50; ++draw) {
    MeasureValues given;
    for (const FaceMeasure& measure : face.measures()) {
      // The middle half of the ranges, where the rest of the face's height is never out of its own.
      const double part = random.uniform(0.35, 0.65);
      given[measure.key] = measure.smallest + part * (measure.largest - measure.smallest);
    }
    given.erase("face_height");
    const LandmarkPlaces places = place_landmarks(
        face.measures(), complete_values(face.measures(), false, given), face.drawn);
    for (const auto& [key, value] : given)
      EXPECT_NEAR(measured(face.measure(key), places), value, 1e-6) << key;
    for (const auto& [name, x] : places)
      EXPECT_EQ(x.y() == 0.0, face.drawn.at(name).y() == 0.0) << name;
  }
}

TEST(PlaceLandmarks, LeaveADrawingThatHasTheMeasures) {
  const Tables face;
  MeasureValues values;
  for (const FaceMeasure& measure : face.measures())
    values[measure.key] = measured(measure, face.drawn);
  for (const auto& [name, x] : place_landmarks(face.measures(), values, face.drawn))
    EXPECT_LT((x - face.drawn.at(name)).norm(), 1e-9) << name;
}

TEST(PlaceLandmarks, ScaleTheWholeFaceWhereAllMeasuresAre) {
  const Tables face;
  MeasureValues values;
  for (const FaceMeasure& measure : face.measures())
    values[measure.key] = 1.04 * measured(measure, face.drawn);
  for (const auto& [name, x] : place_landmarks(face.measures(), values, face.drawn))
    EXPECT_LT((x - 1.04 * face.drawn.at(name)).norm(), 1e-8) << name;
}

// The deepest point of the nasal root has no measure of its own. Were it to stay where it is drawn, a short nose would put the
// nasion below it.
TEST(PlaceLandmarks, TakeLandmarksOfNoMeasureAlong) {
  const Tables face;
  for (const double height : {46.0, 62.0}) {
    MeasureValues given{{"nose_height", height}};
    given["face_height"] = face.measure("face_height").male + height - 55.5;
    const LandmarkPlaces places = place_landmarks(
        face.measures(), complete_values(face.measures(), false, given), face.drawn);
    const double drawn = face.drawn.at("n").z() - face.drawn.at("se").z();
    EXPECT_NEAR(places.at("n").z() - places.at("se").z(), drawn, 0.3 * drawn) << height;
  }
}

TEST(PlaceLandmarks, RefuseMeasuresThatContradictEachOther) {
  const Tables face;
  // The lips cannot be longer than the face.
  const auto told = [&](const MeasureValues& values) -> std::string {
    try {
      (void)place_landmarks(face.measures(), values, face.drawn);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(told(complete_values(face.measures(), false,
                                   {{"face_height", 100.0}, {"nose_height", 65.0}})),
              AllOf(HasSubstr("builtin:chin_height:"), HasSubstr("follow from the others"),
                    HasSubstr("contradict each other")));
  MeasureValues impossible = complete_values(face.measures(), false, {});
  impossible["upper_vermilion"] = 1.0;
  impossible["lower_vermilion"] = 1.0;
  impossible["lower_lip_forward"] = -20.0;  // ls and li are then at most 2 mm apart
  EXPECT_THAT(told(impossible), AllOf(HasSubstr("no face has"), HasSubstr("contradict")));
}

TEST(PlaceLandmarks, LeaveEverythingWhereNothingIsWanted) {
  const Tables face;
  const LandmarkPlaces places = place_landmarks({}, {}, face.drawn);
  EXPECT_EQ(places, face.drawn);
}

/// What is told after `old` became `with` in measures.csv.
std::string told_after(const std::string& old, const std::string& with) {
  BuiltinFiles files;
  files.replace("measures.csv", old, with);
  try {
    (void)read_drawings(files.path());
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

TEST(ReadMeasures, ExplainWrongRows) {
  EXPECT_THAT(told_after("nose_height,distance", "nose_height,length"),
              HasSubstr("'length'; expected distance, width, forward or up"));
  EXPECT_THAT(
      told_after("distance,n,sn,", "distance,n,snn,"),
      AllOf(HasSubstr("'snn'; expected a name of landmarks.csv"), HasSubstr("did you mean 'sn'?")));
  EXPECT_THAT(told_after("distance,n,sn,", "distance,n,n,"),
              HasSubstr("'n'; expected another landmark than a"));
  EXPECT_THAT(told_after("width,zy,", "width,n,"), HasSubstr("n is in the midline"));
  EXPECT_THAT(told_after("n,sn,face_height", "n,sn,face_hight"),
              AllOf(HasSubstr("'face_hight'; expected a key of this table"),
                    HasSubstr("did you mean 'face_height'?")));
  EXPECT_THAT(told_after(",55.5,52,44,65,", ",55.5,52,53,65,"),
              HasSubstr("52 mm is not in the range"));
  EXPECT_THAT(told_after("nose_height,", "face_height,"), HasSubstr("that no other row has"));
}

}  // namespace
}  // namespace facies::anatomy
