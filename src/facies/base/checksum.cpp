// SPDX-License-Identifier: Apache-2.0
#include "facies/base/checksum.hpp"

#include <array>
#include <openssl/evp.h>

#include <fmt/format.h>

#include "facies/base/error.hpp"

namespace facies {

std::string sha256(std::string_view content) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  const int done =
      EVP_Digest(content.data(), content.size(), digest.data(), &size, EVP_sha256(), nullptr);
  require(done == 1, "libcrypto computes SHA-256");
  std::string text;
  for (unsigned int i = 0; i < size; ++i)
    text += fmt::format("{:02x}", digest[i]);
  return text;
}

}  // namespace facies
