// SPDX-License-Identifier: Apache-2.0
#include "results/cases.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "facies/base/error.hpp"
#include "facies/results/summary.hpp"

namespace facies::results {
namespace {

using Json = nlohmann::ordered_json;

Summary some_summary(const SheetSubject& sheet) {
  Summary summary;
  summary.version = "0.1.0";
  summary.status = Status::done;
  summary.settings_json = R"({"zygomaticus": 0.5, "axis": [1, 2]})";
  summary.inputs = {{"face.node", "sha256:00ff"}};
  summary.convergence = {
      {"tension", 1, 1, 0.0, 1.0, {{0}, {1, 1.0, 0.1, 1.0, 1.0, 0.0, 2}}, true, "ok", -1, {}}};
  Snapshot snapshot = sheet.affine("tension", 1, Vec3(1.0, 1.2, 1.0).asDiagonal(), Vec3::Zero());
  snapshot.J[5] = 2.0;
  summary.headlines = {make_headline(*sheet, snapshot, nullptr)};
  summary.timings = {{"total", 1.5}};
  return summary;
}

TEST(Summary, SaysHowTheRunEndedAndWhatCameOut) {
  const SheetSubject sheet;
  const Json json = Json::parse(to_json(some_summary(sheet)));
  EXPECT_EQ(json["facies"], "0.1.0");
  EXPECT_EQ(json["status"], "done");
  EXPECT_EQ(json["steps"][0]["factorisations"], 2);
  const Json& measures = json["measures"][0];
  EXPECT_NEAR(measures["landmarks"]["R"]["displacement_mm"].get<double>(), 2.0, 1e-12);
  EXPECT_NEAR(measures["distances"]["R-L"]["change_percent"].get<double>(), 20.0, 1e-12);
  EXPECT_EQ(measures["J"]["largest"]["value"], 2.0);
  EXPECT_EQ(measures["J"]["largest"]["at"]["element"], 5);
  EXPECT_EQ(measures["J"]["largest"]["at"]["muscles"], Json({"A", "B"}));
  EXPECT_NEAR(measures["volume"]["change_from_mesh_percent"].get<double>(), 20.0, 1e-9);
  EXPECT_EQ(json["settings"]["zygomaticus"], 0.5);
  EXPECT_EQ(json["inputs"]["face.node"], "sha256:00ff");
  EXPECT_EQ(json["timings"]["total_s"], 1.5);
}

TEST(Summary, KeepsItsKeysInOneOrderWithTimingsLast) {
  const SheetSubject sheet;
  const std::string text = to_json(some_summary(sheet));
  const Json json = Json::parse(text);
  std::vector<std::string> keys;
  for (const auto& item : json.items())
    keys.push_back(item.key());
  EXPECT_EQ(keys, (std::vector<std::string>{"facies", "status", "steps", "measures", "settings",
                                            "inputs", "timings"}));
  // The settings keep the order that they were given in, too.
  EXPECT_LT(text.find("zygomaticus"), text.find("axis"));
}

TEST(Summary, DiffersBetweenEqualRunsInTimingsOnly) {
  const SheetSubject sheet;
  Summary slow = some_summary(sheet);
  slow.timings = {{"total", 99.0}};
  Json a = Json::parse(to_json(some_summary(sheet)));
  Json b = Json::parse(to_json(slow));
  EXPECT_NE(a, b);
  a.erase("timings");
  b.erase("timings");
  EXPECT_EQ(a, b);
}

TEST(Summary, SaysWhereAndWhyARunStopped) {
  const SheetSubject sheet;
  Summary summary = some_summary(sheet);
  summary.status = Status::not_converged;
  summary.reason = "no equilibrium at load 0.3 of express";
  summary.where = place_of(*sheet, 5);
  const Json json = Json::parse(to_json(summary));
  EXPECT_EQ(json["status"], "not_converged");
  EXPECT_EQ(json["reason"], summary.reason);
  EXPECT_EQ(json["where"]["element"], 5);
  EXPECT_EQ(json["where"]["layer"],
            sheet->layers[static_cast<std::size_t>(sheet->layer_of_element[5])]);
}

TEST(Summary, OfARunThatHasJustBegunIsComplete) {
  Summary summary;
  summary.settings_json = "{}";
  const Json json = Json::parse(to_json(summary));
  EXPECT_EQ(json["status"], "running");
  EXPECT_TRUE(json["steps"].empty());
}

TEST(Summary, RefusesSettingsThatAreNotJson) {
  Summary summary;
  summary.settings_json = "{";
  EXPECT_THROW(static_cast<void>(to_json(summary)), BugError);
}

TEST(Status, HasANameForEachValue) {
  EXPECT_EQ(name(Status::running), "running");
  EXPECT_EQ(name(Status::interrupted), "interrupted");
  EXPECT_EQ(name(Status::failed), "failed");
}

}  // namespace
}  // namespace facies::results
