// SPDX-License-Identifier: Apache-2.0
// What stands in the files is checked by reading them with another program in tests/mesh; here: which fields, which numbers.
#include <algorithm>

#include "results/cases.hpp"
#include <gtest/gtest.h>

#include "facies/base/error.hpp"
#include "facies/base/files.hpp"
#include "facies/results/fields.hpp"

namespace facies::results {
namespace {

const mesh::Field& find(const std::vector<mesh::Field>& fields, const std::string& name) {
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [&](const mesh::Field& f) { return f.name == name; });
  if (found == fields.end()) throw std::runtime_error("no field " + name);
  return *found;
}

class Fields : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    std::filesystem::create_directory(folder_ / "fields");
  }
  SheetSubject sheet_;
};

TEST_F(Fields, OfNodesCountFromTheMeshAndFromRest) {
  const Snapshot rest = sheet_.affine("release", 2, Mat3::Identity(), {1.0, 0.0, 0.0});
  const Snapshot smile = sheet_.affine("express", 3, Mat3::Identity(), {1.0, 2.0, 0.0});
  const auto fields = node_fields(*sheet_, smile, &rest.state);
  EXPECT_EQ(find(fields, "displacement_mm").values[0], 1.0);
  EXPECT_EQ(find(fields, "displacement_mm").values[1], 2.0);
  EXPECT_EQ(find(fields, "displacement_from_rest_mm").values[0], 0.0);
  EXPECT_EQ(find(fields, "displacement_from_rest_mm").values[1], 2.0);
}

TEST_F(Fields, OfElementsHoldStressLayersAndMuscles) {
  Snapshot snapshot = sheet_.affine("express", 3, Mat3::Identity(), Vec3::Zero());
  snapshot.sigma[5] = {1.0, 7.0, 2.0, 0.0, 0.0, 0.0};
  snapshot.J[5] = 1.25;
  const auto fields = element_fields(*sheet_, snapshot);
  EXPECT_EQ(find(fields, "J").values[5], 1.25);
  EXPECT_EQ(find(fields, "principal_tension_kPa").values[5], 7.0);
  EXPECT_EQ(find(fields, "principal_tension_direction").values[16], 1.0);
  EXPECT_EQ(find(fields, "cauchy_stress_kPa").n_components, 6);
  EXPECT_EQ(find(fields, "cauchy_stress_kPa").values[31], 7.0);
  EXPECT_EQ(find(fields, "activation").values[0], 0.5);
  EXPECT_EQ(find(fields, "activation").values[5], 0.75);
  EXPECT_EQ(find(fields, "activation").values[1], 0.0);
  EXPECT_EQ(find(fields, "n_muscles").values[5], 2.0);
  EXPECT_EQ(find(fields, "layer").values[at(sheet_->mesh->elements("fat")[0])], 1.0);
}

TEST_F(Fields, AreListedAfterEverySnapshot) {
  FieldWriter writer(*sheet_, folder_);
  EXPECT_EQ(writer.add(sheet_.affine("tension", 1, Mat3::Identity(), Vec3::Zero()), nullptr),
            "fields/01-tension.vtu");
  EXPECT_NE(read_file(folder_ / "fields.pvd").find("fields/01-tension.vtu"), std::string::npos);
  EXPECT_EQ(writer.add(sheet_.affine("release", 2, Mat3::Identity(), Vec3::Zero()), nullptr),
            "fields/02-release.vtu");
  const std::string list = read_file(folder_ / "fields.pvd");
  EXPECT_NE(list.find("fields/01-tension.vtu"), std::string::npos);
  EXPECT_NE(list.find("fields/02-release.vtu"), std::string::npos);
  EXPECT_NE(read_file(folder_ / "fields/02-release.vtu").find("displacement_from_rest_mm"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "fields.pvd.part"));
}

TEST_F(Fields, OfTheSameStateHaveTheSameBytes) {
  FieldWriter writer(*sheet_, folder_);
  const Snapshot snapshot =
      sheet_.affine("tension", 1, Vec3(1.0, 1.1, 0.9).asDiagonal(), Vec3::Zero());
  writer.add(snapshot, nullptr);
  const std::string first = read_file(folder_ / "fields/01-tension.vtu");
  FieldWriter(*sheet_, folder_).add(snapshot, nullptr);
  EXPECT_EQ(read_file(folder_ / "fields/01-tension.vtu"), first);
}

TEST_F(Fields, NeedTheFolder) {
  FieldWriter writer(*sheet_, folder_ / "missing");
  EXPECT_THROW(writer.add(sheet_.affine("tension", 1, Mat3::Identity(), Vec3::Zero()), nullptr),
               UsageError);
}

TEST_F(Fields, OfBonesStandBesideThoseOfTissue) {
  Subject subject = *sheet_;
  subject.bodies = {{"jaw", Vec3::Zero(), 1.0, Mat3::Identity()}};
  const mesh::TriangleSurface triangle{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()},
                                       {std::array<Index, 3>{0, 1, 2}}};
  subject.bones = {{"jaw", "lower jaw", true, 0, triangle, {true, true, true}},
                   {"maxilla", "upper jaw", true, -1, triangle, {true, false, true}}};
  FieldWriter writer(subject, folder_);
  Snapshot snapshot = sheet_.affine("release", 2, Mat3::Identity(), Vec3::Zero());
  snapshot.state.bodies = {{Vec3(0.0, 0.0, 1.0), Mat3::Identity()}};
  EXPECT_EQ(writer.add(snapshot, nullptr), "fields/01-release.vtu");
  const std::string fixed = read_file(folder_ / "fields/bones-fixed.vtu");
  const std::string before = read_file(folder_ / "fields/01-release-bones.vtu");
  snapshot.step = "express";
  snapshot.step_number = 3;
  snapshot.load = 0.5;
  snapshot.state.bodies[0].u.z() = 2.0;
  EXPECT_EQ(writer.add_frame(snapshot, nullptr, 4), "fields/02-express-004.vtu");
  EXPECT_EQ(fixed, bones_vtu(subject, snapshot.state, false));
  EXPECT_NE(before, read_file(folder_ / "fields/02-express-004-bones.vtu"));
  const std::string series = read_file(folder_ / "bones.pvd");
  for (const char* line :
       {"timestep=\"2\" group=\"\" part=\"0\" file=\"fields/bones-fixed.vtu\"",
        "timestep=\"2\" group=\"\" part=\"1\" file=\"fields/01-release-bones.vtu\"",
        "timestep=\"2.5\" group=\"\" part=\"0\" file=\"fields/bones-fixed.vtu\"",
        "timestep=\"2.5\" group=\"\" part=\"1\" file=\"fields/02-express-004-bones.vtu\""})
    EXPECT_NE(series.find(line), std::string::npos) << line;
}

}  // namespace
}  // namespace facies::results
