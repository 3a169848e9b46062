// SPDX-License-Identifier: Apache-2.0
// What lets threads add to nodes without meeting.
#include <algorithm>
#include <set>

#include "support/blocks.hpp"
#include <gtest/gtest.h>

#include "facies/mechanics/colouring.hpp"

namespace facies::mechanics {
namespace {

using support::BlockCells;

class Colouring : public ::testing::TestWithParam<BlockCells> {
 protected:
  mesh::Mesh mesh_ = support::make_block({.n = {4, 3, 3}, .cells = GetParam()});
  std::vector<std::vector<Index>> colours_ = colour_elements(mesh_);
};

TEST_P(Colouring, LetsNoTwoElementsOfAColourShareANode) {
  for (const std::vector<Index>& colour : colours_) {
    std::set<Index> taken;
    for (const Index e : colour) {
      for (const Index node : mesh_.element(e).connectivity())
        EXPECT_TRUE(taken.insert(node).second) << "element " << e << " node " << node;
    }
  }
}

TEST_P(Colouring, ListsEveryElementOnce) {
  std::vector<Index> listed;
  for (const std::vector<Index>& colour : colours_)
    listed.insert(listed.end(), colour.begin(), colour.end());
  std::sort(listed.begin(), listed.end());
  ASSERT_EQ(listed.size(), mesh_.n_elements());
  for (std::size_t e = 0; e < listed.size(); ++e)
    EXPECT_EQ(listed[e], to_index(e));
}

INSTANTIATE_TEST_SUITE_P(Blocks, Colouring,
                         ::testing::Values(BlockCells::hexahedra, BlockCells::wedges,
                                           BlockCells::mixed),
                         [](const auto& which) { return support::name_of(which.param); });

TEST(ColouringOfARegularBlock, NeedsEightColours) {
  // Eight hexahedra meet at an inner node, so fewer cannot do; the greedy order needs no more.
  EXPECT_EQ(colour_elements(support::make_block({.n = {4, 4, 4}})).size(), 8U);
}

TEST(ColouringOfNothing, HasNoColours) {
  EXPECT_TRUE(colour_elements(mesh::Mesh()).empty());
}

}  // namespace
}  // namespace facies::mechanics
