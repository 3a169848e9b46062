// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <sstream>

#include "apps/facies/console_observer.hpp"
#include <gtest/gtest.h>

namespace facies::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

/// One increment of two iterations, as a run reports it.
std::string told(const Terminal& terminal, Verbosity verbosity) {
  std::ostringstream out;
  ConsoleObserver observer(out, terminal, verbosity);
  const solve::Increment increment{"release", 2, 3, 4, 0.25, 0.5};
  observer.increment_begins(increment);
  observer.iteration_done(increment, {0, 12.5, 1e-2, 0.0, 0.0, 0.0, 1});
  observer.iteration_done(increment, {1, 1.25e-4, 1e-7, 0.5, 1.0, 0.0, 1});
  observer.increment_ends(increment, {true, "residual 1e-07 of the load", 1, 1.25e-4, 1e-7, 3, {}});
  return out.str();
}

TEST(ConsoleObserver, WritesOneLinePerIncrementWhereThereIsNoTerminal) {
  EXPECT_EQ(
      told({}, Verbosity::normal),
      "step 2/3 release, increment 4, load 0.25 to 0.5: converged after 1 iterations (residual "
      "1e-07 of the load)\n");
}

TEST(ConsoleObserver, SaysNothingWhenAskedToBeQuiet) {
  EXPECT_EQ(told({}, Verbosity::quiet), "");
  EXPECT_EQ(told({true, true, 80}, Verbosity::quiet), "");
}

TEST(ConsoleObserver, WritesTheConvergenceTableWhenAskedTo) {
  const std::string text = told({true, false, 80}, Verbosity::verbose);
  EXPECT_THAT(text,
              HasSubstr("iteration   |r| [mN]   relative  |du| [mm]   step    shift factors"));
  EXPECT_THAT(text,
              HasSubstr("        1  1.250e-04  1.000e-07  5.000e-01      1        0       1\n"));
  EXPECT_THAT(text, Not(HasSubstr("\r")));
}

TEST(ConsoleObserver, KeepsItsBarOnOneLineOfAnyWidth) {
  for (const int width : {1, 10, 20, 40, 80, 300}) {
    std::istringstream lines(told({true, false, width}, Verbosity::normal));
    for (std::string line; std::getline(lines, line, '\r');) {
      const std::string clear = "\x1b[K";
      if (line.starts_with(clear)) line.erase(0, clear.size());
      EXPECT_LE(line.size(), std::max<std::size_t>(static_cast<std::size_t>(width), 7)) << line;
      EXPECT_EQ(line.find('\n'), std::string::npos);
    }
  }
}

TEST(ConsoleObserver, ShowsHowMuchOfTheRunIsDone) {
  EXPECT_THAT(told({true, false, 100}, Verbosity::normal),
              HasSubstr(" 50%] step 2/3 release"));  // (1 + 0.5) / 3
}

TEST(ConsoleObserver, UsesColourOnlyWhereItIsWanted) {
  EXPECT_THAT(told({true, true, 80}, Verbosity::normal), HasSubstr("\x1b[32m"));
  EXPECT_THAT(told({true, false, 80}, Verbosity::normal), Not(HasSubstr("\x1b[32m")));
}

TEST(ConsoleObserver, SaysWhichElementStoodInTheWay) {
  std::ostringstream out;
  ConsoleObserver observer(out, {}, Verbosity::normal);
  solve::IncrementEnd end;
  end.reason = "no admissible step";
  end.inadmissible = {17, -0.25};
  observer.increment_ends({"express", 3, 3, 1, 0.0, 1.0}, end);
  EXPECT_THAT(
      out.str(),
      HasSubstr("not converged after 0 iterations (no admissible step); element 17 would be "
                "inside out (det F = -0.25)"));
}

}  // namespace
}  // namespace facies::cli
