// SPDX-License-Identifier: Apache-2.0
// Built with the law of docs/howto/add-a-law.md and a catalog with its line: the conformance tests, with one law more.
#include "test_conformance.cpp"

namespace facies::material {
namespace {

TEST(AddALaw, TakesOneFileAndOneLine) {
  EXPECT_NE(find_law("demiray"), nullptr);
}

}  // namespace
}  // namespace facies::material
