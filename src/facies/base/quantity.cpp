// SPDX-License-Identifier: Apache-2.0
#include "facies/base/quantity.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "facies/base/text.hpp"

namespace facies {

namespace {

constexpr Dimension number{};
constexpr Dimension mass{.mass = 1};
constexpr Dimension length{.length = 1};
constexpr Dimension duration{.time = 1};
constexpr Dimension angle{.angle = 1};
constexpr Dimension force{.mass = 1, .length = 1, .time = -2};
constexpr Dimension pressure{.mass = 1, .length = -1, .time = -2};

struct Symbol {
  std::string_view text;
  Dimension dimension;
  double numerator, denominator;
};

// The symbol that is proposed first stands first. 1 Pa = 1 N/m^2 = 1e-3 mN/mm^2.
constexpr std::array<Symbol, 18> symbols = {{
    {"kPa", pressure, 1, 1},
    {"Pa", pressure, 1, 1000},
    {"MPa", pressure, 1000, 1},
    {"GPa", pressure, 1e6, 1},
    {"mm", length, 1, 1},
    {"um", length, 1, 1000},
    {"cm", length, 10, 1},
    {"m", length, 1000, 1},
    {"kg", mass, 1, 1},
    {"g", mass, 1, 1000},
    {"mg", mass, 1, 1e6},
    {"s", duration, 1, 1},
    {"ms", duration, 1, 1000},
    {"N", force, 1000, 1},
    {"mN", force, 1, 1},
    {"kN", force, 1e6, 1},
    {"rad", angle, 1, 1},
    {"deg", angle, std::numbers::pi, 180},
}};

struct NamedDimension {
  Dimension dimension;
  std::string_view name;
};

constexpr std::array<NamedDimension, 14> named_dimensions = {{
    {number, "number"},
    {mass, "mass"},
    {length, "length"},
    {duration, "time"},
    {angle, "angle"},
    {force, "force"},
    {pressure, "pressure"},
    {{.length = 2}, "area"},
    {{.length = 3}, "volume"},
    {{.length = 1, .time = -1}, "velocity"},
    {{.length = 1, .time = -2}, "acceleration"},
    {{.mass = 1, .length = -3}, "density"},
    {{.mass = 1, .time = -2}, "stiffness"},
    {{.mass = 1, .length = 2, .time = -2}, "energy"},
}};

std::string with_article(const std::string& noun) {
  const bool vowel = std::string_view("aeio").find(noun.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + noun;
}

/// "a pressure such as 21.3 kPa".
std::string wanted(const Unit& like, std::string_view digits) {
  if (like.dimension == number) return "a number without a unit";
  return fmt::format("{} such as {} {}", with_article(name_of(like.dimension)), digits, like.text);
}

/// One symbol with its power, "s^2" or "kPa", multiplied (sign 1) or divided (sign -1) into `product`.
std::optional<Problem> multiply(Unit& product, std::string_view factor, int sign) {
  const std::size_t caret = factor.find('^');
  const std::string_view name = trim(factor.substr(0, caret));
  long power = 1;
  if (caret != std::string_view::npos) {
    const auto given = parse_integer(trim(factor.substr(caret + 1)));
    if (!given || *given == 0 || std::abs(*given) > 9) {
      return Problem{"", fmt::format("'{}' is not a power of a unit", factor),
                     "a whole number after '^', such as m/s^2", ""};
    }
    power = *given;
  }
  power *= sign;
  if (name == "1") return std::nullopt;
  for (const Symbol& symbol : symbols) {
    if (symbol.text != name) continue;
    const int times = static_cast<int>(power);
    product.dimension.mass += times * symbol.dimension.mass;
    product.dimension.length += times * symbol.dimension.length;
    product.dimension.time += times * symbol.dimension.time;
    product.dimension.angle += times * symbol.dimension.angle;
    const double above = std::pow(symbol.numerator, std::abs(power));
    const double below = std::pow(symbol.denominator, std::abs(power));
    product.numerator *= power > 0 ? above : below;
    product.denominator *= power > 0 ? below : above;
    return std::nullopt;
  }
  std::vector<std::string> known;
  known.reserve(symbols.size());
  for (const Symbol& symbol : symbols)
    known.emplace_back(symbol.text);
  return Problem{"", fmt::format("unknown unit '{}'", name), "", did_you_mean(name, known)};
}

/// A unit of mm-kg-s, spelled out: "kg*mm^-1*s^-2".
Unit base_unit(const Dimension& dimension) {
  std::string text;
  const auto append = [&text](const char* symbol, int power) {
    if (power == 0) return;
    if (!text.empty()) text += '*';
    text += symbol;
    if (power != 1) text += fmt::format("^{}", power);
  };
  append("kg", dimension.mass);
  append("mm", dimension.length);
  append("s", dimension.time);
  append("rad", dimension.angle);
  return {text, dimension};
}

double to_base(double value, const Unit& from) {
  return value * from.numerator / from.denominator;
}

}  // namespace

std::string name_of(const Dimension& dimension) {
  for (const NamedDimension& known : named_dimensions) {
    if (known.dimension == dimension) return std::string(known.name);
  }
  return "quantity";
}

std::variant<Unit, Problem> parse_unit(std::string_view text) {
  Unit product{std::string(trim(text)), {}};
  std::string_view rest = product.text;
  int sign = 1;
  while (!rest.empty()) {
    const std::size_t end = rest.find_first_of("*/");
    if (const auto problem = multiply(product, rest.substr(0, end), sign)) return *problem;
    if (end == std::string_view::npos) break;
    sign = rest[end] == '/' ? -1 : 1;
    rest.remove_prefix(end + 1);
    if (trim(rest).empty()) {
      return Problem{"", fmt::format("'{}' ends too early", product.text), "a unit such as m/s^2",
                     ""};
    }
  }
  return product;
}

Unit unit(std::string_view text) {
  auto parsed = parse_unit(text);
  require(std::holds_alternative<Unit>(parsed), "a unit in our own tables is misspelled");
  return std::get<Unit>(std::move(parsed));
}

std::vector<std::string> symbols_of(const Dimension& dimension) {
  std::vector<std::string> found;
  for (const Symbol& symbol : symbols) {
    if (symbol.dimension == dimension) found.emplace_back(symbol.text);
  }
  return found;
}

std::variant<double, Problem> parse_quantity(std::string_view text, const Unit& like) {
  text = trim(text);
  std::string_view body = text;
  if (body.starts_with('+') && !body.starts_with("+-")) body.remove_prefix(1);
  double value = 0.0;
  const auto [end, failure] = std::from_chars(body.data(), body.data() + body.size(), value);
  const std::string_view digits = body.substr(0, static_cast<std::size_t>(end - body.data()));
  const std::string_view unit_text = trim(body.substr(digits.size()));
  if (failure == std::errc::invalid_argument) {
    return Problem{"", fmt::format("'{}' is not a number", text), wanted(like, "1"), ""};
  }
  if (failure != std::errc{} || !std::isfinite(value)) {
    return Problem{"", fmt::format("'{}' is not a finite number", text), wanted(like, "1"), ""};
  }
  if (unit_text.starts_with(',')) {
    return Problem{"", fmt::format("'{}' has a comma", text), wanted(like, digits),
                   "decimals follow a point"};
  }
  if (unit_text.empty() && like.dimension != number) {
    return Problem{"", fmt::format("{} has no unit", text), wanted(like, digits), ""};
  }
  const auto parsed = parse_unit(unit_text);
  if (const auto* problem = std::get_if<Problem>(&parsed)) {
    return Problem{"", fmt::format("{} in '{}'", problem->found, text), wanted(like, digits),
                   problem->hint};
  }
  const Unit& given = std::get<Unit>(parsed);
  if (given.dimension != like.dimension) {
    return Problem{"", fmt::format("'{}' is {}", text, with_article(name_of(given.dimension))),
                   wanted(like, digits), ""};
  }
  const double converted = to_base(value, given);
  if (!std::isfinite(converted)) {
    return Problem{"", fmt::format("'{}' is not a finite number", text), wanted(like, "1"), ""};
  }
  return converted;
}

std::string format_quantity(double value, const Unit& in) {
  const auto written = [](const std::string& digits, const Unit& unit_used) {
    return unit_used.text.empty() ? digits : digits + ' ' + unit_used.text;
  };
  const double scaled = value / in.numerator * in.denominator;
  for (const int precision : {15, 16, 17}) {
    const std::string digits = fmt::format("{:.{}g}", scaled, precision);
    const auto back = parse_number(digits);
    if (back && to_base(*back, in) == value) return written(digits, in);
  }
  return written(fmt::format("{}", value), base_unit(in.dimension));
}

}  // namespace facies
