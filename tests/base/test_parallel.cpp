// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "facies/base/parallel.hpp"

namespace facies {
namespace {

std::vector<double> roots(std::size_t n, int threads) {
  std::vector<double> result(n, -1.0);
  parallel_for(n, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      result[i] = std::sqrt(static_cast<double>(i));
  });
  return result;
}

TEST(ParallelFor, GivesTheSameOnAnyNumberOfThreads) {
  const std::vector<double> alone = roots(1001, 1);
  for (const int threads : {-1, 0, 2, 3, 7, 64})
    EXPECT_EQ(roots(1001, threads), alone) << threads;
}

TEST(ParallelFor, VisitsEverythingExactlyOnce) {
  for (const std::size_t n : {1U, 2U, 5U, 97U}) {
    std::vector<std::atomic<int>> visits(n);
    parallel_for(n, 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        ++visits[i];
    });
    for (const std::atomic<int>& count : visits)
      EXPECT_EQ(count, 1);
  }
}

TEST(ParallelFor, DoesNothingForNothing) {
  parallel_for(0, 4, [](std::size_t, std::size_t) { FAIL() << "called"; });
}

TEST(ParallelFor, HandsOnAnExceptionOfTheBody) {
  for (const int threads : {1, 2, 4}) {
    const auto fails_in_the_middle = [](std::size_t begin, std::size_t end) {
      if (begin <= 50 && 50 < end) throw std::domain_error("50");
    };
    EXPECT_THROW(parallel_for(100, threads, fails_in_the_middle), std::domain_error) << threads;
  }
}

TEST(ParallelFor, HasAtLeastOneThread) {
  EXPECT_GE(available_threads(), 1);
}

}  // namespace
}  // namespace facies
