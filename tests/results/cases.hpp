// SPDX-License-Identifier: Apache-2.0
// A small subject with known geometry, states of it, and a folder to write into.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "facies/mesh/layered_sheet.hpp"
#include "facies/results/subject.hpp"

namespace facies::results {

/// A flat sheet, 40 x 40 mm, skin of 2 mm on fat of 6 mm, 4 x 4 columns; landmarks L, M, R on its outer side at
/// y = -10, 0, 10 mm and D at its lower edge; muscle A in two elements, B in one of them.
class SheetSubject {
 public:
  explicit SheetSubject(mesh::SheetOptions options = default_options())
      : mesh_(mesh::make_layered_sheet(options)) {
    subject_.mesh = &mesh_;
    subject_.layers = {"skin", "fat"};
    subject_.layer_of_element.assign(mesh_.n_elements(), 1);
    for (const Index e : mesh_.elements("skin"))
      subject_.layer_of_element[at(e)] = 0;
    subject_.landmarks = {{"L", "left", nearest({0.0, -10.0, 0.0})},
                          {"M", "middle", nearest({0.0, 0.0, 0.0})},
                          {"R", "right", nearest({0.0, 10.0, 0.0})},
                          {"D", "down", nearest({0.0, 0.0, -20.0})}};
    subject_.pairs = {{"R", "L"}, {"M", "D"}};
    subject_.muscles = {{"A", {0, 5}}, {"B", {5}}};
  }
  SheetSubject(const SheetSubject&) = delete;
  SheetSubject& operator=(const SheetSubject&) = delete;
  SheetSubject(SheetSubject&&) = delete;
  SheetSubject& operator=(SheetSubject&&) = delete;
  ~SheetSubject() = default;

  static mesh::SheetOptions default_options() {
    mesh::SheetOptions options;
    options.n_y = 4;
    options.n_z = 4;
    options.layers = {{"skin", 2.0, 1}, {"fat", 6.0, 1}};
    return options;
  }

  [[nodiscard]] const Subject& operator*() const { return subject_; }
  [[nodiscard]] const Subject* operator->() const { return &subject_; }

  /// The state X -> A X + b at the end of a step, without stress, J = det A.
  [[nodiscard]] Snapshot affine(const std::string& step, int step_number, const Mat3& A,
                                const Vec3& b) const {
    Snapshot snapshot;
    snapshot.step = step;
    snapshot.step_number = step_number;
    for (const Vec3& X : mesh_.X())
      snapshot.state.u.emplace_back(A * X + b - X);
    snapshot.controls.activation = {0.5, 0.25};
    snapshot.sigma.resize(mesh_.n_elements());
    snapshot.J.assign(mesh_.n_elements(), A.determinant());
    return snapshot;
  }

 private:
  [[nodiscard]] Index nearest(const Vec3& place) const {
    Index best = 0;
    for (std::size_t i = 0; i < mesh_.n_nodes(); ++i) {
      if ((mesh_.X()[i] - place).norm() < (mesh_.X()[at(best)] - place).norm()) best = to_index(i);
    }
    return best;
  }

  mesh::Mesh mesh_;
  Subject subject_;
};

/// A folder of its own for each test, gone afterwards.
class InFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "facies-test-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

}  // namespace facies::results
