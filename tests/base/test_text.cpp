// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "facies/base/text.hpp"

namespace facies {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::vector<std::string> muscles = {"ZYG", "LLSAN", "LAO", "RIS", "orbicularis_oris"};

TEST(NearestWord, FindsASlipOfTheFinger) {
  EXPECT_EQ(nearest_word("LLSN", muscles), "LLSAN");
  EXPECT_EQ(nearest_word("YZG", muscles), "ZYG");  // two letters swapped are one mistake
  EXPECT_EQ(nearest_word("orbicularis-ori", muscles), "orbicularis_oris");
}

TEST(NearestWord, IgnoresCase) {
  EXPECT_EQ(nearest_word("zyg", muscles), "ZYG");
}

TEST(NearestWord, DoesNotGuessWildly) {
  EXPECT_EQ(nearest_word("temporalis", muscles), std::nullopt);
  EXPECT_EQ(nearest_word("", muscles), std::nullopt);
  EXPECT_EQ(nearest_word("ZYG", std::vector<std::string>{}), std::nullopt);
}

TEST(NearestWord, DoesNotTurnOneLetterIntoAnother) {
  EXPECT_EQ(nearest_word("b", std::vector<std::string>{"c"}), std::nullopt);
}

TEST(NearestWord, PrefersTheNearest) {
  EXPECT_EQ(nearest_word("kapa", std::vector<std::string>{"kappa1", "kappa", "kampa3"}), "kappa");
}

TEST(DidYouMean, OffersTheNearestOrTheList) {
  const std::vector<std::string> known = {"c", "mu1"};
  EXPECT_EQ(did_you_mean("mu", known), "did you mean 'mu1'?");
  EXPECT_EQ(did_you_mean("young", known), "known: c, mu1");
  EXPECT_EQ(did_you_mean("young", std::vector<std::string>{}), "none is known");
}

TEST(Split, AtBlanksDropsEmptyFields) {
  EXPECT_THAT(split_blanks("  12\t 0.5  -3e2\r\n"), ElementsAre("12", "0.5", "-3e2"));
  EXPECT_THAT(split_blanks(" \t "), IsEmpty());
  EXPECT_THAT(split_blanks(""), IsEmpty());
}

TEST(Split, AtASeparatorKeepsEmptyFields) {
  EXPECT_THAT(split("a, b,,c ", ','), ElementsAre("a", "b", "", "c"));
  EXPECT_THAT(split("", ','), ElementsAre(""));
}

TEST(Trim, CutsBothEndsOnly) {
  EXPECT_EQ(trim(" \t a b \r\n"), "a b");
  EXPECT_EQ(trim(" \n"), "");
}

TEST(ParseNumber, TakesWholeFiniteNumbers) {
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_EQ(parse_number("-2e-3"), -2e-3);
  EXPECT_EQ(parse_number("+7"), 7.0);
}

TEST(ParseNumber, RefusesEverythingElse) {
  for (const char* text :
       {"", "+", "1.5x", "1 2", " 1", "nan", "inf", "-inf", "1e999", "0x10", "+-1"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
}

TEST(ParseInteger, TakesWholeIntegersOnly) {
  EXPECT_EQ(parse_integer("-42"), -42);
  EXPECT_EQ(parse_integer("+7"), 7);
  for (const char* text : {"", "1.0", "1e3", "12a", "99999999999999999999", "+-1"}) {
    EXPECT_EQ(parse_integer(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace facies
