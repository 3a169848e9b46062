// SPDX-License-Identifier: Apache-2.0
// Ctrl-C: the first one asks the run to stop where it can be left, the second one ends the program.
#pragma once

namespace facies::cli {

/// Listens for SIGINT and SIGTERM from now on.
void listen_for_stop();

/// True once one of them came.
[[nodiscard]] bool stop_was_requested();

}  // namespace facies::cli
