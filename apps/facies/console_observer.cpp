// SPDX-License-Identifier: Apache-2.0
#include "apps/facies/console_observer.hpp"

#include <algorithm>
#include <ostream>

#include "apps/facies/signals.hpp"
#include <fmt/format.h>

namespace facies::cli {

namespace {

std::string label(const solve::Increment& increment) {
  return fmt::format("step {}/{} {}", increment.step_number, increment.n_steps, increment.step);
}

}  // namespace

ConsoleObserver::ConsoleObserver(std::ostream& out, Terminal terminal, Verbosity verbosity)
    : out_(out), terminal_(terminal), verbosity_(verbosity) {}

void ConsoleObserver::increment_begins(const solve::Increment& increment) {
  if (verbosity_ == Verbosity::verbose) {
    out_ << fmt::format("{}, increment {}, load {:.4g} to {:.4g}\n", label(increment),
                        increment.number, increment.from, increment.to)
         << fmt::format("{:>9} {:>10} {:>10} {:>10} {:>6} {:>8} {:>7}\n", "iteration", "|r| [mN]",
                        "relative", "|du| [mm]", "step", "shift", "factors")
         << std::flush;
  } else if (verbosity_ == Verbosity::normal && terminal_.interactive) {
    draw_bar(increment, increment.from, fmt::format("increment {}", increment.number));
  }
}

void ConsoleObserver::iteration_done(const solve::Increment& increment,
                                     const solve::Iteration& iteration) {
  if (verbosity_ == Verbosity::verbose) {
    out_ << fmt::format("{:>9} {:>10.3e} {:>10.3e} {:>10.3e} {:>6.3g} {:>8.2g} {:>7}{}\n",
                        iteration.number, iteration.residual, iteration.relative,
                        iteration.correction, iteration.step_length, iteration.shift,
                        iteration.factorisations, iteration.exact ? "" : " +")
         << std::flush;
  } else if (verbosity_ == Verbosity::normal && terminal_.interactive) {
    draw_bar(increment, increment.from,
             fmt::format("increment {}, iteration {}, residual {:.1e}", increment.number,
                         iteration.number, iteration.relative));
  }
}

void ConsoleObserver::increment_ends(const solve::Increment& increment,
                                     const solve::IncrementEnd& end) {
  if (verbosity_ == Verbosity::quiet) return;
  if (verbosity_ == Verbosity::normal && terminal_.interactive) {
    draw_bar(increment, end.converged ? increment.to : increment.from, end.reason);
    return;
  }
  std::string text =
      fmt::format("{}, increment {}, load {:.4g} to {:.4g}: {} after {} iterations ({})",
                  label(increment), increment.number, increment.from, increment.to,
                  end.converged ? "converged" : "not converged", end.iterations, end.reason);
  if (!end.converged && end.inadmissible.element >= 0) {
    text += "; " + mechanics::describe(end.inadmissible);
  }
  out_ << text << '\n' << std::flush;
}

bool ConsoleObserver::stop_requested() const {
  return stop_was_requested();
}

void ConsoleObserver::clear() {
  if (bar_is_drawn_) out_ << "\r\x1b[K" << std::flush;
  bar_is_drawn_ = false;
}

void ConsoleObserver::draw_bar(const solve::Increment& increment, double load,
                               const std::string& detail) {
  const double done =
      (increment.step_number - 1 + std::clamp(load, 0.0, 1.0)) / std::max(increment.n_steps, 1);
  const int cells = std::clamp(terminal_.width / 4, 4, 30);
  const int full = std::clamp(static_cast<int>(done * cells), 0, cells);
  const auto part = [](int n, char c) { return std::string(static_cast<std::size_t>(n), c); };
  std::string text = fmt::format("{:3.0f}%] {}: {}", 100.0 * done, label(increment), detail);
  // One column stays free: a full line would make the terminal scroll.
  const int room = std::max(terminal_.width - cells - 3, 0);
  text.resize(std::min(text.size(), static_cast<std::size_t>(room)));
  const std::string bar = part(full, '#') + part(cells - full, '-');
  out_ << "\r\x1b[K[" << (terminal_.colour ? "\x1b[32m" + bar + "\x1b[0m" : bar) << ' ' << text
       << std::flush;
  bar_is_drawn_ = true;
}

}  // namespace facies::cli
