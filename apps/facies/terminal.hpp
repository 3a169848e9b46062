// SPDX-License-Identifier: Apache-2.0
// What stands behind standard error: a person at a terminal, or a file.
#pragma once

namespace facies::cli {

struct Terminal {
  bool interactive = false;  ///< lines can be rewritten
  bool colour = false;       ///< interactive, and NO_COLOR is not set
  int width = 80;            ///< columns
};

/// The terminal behind standard error. TERM=dumb counts as none.
[[nodiscard]] Terminal error_terminal();

}  // namespace facies::cli
