// SPDX-License-Identifier: Apache-2.0
// A Newton iteration beside the factorisation that it cannot do without, measured in turns at the tensioned rest.
//
//   bench_newton_iteration artisynth:DIR [threads]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>

#include <fmt/format.h>

#include "facies/anatomy/sources.hpp"
#include "facies/base/parallel.hpp"
#include "facies/scenario/folders.hpp"
#include "facies/scenario/read_scenario.hpp"
#include "facies/scenario/stepper.hpp"
#include "facies/solve/session.hpp"

namespace {

using namespace facies;

constexpr int repetitions = 15;

double seconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + repetitions / 2, values.end());
  return values[repetitions / 2];
}

void measure(const std::string& spec, int threads) {
  const solve::Session session;
  const std::filesystem::path home = scenario::home_folder();
  const scenario::Scenario smile =
      scenario::read_scenario(scenario::find_scenario("smile-open", home));
  const auto face =
      scenario::build_model(anatomy::load_face(spec, scenario::data_folder()), smile, threads);
  scenario::Stepper stepper(*face, smile);
  solve::Observer silent;
  for (const int step : {1, 2}) {
    if (!stepper.take(step, silent).converged)
      throw NumericsError(fmt::format("step {} did not converge", step));
  }

  solve::Assembly assembly(face->model, face->held_after_release);
  if (!assembly.covers(stepper.state())) assembly.widen(stepper.state());
  solve::SymmetricFactor factor(assembly.pattern());
  std::vector<double> values(assembly.pattern().n_nonzeros());
  std::vector<double> rhs(assembly.equations().size(), 1.0);
  std::vector<double> x(rhs.size());
  std::vector<double> r(face->model.n_dofs());
  const auto assemble = [&] {
    assembly.tangent(stepper.state(), stepper.controls(), 0.0, values, {}, {});
  };
  const auto factorise_and_solve = [&] {
    if (factor.factorise(values) != 0) throw NumericsError("the tensioned rest is not stable");
    factor.solve(rhs, x);
  };
  const auto residual = [&] {
    if (!face->model.residual(stepper.state(), stepper.controls(), r))
      throw BugError("an inadmissible state");
  };
  assemble();
  factorise_and_solve();  // the symbolic phase is done once per pattern and stays outside

  std::vector<double> bare, tangent, residuals, whole;
  for (int k = 0; k < repetitions; ++k) {
    bare.push_back(seconds(factorise_and_solve));
    tangent.push_back(seconds(assemble));
    residuals.push_back(seconds(residual));
    whole.push_back(seconds([&] {
      assemble();
      factorise_and_solve();
      residual();
    }));
  }
  const double floor = median(bare);
  fmt::print(
      "{{\"face\": \"{}\", \"threads\": {}, \"unknowns\": {}, \"nonzeros\": {}, \"repetitions\": "
      "{},\n"
      " \"bare_factorisation_and_solution_s\": {:.4f}, \"tangent_s\": {:.4f}, \"residual_s\": "
      "{:.4f}, "
      "\"newton_iteration_s\": {:.4f},\n"
      " \"ratio_tangent\": {:.3f}, \"ratio_residual\": {:.3f}, \"ratio_newton_iteration\": "
      "{:.3f}}}\n",
      spec, threads, rhs.size(), values.size(), repetitions, floor, median(tangent),
      median(residuals), median(whole), median(tangent) / floor, median(residuals) / floor,
      median(whole) / floor);
}

}  // namespace

int main(int n_arguments, char** arguments) {
  try {
    if (n_arguments < 2)
      throw UsageError({{"", "no face given", "bench_newton_iteration SPEC [threads]", ""}});
    measure(arguments[1], n_arguments > 2 ? std::atoi(arguments[2]) : available_threads());
    return 0;
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 1;
  }
}
