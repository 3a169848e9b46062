// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <limits>

#include "results/cases.hpp"
#include <gtest/gtest.h>

#include "facies/base/text.hpp"
#include "facies/results/closing_table.hpp"

namespace facies::results {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const std::vector<LandmarkMeasure> landmarks{
    {"RMC", {}, {}, 11.25}, {"PG", {}, {}, 4.0}, {"SN", {}, {}, 2.0}};
const std::vector<PairMeasure> pairs{{"RMC", "LMC", 50.0, 58.5, 17.0},
                                     {"SN", "PH", 20.0, 19.0, -5.0}};
const std::vector<PublishedValue> published{
    {"smile", "displacement", "RMC", 12.0, "mm", "stated", "", ""},
    {"smile", "displacement", "PG", 3.5, "mm", "about", "", ""},
    {"smile", "distance_change", "RMC-LMC", 18.0, "%", "stated", "", ""}};

/// The fields of the line that begins with `name`.
std::vector<std::string_view> row(const std::string& text, std::string_view name) {
  for (const std::string_view line : split(text, '\n')) {
    const std::vector<std::string_view> fields = split_blanks(line);
    if (!fields.empty() && fields.front() == name) return fields;
  }
  return {};
}

TEST(JawLine, SetsTheOpeningBesideThePaper) {
  const std::vector<PublishedValue> paper{
      {"mouth-open", "incisor_distance", "incisors", 40.0, "mm", "stated", "", ""}};
  EXPECT_THAT(row(jaw_line({41.5, {}}, paper), "incisor"),
              ElementsAre("incisor", "distance", "[mm]", "41.50", "40", "+1.50"));
}

TEST(ContactTable, SaysHowNearAndHowHard) {
  const std::string text =
      contact_table({{"jaw", 12, 0.251, 14.26, {300, 0, 400}},
                     {"lips", 0, std::numeric_limits<double>::infinity(), 0.0, Vec3::Zero()}});
  EXPECT_THAT(row(text, "jaw"), ElementsAre("jaw", "12", "0.251", "14.3", "0.50"));
  EXPECT_THAT(row(text, "lips"), ElementsAre("lips", "0", "-", "0.0", "0.00"));
}

TEST(LandmarkTable, SetsTheModelBesideThePaper) {
  const std::string text = landmark_table(landmarks, published);
  EXPECT_THAT(row(text, "RMC"), ElementsAre("RMC", "11.25", "12", "-0.75"));
  EXPECT_THAT(row(text, "PG"), ElementsAre("PG", "4.00", "about", "3.5", "+0.50"));
  EXPECT_THAT(row(text, "SN"), ElementsAre("SN", "2.00", "-", "-"));
}

TEST(LandmarkTable, ComparesTheLargestOfAGroup) {
  const std::vector<PublishedValue> group{
      {"purse", "largest_displacement", "PG RMC LMC", 14.0, "mm", "up to", "", ""}};
  const std::string text = landmark_table(landmarks, group);
  EXPECT_THAT(text, HasSubstr("largest of PG RMC LMC"));
  EXPECT_THAT(row(text, "11.25"), ElementsAre("11.25", "up", "to", "14", "-2.75"));
}

TEST(DistanceTable, ComparesChangesInPercent) {
  const std::string text = distance_table(pairs, published);
  EXPECT_THAT(row(text, "RMC-LMC"),
              ElementsAre("RMC-LMC", "50.00", "58.50", "+17.00", "18", "-1.00"));
  EXPECT_THAT(row(text, "SN-PH"), ElementsAre("SN-PH", "20.00", "19.00", "-5.00", "-", "-"));
}

TEST(ClosingText, TellsVolumesTensionAndExtremesWithTheirPlaces) {
  const SheetSubject sheet;
  Snapshot snapshot = sheet.affine("express", 3, Vec3(1.0, 1.1, 1.0).asDiagonal(), Vec3::Zero());
  snapshot.J[5] = 1.5;
  const std::string text = closing_text(make_headline(*sheet, snapshot, nullptr), {});
  EXPECT_THAT(text, HasSubstr("1.5000  at element 5, "));
  EXPECT_THAT(text, HasSubstr(", A, B"));
  EXPECT_THAT(text, HasSubstr("+10.00 % from the mesh as read"));
  EXPECT_THAT(text, HasSubstr("skin under tension: 0.0 % of it"));
}

TEST(ClosingText, OfASubjectWithoutLandmarksHasNoEmptyTables) {
  const SheetSubject sheet;
  Headline headline =
      make_headline(*sheet, sheet.affine("a", 1, Mat3::Identity(), Vec3::Zero()), nullptr);
  headline.landmarks.clear();
  headline.pairs.clear();
  EXPECT_THAT(closing_text(headline, {}), Not(HasSubstr("paper")));
}

}  // namespace
}  // namespace facies::results
