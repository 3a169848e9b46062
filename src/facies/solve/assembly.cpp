// SPDX-License-Identifier: Apache-2.0
#include "facies/solve/assembly.hpp"

#include <algorithm>

#include "facies/mechanics/positive_part.hpp"

namespace facies::solve {

namespace {

/// Adds one term's blocks to the nonzeros, and the couplings with moving prescribed unknowns to a vector.
class ValueSink final : public mechanics::TangentSink {
 public:
  ValueSink(const mechanics::Stencils& stencils, const Slots& slots, const Equations& equations,
            std::span<double> values, std::span<const double> moves, std::span<double> coupling)
      : stencils_(stencils),
        slots_(slots),
        equations_(equations),
        values_(values),
        moves_(moves),
        coupling_(coupling) {}

  void add(std::size_t stencil, std::span<const double> block) override {
    const std::span<const Index> group = stencils_[stencil];
    const Index* slot = slots_.slot.data() + slots_.begin[stencil];
    for (std::size_t j = 0; j < group.size(); ++j) {
      const double* column = block.data() + j * group.size();
      for (std::size_t i = j; i < group.size(); ++i, ++slot) {
        if (*slot >= 0) {
          values_[at(*slot)] += column[i];
        } else if (!moves_.empty()) {
          add_coupling(group[i], group[j], column[i]);
        }
      }
    }
  }

 private:
  void add_coupling(Index dof_a, Index dof_b, double k) {
    const Index a = equations_.equation_of_dof[at(dof_a)];
    const Index b = equations_.equation_of_dof[at(dof_b)];
    if (a >= 0) coupling_[at(a)] += k * moves_[at(dof_b)];
    if (b >= 0) coupling_[at(b)] += k * moves_[at(dof_a)];
  }

  const mechanics::Stencils& stencils_;
  const Slots& slots_;
  const Equations& equations_;
  std::span<double> values_;
  std::span<const double> moves_;
  std::span<double> coupling_;
};

/// Makes the negative eigenvalues of every block smaller before it is added.
class PositiveSink final : public mechanics::TangentSink {
 public:
  PositiveSink(double positivity, mechanics::TangentSink& next)
      : positivity_(positivity), next_(next) {}

  void add(std::size_t stencil, std::span<const double> block) override {
    std::vector<double> changed(block.begin(), block.end());
    mechanics::reduce_negative(changed, positivity_);
    next_.add(stencil, changed);
  }

 private:
  double positivity_;
  mechanics::TangentSink& next_;
};

/// The groups of every term; of those that change, what may couple near the state.
std::vector<mechanics::Stencils> list_stencils(const mechanics::Model& model,
                                               const mechanics::State& near) {
  std::vector<mechanics::Stencils> lists;
  for (const auto& term : model.terms()) {
    mechanics::Stencils& list = lists.emplace_back();
    term->list_stencils(near, list);
    if (term->couplings_change()) term->likely_stencils(near, list);
  }
  return lists;
}

}  // namespace

Assembly::Assembly(const mechanics::Model& model, std::span<const Index> prescribed)
    : model_(model), equations_(number_equations(model.n_dofs(), prescribed)) {
  widen(model.initial_state());
}

void Assembly::widen(const mechanics::State& state) {
  stencils_ = list_stencils(model_, state);
  pattern_ = build_pattern(stencils_, equations_);
  slots_.clear();
  for (std::size_t t = 0; t < stencils_.size(); ++t) {
    if (model_.terms()[t]->couplings_change()) stencils_[t] = {};
    slots_.push_back(find_slots(stencils_[t], equations_, pattern_));
  }
}

bool Assembly::covers(const mechanics::State& state) const {
  return std::all_of(model_.terms().begin(), model_.terms().end(), [&](const auto& term) {
    if (!term->couplings_change()) return true;
    mechanics::Stencils now;
    term->list_stencils(state, now);
    const Slots slots = find_slots(now, equations_, pattern_);
    return std::find(slots.slot.begin(), slots.slot.end(), -1) == slots.slot.end();
  });
}

void Assembly::tangent(const mechanics::State& state, const mechanics::Controls& controls,
                       double positivity, std::span<double> values, std::span<const double> moves,
                       std::span<double> coupling) const {
  std::fill(values.begin(), values.end(), 0.0);
  for (std::size_t t = 0; t < slots_.size(); ++t) {
    const mechanics::Term& term = *model_.terms()[t];
    mechanics::Stencils now;
    Slots slots_now;
    if (term.couplings_change()) {
      term.list_stencils(state, now);
      slots_now = find_slots(now, equations_, pattern_);
    }
    const mechanics::Stencils& stencils = term.couplings_change() ? now : stencils_[t];
    const Slots& slots = term.couplings_change() ? slots_now : slots_[t];
    ValueSink sink(stencils, slots, equations_, values, moves, coupling);
    PositiveSink positive(positivity, sink);
    mechanics::TangentSink& first =
        positivity > 0.0 ? static_cast<mechanics::TangentSink&>(positive) : sink;
    term.add_tangent(state, controls, first);
  }
}

}  // namespace facies::solve
