// SPDX-License-Identifier: Apache-2.0
// Loops over several threads whose results do not depend on how many there are.
#pragma once

#include <cstddef>
#include <functional>

namespace facies {

/// Threads that a loop may use on this machine (OMP_NUM_THREADS is respected).
[[nodiscard]] int available_threads();

/// Calls body(begin, end) on disjoint ranges that together cover [0, n), on at most `threads` threads.
/// The body must not depend on where the ranges are cut. An exception of the body is rethrown here.
void parallel_for(std::size_t n, int threads,
                  const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace facies
