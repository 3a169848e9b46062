// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "facies/base/quantity.hpp"

namespace facies {
namespace {

double value_of(const std::string& text, const std::string& like) {
  const auto parsed = parse_quantity(text, unit(like));
  if (const auto* problem = std::get_if<Problem>(&parsed)) {
    ADD_FAILURE() << to_string(*problem);
    return std::nan("");
  }
  return std::get<double>(parsed);
}

std::string message_of(const std::string& text, const std::string& like) {
  const auto parsed = parse_quantity(text, unit(like));
  const auto* problem = std::get_if<Problem>(&parsed);
  return problem == nullptr ? "no problem" : to_string(*problem);
}

TEST(Quantity, IsConvertedToMillimetresKilogramsAndSeconds) {
  EXPECT_EQ(value_of("21.3 kPa", "kPa"), 21.3);
  EXPECT_EQ(value_of("21300 Pa", "kPa"), 21.3);
  EXPECT_EQ(value_of("0.0213 MPa", "kPa"), 21.3);
  EXPECT_EQ(value_of("9.81 m/s^2", "m/s^2"), 9810.0);
  EXPECT_EQ(value_of("9810 mm/s^2", "m/s^2"), 9810.0);
  EXPECT_EQ(value_of("6 mm", "mm"), 6.0);
  EXPECT_EQ(value_of("0.6 cm", "mm"), 6.0);
  EXPECT_EQ(value_of("1040 kg/m^3", "kg/m^3"), 1040e-9);
  EXPECT_EQ(value_of("1.04 g/cm^3", "kg/m^3"), 1.04e-6);
  EXPECT_EQ(value_of("0.5 s", "s"), 0.5);
  EXPECT_EQ(value_of("500 ms", "s"), 0.5);
  EXPECT_DOUBLE_EQ(value_of("30 deg", "deg"), std::numbers::pi / 6);
  EXPECT_EQ(value_of("40 N", "N"), 40000.0);
  EXPECT_EQ(value_of("0.5", ""), 0.5);
}

TEST(Quantity, OfOneDimensionMayBeSpelledInManyWays) {
  EXPECT_EQ(value_of("3 N/mm^2", "kPa"), 3000.0);
  EXPECT_EQ(value_of("3 kg/mm/s^2", "kPa"), 3.0);
  EXPECT_EQ(value_of("3 kg*mm^-1*s^-2", "kPa"), 3.0);
  EXPECT_EQ(value_of("  +3e0kPa ", "kPa"), 3.0);
  EXPECT_EQ(value_of("-.5 1/s", "1/s"), -0.5);
}

TEST(Quantity, WithoutItsUnitIsRefused) {
  EXPECT_EQ(message_of("21.3", "kPa"), "21.3 has no unit; expected a pressure such as 21.3 kPa");
  EXPECT_EQ(message_of("0", "m/s^2"), "0 has no unit; expected an acceleration such as 0 m/s^2");
}

TEST(Quantity, OfAnotherDimensionIsRefused) {
  EXPECT_EQ(message_of("6 mm", "kPa"), "'6 mm' is a length; expected a pressure such as 6 kPa");
  EXPECT_EQ(message_of("0.5 kPa", ""), "'0.5 kPa' is a pressure; expected a number without a unit");
  EXPECT_EQ(message_of("30 rad", ""), "'30 rad' is an angle; expected a number without a unit");
}

TEST(Quantity, WithAnUnknownUnitIsRefusedWithAGuess) {
  EXPECT_EQ(message_of("21.3 kpa", "kPa"),
            "unknown unit 'kpa' in '21.3 kpa'; expected a pressure such as 21.3 kPa\n"
            "    did you mean 'kPa'?");
  EXPECT_NE(message_of("3 m/s^x", "m/s^2").find("'s^x' is not a power of a unit"),
            std::string::npos);
  EXPECT_NE(message_of("3 m/s^99", "m/s^2").find("'s^99' is not a power of a unit"),
            std::string::npos);
  EXPECT_NE(message_of("3 m/", "m/s^2").find("'m/' ends too early"), std::string::npos);
  EXPECT_NE(message_of("3 m//s", "m/s^2").find("unknown unit ''"), std::string::npos);
}

TEST(Quantity, ThatIsNoFiniteNumberIsRefused) {
  EXPECT_EQ(message_of("much", "kPa"), "'much' is not a number; expected a pressure such as 1 kPa");
  EXPECT_EQ(message_of("", "kPa"), "'' is not a number; expected a pressure such as 1 kPa");
  EXPECT_NE(message_of("+-1 kPa", "kPa").find("is not a number"), std::string::npos);
  for (const char* text : {"nan kPa", "inf kPa", "-inf kPa", "1e999 kPa", "1e308 GPa"}) {
    EXPECT_NE(message_of(text, "kPa").find("is not a finite number"), std::string::npos) << text;
  }
  EXPECT_EQ(
      message_of("21,3 kPa", "kPa"),
      "'21,3 kPa' has a comma; expected a pressure such as 21 kPa\n    decimals follow a point");
}

TEST(Quantity, IsWrittenWithAsFewDigitsAsReadBackToTheSameBits) {
  EXPECT_EQ(format_quantity(21.3, unit("kPa")), "21.3 kPa");
  EXPECT_EQ(format_quantity(9800.0, unit("m/s^2")), "9.8 m/s^2");
  EXPECT_EQ(format_quantity(1040e-9, unit("kg/m^3")), "1040 kg/m^3");
  EXPECT_EQ(format_quantity(1.1, unit("")), "1.1");
}

TEST(Quantity, ReadsBackToTheSameBitsWhateverItsUnit) {
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> exponent(-9.0, 9.0);
  for (const char* text : {"", "kPa", "Pa", "m/s^2", "kg/m^3", "deg", "um", "N/mm", "kg*m^2/s^2"}) {
    const Unit in = unit(text);
    for (int i = 0; i < 2000; ++i) {
      const double value = (i % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, exponent(generator));
      const std::string written = format_quantity(value, in);
      EXPECT_EQ(value_of(written, text), value) << written;
    }
  }
}

TEST(Unit, MisspelledInOurOwnTablesIsADefect) {
  EXPECT_THROW((void)unit("kilopascal"), BugError);
}

}  // namespace
}  // namespace facies
