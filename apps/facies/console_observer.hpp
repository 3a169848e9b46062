// SPDX-License-Identifier: Apache-2.0
// A run as a person follows it: a progress bar on a terminal, one line per increment elsewhere, on request the whole
// convergence table.
#pragma once

#include <iosfwd>
#include <string>

#include "apps/facies/terminal.hpp"

#include "facies/solve/observer.hpp"

namespace facies::cli {

enum class Verbosity { quiet, normal, verbose };

class ConsoleObserver final : public solve::Observer {
 public:
  /// `out` outlives the observer.
  ConsoleObserver(std::ostream& out, Terminal terminal, Verbosity verbosity);

  void increment_begins(const solve::Increment& increment) override;
  void iteration_done(const solve::Increment& increment,
                      const solve::Iteration& iteration) override;
  void increment_ends(const solve::Increment& increment, const solve::IncrementEnd& end) override;
  /// True once SIGINT or SIGTERM came.
  [[nodiscard]] bool stop_requested() const override;

  /// Takes the progress bar away; call it before anything else is printed.
  void clear();

 private:
  void draw_bar(const solve::Increment& increment, double load, const std::string& detail);

  std::ostream& out_;
  Terminal terminal_;
  Verbosity verbosity_;
  bool bar_is_drawn_ = false;
};

}  // namespace facies::cli
