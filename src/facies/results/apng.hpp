// SPDX-License-Identifier: Apache-2.0
// Animated PNG files from PNG files of equal size (docs/decisions/animated-png.md).
#pragma once

#include <span>
#include <string>

namespace facies::results {

struct AnimationFrame {
  std::string png;       ///< of one size and kind of pixel in all frames
  int milliseconds = 0;  ///< how long it is shown, 1 to 65535
};

/// The frames one after the other, again and again. The pixels are those of the PNG files, bit by bit. Programs that do not know
/// animations show the first frame. Throws BugError where there is no frame, a file is no PNG file or differs from the first in
/// size or kind.
[[nodiscard]] std::string to_apng(std::span<const AnimationFrame> frames);

}  // namespace facies::results
