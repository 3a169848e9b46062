// SPDX-License-Identifier: Apache-2.0
// A scenario that ships, taken through all its steps on the paper's face, and what has to hold after every one of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "anatomy/reference_face.hpp"
#include "support/session.hpp"
#include <Eigen/Geometry>

#include "facies/mesh/winding_number.hpp"
#include "facies/results/summary.hpp"
#include "facies/scenario/folders.hpp"
#include "facies/scenario/mechanism_report.hpp"
#include "facies/scenario/read_scenario.hpp"
#include "facies/scenario/recorder.hpp"
#include "facies/scenario/stepper.hpp"

namespace facies::scenario {

class FaceRun : public anatomy::ReferenceFaceTest {
 protected:
  /// Takes all steps of the scenario; false where one does not converge.
  [[nodiscard]] bool carry_out(const std::string& name) {
    scenario_ =
        read_scenario(std::filesystem::path(FACIES_SOURCE_DIR) / "scenarios" / (name + ".yaml"));
    const std::string spec = "artisynth:" + anatomy::reference_folder()->string();
    model_ = build_model(anatomy::load_face(spec, anatomy::data_folder()), scenario_, 2);
    Stepper stepper(*model_, scenario_);
    solve::Observer silent;
    for (std::size_t step = 1; step <= scenario_.steps.size(); ++step) {
      if (!stepper.take(static_cast<int>(step), silent).converged) return false;
      states_.push_back(stepper.state());
      controls_.push_back(stepper.controls());
    }
    return true;
  }

  /// Nothing lies in the mandible or touches anything, in no state; at the end the forces on the jaw balance.
  void expect_contact_and_jaw_in_order() const {
    EXPECT_EQ(n_nodes_in_the_mandible(model_->initial), 0);
    for (const mechanics::State& state : states_) {
      EXPECT_EQ(n_nodes_in_the_mandible(state), 0);
      for (const results::ContactMeasure& contact : measure_contacts(*model_, state))
        EXPECT_GT(contact.smallest_distance, 0.0) << contact.name;
    }
    EXPECT_LT(imbalance_of_the_jaw(states_.back()), 1e-6);
  }

  /// What the terminal shows of a step, counted from 1; displacements from the tensioned rest.
  [[nodiscard]] results::Headline headline(std::size_t step) const {
    const results::Subject subject = make_subject(*model_);
    const mechanics::State* rest = step > 2 ? &states_[1] : nullptr;
    return results::make_headline(
        subject, make_snapshot(*model_, states_[step - 1], controls_[step - 1]), rest);
  }

  /// Displacements of the landmarks at the end [mm].
  [[nodiscard]] std::map<std::string, double> displacements() const {
    std::map<std::string, double> displacement;
    for (const results::LandmarkMeasure& landmark : headline(states_.size()).landmarks)
      displacement[landmark.landmark] = landmark.displacement;
    return displacement;
  }

  /// How much the distance of two landmarks has changed at the end [%].
  [[nodiscard]] double change_percent(const std::string& a, const std::string& b) const {
    for (const results::PairMeasure& pair : headline(states_.size()).pairs) {
      if (pair.a == a && pair.b == b) return pair.change_percent;
    }
    return 0.0;
  }

  /// Nodes of the inner surface that lie inside the mandible.
  [[nodiscard]] int n_nodes_in_the_mandible(const mechanics::State& state) const {
    const anatomy::Jaw& jaw = *model_->face.jaw;
    const mesh::TriangleSurface& bone = anatomy::find_named(jaw.surfaces, "jaw")->surface;
    std::vector<Vec3> x;
    for (const Vec3& X : bone.X) {
      x.push_back(mechanics::place_of(model_->model, state,
                                      anchor_of(jaw, *model_->jaw, {jaw.mandible, X})));
    }
    int n_inside = 0;
    const std::span<const Index> tied = model_->face.mesh.nodes(jaw.attached_nodes);
    const std::set<Index> left_out(tied.begin(), tied.end());
    for (const mechanics::ContactPoint& point : inner_points(model_->face, left_out)) {
      const std::vector<Index>& held = model_->held_after_release;
      if (std::ranges::binary_search(held, 3 * point.anchor.index)) continue;
      const Vec3 place = point.anchor.X + state.u[at(point.anchor.index)];
      if (mesh::winding_number(x, bone.triangles, place) > 0.5) ++n_inside;
    }
    return n_inside;
  }

  /// All forces on the six unknowns of the jaw, against the sum of their sizes.
  [[nodiscard]] double imbalance_of_the_jaw(const mechanics::State& state) const {
    std::vector<double> sum(model_->model.n_dofs());
    double size = 0.0;
    for (const auto& term : model_->model.terms()) {
      std::vector<double> r(model_->model.n_dofs());
      EXPECT_TRUE(term->add_residual(state, controls_.back(), r, nullptr));
      for (int k = 0; k < 6; ++k) {
        const std::size_t dof = at(model_->model.body_dof(0, k));
        sum[dof] += r[dof];
        size += std::abs(r[dof]);
      }
    }
    double most = 0.0;
    for (int k = 0; k < 6; ++k)
      most = std::max(most, std::abs(sum[at(model_->model.body_dof(0, k))]));
    return most / size;
  }

  Scenario scenario_;
  std::unique_ptr<FaceModel> model_;
  std::vector<mechanics::State> states_;  // after each step
  std::vector<mechanics::Controls> controls_;
};

}  // namespace facies::scenario
