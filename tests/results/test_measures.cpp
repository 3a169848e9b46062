// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "results/cases.hpp"
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/results/measures.hpp"

namespace facies::results {
namespace {

TEST(Landmarks, MoveWithTheFaceAndCountFromRest) {
  const SheetSubject sheet;
  const Snapshot rest = sheet.affine("release", 2, Mat3::Identity(), {0.0, 0.0, -2.0});
  const Snapshot smile = sheet.affine("express", 3, Mat3::Identity(), {3.0, 4.0, -2.0});
  const auto from_rest = measure_landmarks(*sheet, smile.state, &rest.state);
  ASSERT_EQ(from_rest.size(), 4U);
  EXPECT_EQ(from_rest[2].landmark, "R");
  EXPECT_TRUE(from_rest[2].x.isApprox(Vec3(3.0, 14.0, -2.0)));
  EXPECT_TRUE(from_rest[2].u.isApprox(Vec3(3.0, 4.0, 0.0)));
  EXPECT_DOUBLE_EQ(from_rest[2].displacement, 5.0);
  const auto from_mesh = measure_landmarks(*sheet, smile.state, nullptr);
  EXPECT_TRUE(from_mesh[2].u.isApprox(Vec3(3.0, 4.0, -2.0)));
}

TEST(Pairs, ChangeByTheStretchBetweenThem) {
  const SheetSubject sheet;
  const Snapshot rest = sheet.affine("release", 2, Vec3(1.0, 1.1, 1.0).asDiagonal(), Vec3::Zero());
  const Snapshot smile =
      sheet.affine("express", 3, Vec3(1.0, 1.32, 0.5).asDiagonal(), Vec3::Zero());
  const auto pairs = measure_pairs(*sheet, smile.state, &rest.state);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_NEAR(pairs[0].rest, 22.0, 1e-12);
  EXPECT_NEAR(pairs[0].length, 26.4, 1e-12);
  EXPECT_NEAR(pairs[0].change_percent, 20.0, 1e-12);
  EXPECT_NEAR(pairs[1].change_percent, -50.0, 1e-12);
  EXPECT_NEAR(measure_pairs(*sheet, smile.state, nullptr)[0].rest, 20.0, 1e-12);
}

TEST(Pairs, OfUnknownLandmarksAreADefect) {
  const SheetSubject sheet;
  Subject subject = *sheet;
  subject.pairs = {{"R", "nowhere"}};
  EXPECT_THROW(static_cast<void>(measure_pairs(
                   subject, sheet.affine("a", 1, Mat3::Identity(), Vec3::Zero()).state, nullptr)),
               BugError);
}

TEST(PrincipalTension, IsTheLargestEigenvalueWithItsAxis) {
  const Mat3 Q = Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  const Mat3 sigma = Q * Vec3(-4.0, 9.0, 2.0).asDiagonal() * Q.transpose();
  const PrincipalTension tension = principal_tension(to_sym3(sigma));
  EXPECT_NEAR(tension.value, 9.0, 1e-12);
  EXPECT_NEAR(std::abs(tension.direction.dot(Q.col(1))), 1.0, 1e-12);
}

TEST(PrincipalTension, HasOneAxisWhicheverWayTheStressWasTurned) {
  const Vec3 a = Vec3(0.1, -0.9, 0.3).normalized();
  const PrincipalTension plus = principal_tension(scaled(dyad(a), 5.0));
  const PrincipalTension minus = principal_tension(scaled(dyad(-a), 5.0));
  EXPECT_TRUE(plus.direction.isApprox(minus.direction));
  EXPECT_GT(plus.direction.y(), 0.0);
}

TEST(Dilatation, FindsTheExtremesAndTheirElements) {
  const SheetSubject sheet;
  Snapshot snapshot = sheet.affine("a", 1, Mat3::Identity(), Vec3::Zero());
  snapshot.J[7] = 1.4;
  snapshot.J[3] = 0.8;
  const DilatationExtremes extremes = measure_dilatation(snapshot);
  EXPECT_EQ(extremes.largest_element, 7);
  EXPECT_EQ(extremes.smallest_element, 3);
  EXPECT_EQ(extremes.largest, 1.4);
  EXPECT_EQ(extremes.smallest, 0.8);
}

TEST(Volumes, AreThoseOfTheThreeStates) {
  // A stress-free body of 40 x 40 x 8 / 1.331 mm^3 (TSF 1.1) that fills the mesh stretched by 1.2 along y.
  const SheetSubject sheet;
  Snapshot snapshot = sheet.affine("express", 1, Vec3(1.0, 1.2, 1.0).asDiagonal(), Vec3::Zero());
  snapshot.J.assign(snapshot.J.size(), 1.2 * 1.331);
  const Volumes volumes = measure_volumes(*sheet, snapshot);
  EXPECT_NEAR(volumes.mesh, 12800.0, 1e-8);
  EXPECT_NEAR(volumes.deformed, 15360.0, 1e-8);
  EXPECT_NEAR(volumes.stress_free, 12800.0 / 1.331, 1e-8);
}

TEST(TensionShare, CountsTheSkinsVolumeUnderTension) {
  const SheetSubject sheet;
  Snapshot snapshot = sheet.affine("release", 1, Mat3::Identity(), Vec3::Zero());
  // Slack everywhere but in the skin of the upper half; what lies below the skin does not count.
  for (std::size_t e = 0; e < snapshot.sigma.size(); ++e) {
    const bool is_tense =
        sheet->layer_of_element[e] == 1 || sheet->mesh->centroid(to_index(e)).z() > 0.0;
    snapshot.sigma[e] = scaled(identity_sym3(), is_tense ? 1.0 : -1.0);
  }
  const TensionShare share = measure_tension_share(*sheet, snapshot);
  EXPECT_NEAR(share.all, 0.5, 1e-12);
  // The sheet is 4 x 4 elements: the inner 2 x 2 do not touch its border.
  ASSERT_TRUE(share.away_from_borders.has_value());
  EXPECT_NEAR(*share.away_from_borders, 0.5, 1e-12);
}

TEST(TensionShare, LeavesOutElementsAtTheBorders) {
  const SheetSubject sheet;
  Snapshot snapshot = sheet.affine("release", 1, Mat3::Identity(), Vec3::Zero());
  for (std::size_t e = 0; e < snapshot.sigma.size(); ++e) {
    const Vec3 c = sheet->mesh->centroid(to_index(e));
    const bool is_in_the_middle = std::max(std::abs(c.y()), std::abs(c.z())) < 10.0;
    snapshot.sigma[e] = scaled(identity_sym3(), is_in_the_middle ? 1.0 : -1.0);
  }
  const TensionShare share = measure_tension_share(*sheet, snapshot);
  EXPECT_NEAR(share.all, 0.25, 1e-12);
  EXPECT_NEAR(share.away_from_borders.value(), 1.0, 1e-12);
}

}  // namespace
}  // namespace facies::results
