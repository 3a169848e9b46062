// SPDX-License-Identifier: Apache-2.0
// Joints on which no jaw can stand: the reference jaw's own tables with a mistake in each.
#include <filesystem>
#include <gmock/gmock.h>

#include "support/session.hpp"
#include <gtest/gtest.h>

#include "facies/anatomy/jaw_tables.hpp"
#include "facies/base/error.hpp"
#include "facies/scenario/jaw_model.hpp"

namespace facies::scenario {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class BadJoint : public testing::Test {
 protected:
  BadJoint() {
    Problems problems;
    jaw_ = anatomy::read_jaw_tables(
        std::filesystem::path(FACIES_SOURCE_DIR) / "data" / "reference-face", problems);
    problems.throw_if_any<DataError>();
  }

  [[nodiscard]] Index point(const std::string& name) const {
    for (std::size_t p = 0; p < jaw_.points.size(); ++p) {
      if (jaw_.points[p].name == name) return to_index(p);
    }
    return -1;
  }

  /// A plane that the point may not pass, `offset` [mm] behind where the point is in the starting pose.
  void add_stop(const std::string& name, const std::string& of, const Vec3& normal, double offset) {
    const anatomy::JawPoint& led = jaw_.points.at(at(point(of)));
    jaw_.stops.push_back({.name = name,
                          .meaning = "",
                          .point = point(of),
                          .enabled = true,
                          .plane = place_of(jaw_, jaw_.start, led.at) - offset * normal,
                          .normal = normal,
                          .where = "the row of " + name});
  }

  [[nodiscard]] std::string message() const {
    try {
      (void)settle_jaw(jaw_, Vec3(0.0, 0.0, -9800.0));
    } catch (const DataError& error) {
      return error.what();
    }
    return "";
  }

  anatomy::Jaw jaw_;
};

TEST_F(BadJoint, IsNotTheOneAsWritten) {
  EXPECT_EQ(message(), "");
}

TEST_F(BadJoint, WithStopsThatExcludeEachOtherNamesBoth) {
  add_stop("before", "lower_incisor", Vec3::UnitX(), -10.0);
  add_stop("behind", "lower_incisor", -Vec3::UnitX(), -10.0);
  EXPECT_THAT(
      message(),
      AllOf(HasSubstr("lower_incisor is 10 mm beyond the stop before; expected at most 0.1"),
            HasSubstr("lower_incisor is 10 mm beyond the stop behind"),
            HasSubstr("the row of behind: the jaw"), HasSubstr("satisfies all guides and stops")));
}

TEST_F(BadJoint, WithTwoPathsForOneCondyleNamesThePathAndItsLine) {
  jaw_.guides.push_back(jaw_.guides.front());
  jaw_.guides.back().name = "second";
  jaw_.guides.back().curve = swept_curve(140.0, 120.0, 12.0, 5.0, -0.7, -0.2);
  EXPECT_THAT(message(), AllOf(HasSubstr("jaw-guides.csv:2:1: the jaw cannot satisfy its joint"),
                               HasSubstr("condyle_left is"), HasSubstr("off the path TMJ_left"),
                               HasSubstr("off the path second")));
}

TEST_F(BadJoint, WithAStartInAnotherUnitIsToldBeforeAnythingMoves) {
  jaw_.start.u =
      0.001 * jaw_.bones[at(jaw_.mandible)].centre - jaw_.bones[at(jaw_.mandible)].centre;
  EXPECT_THAT(message(),
              AllOf(HasSubstr("jaw-guides.csv:2:1: in the starting pose condyle_left is"),
                    HasSubstr("expected at most 25 mm"), HasSubstr("units")));
}

TEST_F(BadJoint, ThatLeadsOtherPointsThanMeantIsToldByWhereTheJawGoes) {
  jaw_.guides.push_back(jaw_.guides.front());
  jaw_.guides.back().point = point("lower_incisor");
  EXPECT_THAT(message(), AllOf(HasSubstr("jaw: it comes to rest with lower_incisor"),
                               HasSubstr("do guides and stops lead the points meant?")));
}

}  // namespace
}  // namespace facies::scenario
