// SPDX-License-Identifier: Apache-2.0
// Numbers with units: "21.3 kPa", "9.8 m/s^2", "1040 kg/m^3". Read with the dimension checked, written so that they
// read back to the same bits.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "facies/base/error.hpp"

namespace facies {

/// Powers of mass, length, time and angle. Angle has its own place so that degrees need their unit.
struct Dimension {
  int mass = 0, length = 0, time = 0, angle = 0;

  friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// What a dimension is called in messages: "pressure", "length", "number" ...; "quantity" where it has no name here.
[[nodiscard]] std::string name_of(const Dimension& dimension);

/// A unit such as "kPa", "m/s^2" or "" (dimensionless). One of it is numerator / denominator units of mm-kg-s-rad
/// (mN, kPa, mm/s^2, kg/mm^3); both are whole numbers but for degrees, so that a conversion rounds once.
struct Unit {
  std::string text;
  Dimension dimension;
  double numerator = 1.0, denominator = 1.0;
};

/// The unit that `text` spells: symbols with whole powers, joined by "*" or "/" (each "/" divides by what follows it
/// alone): "N/mm^2", "kg*mm/s^2". A problem where a symbol is unknown or the text is no unit.
[[nodiscard]] std::variant<Unit, Problem> parse_unit(std::string_view text);

/// A unit that is known to be right, as written in our own tables. Throws BugError where it is not.
[[nodiscard]] Unit unit(std::string_view text);

/// Every unit symbol with the given dimension, in the order in which they are proposed: {"kPa", "Pa", ...}.
[[nodiscard]] std::vector<std::string> symbols_of(const Dimension& dimension);

/// The value of "21.3 kPa" in mm-kg-s units, or what is wrong with it: not a finite number, no unit, an unknown unit, a
/// unit of another dimension. `like` is a unit that would do, named in messages. Dimensionless numbers have no unit.
[[nodiscard]] std::variant<double, Problem> parse_quantity(std::string_view text, const Unit& like);

/// `value` (mm-kg-s) written in `in`, e.g. "21.3 kPa", with as few digits as read back to the same bits; in mm-kg-s
/// units where no digits in `in` do.
[[nodiscard]] std::string format_quantity(double value, const Unit& in);

}  // namespace facies
