// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "facies/anatomy/builtin_options.hpp"

namespace facies::anatomy {
namespace {

using testing::HasSubstr;

std::vector<FaceMeasure> measures() {
  FaceMeasure mouth;
  mouth.key = "mouth_width";
  mouth.meaning = "width of the mouth";
  mouth.smallest = 40.0;
  mouth.largest = 62.0;
  FaceMeasure nose = mouth;
  nose.key = "nose_width";
  return {mouth, nose};
}

BuiltinOptions parsed(const std::string& text) {
  return parse_builtin_options(text, measures(), {});
}

/// What is told about these options.
std::string refusal(const std::string& text) {
  try {
    (void)parsed(text);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(BuiltinOptions, HaveDefaults) {
  const BuiltinOptions options = parsed("");
  EXPECT_EQ(options.size, FaceSize::standard);
  EXPECT_FALSE(options.female);
  EXPECT_TRUE(options.given.empty());
}

TEST(BuiltinOptions, AreTheDefaultsThatTheUsageShows) {
  const std::string usage = builtin_usage();
  ASSERT_TRUE(usage.starts_with("builtin:"));
  const BuiltinOptions shown = parsed(usage.substr(8));
  EXPECT_EQ(shown.size, parsed("").size);
  EXPECT_EQ(shown.female, parsed("").female);
}

TEST(BuiltinOptions, AreTakenInAnyOrderAndUnit) {
  const BuiltinOptions options =
      parsed("mouth_width=47 mm, size = fine ,preset=female,nose_width=4.5 cm");
  EXPECT_EQ(options.size, FaceSize::fine);
  EXPECT_TRUE(options.female);
  EXPECT_EQ(options.given.at("mouth_width"), 47.0);
  EXPECT_NEAR(options.given.at("nose_width"), 45.0, 1e-12);
  EXPECT_EQ(parsed("size=coarse").size, FaceSize::coarse);
  EXPECT_EQ(parsed("size=finer").size, FaceSize::finer);
}

TEST(BuiltinOptions, RefuseAllThatIsWrongAtOnce) {
  const std::string told =
      refusal("sise=fine,preset=mal,mouth_width=47,nose_width=90 mm,size=big,size=fine,,female");
  EXPECT_THAT(told, HasSubstr("builtin:sise: unknown option\n    did you mean 'size'?"));
  EXPECT_THAT(told, HasSubstr("builtin:preset: 'mal'; expected male or female"));
  EXPECT_THAT(told, HasSubstr("builtin:mouth_width: "));
  EXPECT_THAT(told, HasSubstr("builtin:nose_width: 90 mm; expected 40 mm to 62 mm"));
  EXPECT_THAT(told, HasSubstr("builtin:size: 'big'; expected coarse, standard, fine or finer"));
  EXPECT_THAT(told, HasSubstr("builtin:size: given twice"));
  EXPECT_THAT(told, HasSubstr("builtin:: unknown option"));
  EXPECT_THAT(told, HasSubstr("builtin:female: unknown option"));
}

TEST(BuiltinOptions, RefuseWhatIsNoLength) {
  for (const char* wrong : {"", "wide", "47", "47 kPa", "nan mm", "inf mm", "-50 mm", "1e400 mm"})
    EXPECT_THAT(refusal(std::string("mouth_width=") + wrong), HasSubstr("builtin:mouth_width"))
        << wrong;
}

}  // namespace
}  // namespace facies::anatomy
