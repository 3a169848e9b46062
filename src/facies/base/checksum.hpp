// SPDX-License-Identifier: Apache-2.0
// Fingerprints of content, so that a result can say what it was made from.
#pragma once

#include <string>
#include <string_view>

namespace facies {

/// SHA-256 (FIPS 180-4) as 64 lower-case hexadecimal digits, as sha256sum prints it.
[[nodiscard]] std::string sha256(std::string_view content);

}  // namespace facies
