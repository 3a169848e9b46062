// SPDX-License-Identifier: Apache-2.0
// The catalog of faces.
#include <gmock/gmock.h>

#include "anatomy/reference_face.hpp"
#include <gtest/gtest.h>

#include "facies/anatomy/sources.hpp"

namespace facies::anatomy {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& spec) {
  try {
    (void)load_face(spec, data_folder());
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(Sources, AreListedWithUsageAndSummary) {
  std::vector<std::string> names;
  for (const SourceSpec& source : sources()) {
    names.push_back(source.name);
    EXPECT_TRUE(source.usage.starts_with(source.name)) << source.usage;
    EXPECT_FALSE(source.summary.empty());
  }
  EXPECT_THAT(names, testing::ElementsAre("builtin", "patch", "artisynth"));
}

TEST(Sources, MakeAPatchWithAndWithoutOptions) {
  EXPECT_EQ(load_face("patch", data_folder()).source, "patch");
  EXPECT_EQ(load_face("patch:ny=4", data_folder()).source, "patch:ny=4");
}

TEST(Sources, SuggestTheSourceThatWasMeant) {
  EXPECT_THAT(refusal("artisinth:/tmp"), HasSubstr("did you mean 'artisynth'?"));
  EXPECT_THAT(refusal("Patch:ny=4"), HasSubstr("did you mean 'patch'?"));
  EXPECT_THAT(refusal(""), HasSubstr("known: builtin, patch, artisynth"));
}

TEST(Sources, WantAFolderForTheReferenceFace) {
  EXPECT_THAT(refusal("artisynth"), HasSubstr("no folder"));
  EXPECT_THAT(refusal("artisynth:"), HasSubstr("artisynth:DIR"));
}

}  // namespace
}  // namespace facies::anatomy
