// SPDX-License-Identifier: Apache-2.0
// How a solution procedure speaks while it works. Libraries never print: a terminal, a log file or a web page listens.
#pragma once

#include <string>

#include "facies/mechanics/term.hpp"

namespace facies::solve {

struct Motion;

/// One Newton iteration.
struct Iteration {
  int number = 0;            ///< from 0: the state before the first correction
  double residual = 0.0;     ///< |r| over the free unknowns [mN]
  double relative = 0.0;     ///< residual / the load scale it is measured against
  double correction = 0.0;   ///< largest nodal correction of the step that led here [mm]
  double step_length = 0.0;  ///< how many Newton steps long the step was, 0..16
  double shift = 0.0;        ///< of the diagonal, relative; 0: none was needed
  int factorisations = 0;  ///< that this iteration needed; 0: it used the factor of an earlier one
  bool exact = true;  ///< the tangent itself was used; else one with smaller negative eigenvalues
};

/// One increment of a step, begun at load `from` and aimed at load `to`, both 0..1.
struct Increment {
  std::string step;     ///< "tension", "release", "express"
  int step_number = 0;  ///< from 1
  int n_steps = 0;
  int number = 0;  ///< from 1 within the step, failed ones counted
  double from = 0.0, to = 1.0;
};

/// How an increment ended.
struct IncrementEnd {
  bool converged = false;
  std::string
      reason;  ///< "residual 3e-10 of the load", "no decrease along the Newton direction" ...
  int iterations = 0;
  double residual = 0.0;  ///< [mN]
  double relative = 0.0;
  Index worst_node = -1;                 ///< carries the largest remaining residual
  mechanics::Inadmissible inadmissible;  ///< the last element that stood in the way, if any
};

class Observer {
 public:
  Observer() = default;
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;
  Observer(Observer&&) = delete;
  Observer& operator=(Observer&&) = delete;
  virtual ~Observer() = default;

  virtual void increment_begins(const Increment& /*increment*/) {}
  virtual void iteration_done(const Increment& /*increment*/, const Iteration& /*iteration*/) {}
  virtual void increment_ends(const Increment& /*increment*/, const IncrementEnd& /*end*/) {}
  /// A step in time has been accepted.
  virtual void time_step_done(const Motion& /*motion*/) {}
  /// Asked after every iteration; true ends the run with Interrupted.
  [[nodiscard]] virtual bool stop_requested() const { return false; }
};

}  // namespace facies::solve
