#include "bondstatic/units.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace bondstatic {
namespace {

/// A unit is scale * 10^power in SI. Powers of ten are kept apart and applied once, so that "2 mm" is the
/// double nearest to 0.002.
struct Unit {
  Dimension dimension;
  double scale = 1;
  int power = 0;
};

struct NamedUnit {
  std::string_view name;
  Unit unit;
  bool takes_prefix;
};

constexpr std::array named_units{
    NamedUnit{"m", {{0, 1, 0}}, true},
    NamedUnit{"g", {{1, 0, 0}, 1, -3}, true},
    NamedUnit{"s", {{0, 0, 1}}, true},
    NamedUnit{"min", {{0, 0, 1}, 6, 1}, false},
    NamedUnit{"h", {{0, 0, 1}, 36, 2}, false},
    NamedUnit{"t", {{1, 0, 0}, 1, 3}, false},
    NamedUnit{"N", {{1, 1, -2}}, true},
    NamedUnit{"Nm", {{1, 2, -2}}, true},
    NamedUnit{"J", {{1, 2, -2}}, true},
    NamedUnit{"Pa", {{1, -1, -2}}, true},
    NamedUnit{"bar", {{1, -1, -2}, 1, 5}, true},
    NamedUnit{"rad", {{}}, true},
    NamedUnit{"deg", {{}, std::numbers::pi / 180}, false},
    NamedUnit{"°", {{}, std::numbers::pi / 180}, false},
    NamedUnit{"%", {{}, 1, -2}, false},
    NamedUnit{"in", {{0, 1, 0}, 254, -4}, false},
    NamedUnit{"ft", {{0, 1, 0}, 3048, -4}, false},
    NamedUnit{"lbf", {{1, 1, -2}, 4.4482216152605}, false},
    NamedUnit{"psi", {{1, -1, -2}, 4.4482216152605 / 6.4516, 4}, false},
    NamedUnit{"ksi", {{1, -1, -2}, 4.4482216152605 / 6.4516, 7}, false},
};

struct Prefix {
  std::string_view name;
  int power;
};
constexpr std::array prefixes{Prefix{"n", -9}, Prefix{"u", -6}, Prefix{"µ", -6},
                              Prefix{"μ", -6}, Prefix{"m", -3}, Prefix{"c", -2},
                              Prefix{"k", 3},  Prefix{"M", 6},  Prefix{"G", 9}};

/// One unit with an optional prefix: "m" is a metre, "mm" a millimetre.
std::optional<Unit> find_unit(std::string_view name) {
  for (const NamedUnit& named : named_units)
    if (named.name == name) return named.unit;
  for (const Prefix& prefix : prefixes) {
    if (!name.starts_with(prefix.name)) continue;
    for (const NamedUnit& named : named_units)
      if (named.takes_prefix && named.name == name.substr(prefix.name.size())) {
        Unit unit = named.unit;
        unit.power += prefix.power;
        return unit;
      }
  }
  return std::nullopt;
}

void multiply(Unit& product, const Unit& factor, int exponent) {
  product.dimension.mass += exponent * factor.dimension.mass;
  product.dimension.length += exponent * factor.dimension.length;
  product.dimension.time += exponent * factor.dimension.time;
  product.scale *= std::pow(factor.scale, exponent);
  product.power += exponent * factor.power;
}

/// Takes one factor such as "mm", "m^2", "s2" or "m-3" from the front of `text`.
std::optional<Unit> take_factor(std::string_view& text, int sign) {
  const std::size_t name_end = std::min(text.find_first_of("^0123456789-+*/ \t"), text.size());
  std::size_t end = name_end;
  const auto unit = find_unit(text.substr(0, name_end));
  int exponent = 1;
  if (end < text.size() && text[end] == '^') ++end;
  const char* last = text.data() + text.size();
  if (end < text.size() && (text[end] == '-' || (text[end] >= '0' && text[end] <= '9'))) {
    const auto [stop, error] = std::from_chars(text.data() + end, last, exponent);
    if (error != std::errc() || std::abs(exponent) > 9) return std::nullopt;
    end = std::size_t(stop - text.data());
  } else if (end != name_end) {
    return std::nullopt;  // a lone ^
  }
  text.remove_prefix(end);
  if (!unit) return std::nullopt;
  Unit factor;
  multiply(factor, *unit, sign * exponent);
  return factor;
}

/// "kN m", "N*m", "Pa/m", "kg/m^3": a slash divides by the one factor that follows it.
std::optional<Unit> parse_unit(std::string_view text) {
  Unit unit;
  int sign = 1;
  for (bool first = true; !text.empty(); first = false) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    text.remove_prefix(begin);
    bool separated = first || begin > 0;
    sign = 1;
    if (!first && !text.empty() && (text[0] == '/' || text[0] == '*')) {
      sign = text[0] == '/' ? -1 : 1;
      text.remove_prefix(1);
      text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
      separated = true;
    }
    if (!separated) return std::nullopt;
    const auto factor = take_factor(text, sign);
    if (!factor) return std::nullopt;
    multiply(unit, *factor, 1);
  }
  return unit;
}

struct DimensionName {
  Dimension dimension;
  std::string_view name;
  std::string_view si;
  std::string_view units;
};
constexpr std::array dimension_names{
    DimensionName{dimension::none, "pure number", "", "rad, deg, %"},
    DimensionName{dimension::length, "length", "m", "nm, um, mm, cm, m, km, in, ft"},
    DimensionName{dimension::time, "time", "s", "ns, us, ms, s, min, h"},
    DimensionName{dimension::velocity, "velocity", "m/s", "nm/s, um/s, mm/s, cm/s, m/s, km/h"},
    DimensionName{dimension::density, "density", "kg/m3", "kg/m3, g/cm3, t/m3"},
    DimensionName{dimension::acceleration, "acceleration", "m/s2", "m/s2, mm/s2"},
    DimensionName{dimension::force, "force", "N", "mN, N, kN, MN, lbf"},
    DimensionName{dimension::moment, "moment", "N m", "N mm, N m, kN m, J"},
    DimensionName{dimension::stress, "stress", "Pa", "Pa, kPa, MPa, GPa, N/mm2, bar, psi, ksi"},
    DimensionName{dimension::stress_per_length, "stress per length", "Pa/m", "Pa/m, MPa/m, GPa/m, N/m3"},
    DimensionName{dimension::stiffness, "force per length", "N/m", "N/m, kN/m, MN/m, N/mm"},
};

const DimensionName* find_name(Dimension dimension) {
  for (const DimensionName& name : dimension_names)
    if (name.dimension == dimension) return &name;
  return nullptr;
}

std::string wanted(Dimension dimension) {
  const DimensionName* name = find_name(dimension);
  if (!name) return fmt::format("a quantity in {} is wanted", si_unit(dimension));
  return fmt::format("a {} is wanted, in {}", name->name, name->units);
}

}  // namespace

std::string si_unit(Dimension dimension) {
  if (const DimensionName* name = find_name(dimension)) return std::string(name->si);
  std::string text;
  const auto add = [&](const char* unit, int exponent) {
    if (exponent == 0) return;
    text += (text.empty() ? "" : " ") + std::string(unit) + (exponent == 1 ? "" : std::to_string(exponent));
  };
  add("kg", dimension.mass);
  add("m", dimension.length);
  add("s", dimension.time);
  return text;
}

double parse_quantity(std::string_view text, Dimension expected) {
  constexpr std::string_view blank = " \t";
  const auto fail = [&](const std::string& what) {
    throw std::invalid_argument(fmt::format("{}; {}", what, wanted(expected)));
  };
  std::string_view rest = text;
  rest.remove_prefix(std::min(rest.find_first_not_of(blank), rest.size()));
  while (!rest.empty() && blank.find(rest.back()) != std::string_view::npos) rest.remove_suffix(1);
  if (rest.starts_with('+') && !rest.starts_with("+-")) rest.remove_prefix(1);

  double number = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (error == std::errc::result_out_of_range) fail("the number is out of range");
  if (error != std::errc() || !std::isfinite(number)) fail("no number found");
  rest.remove_prefix(std::size_t(end - rest.data()));
  rest.remove_prefix(std::min(rest.find_first_not_of(blank), rest.size()));

  const auto unit = parse_unit(rest);
  if (!unit) fail(fmt::format("unknown unit \"{}\"", rest));
  if (!(unit->dimension == expected)) {
    const DimensionName* other = find_name(unit->dimension);
    fail(rest.empty() ? "the number has no unit"
                      : fmt::format("\"{}\" is not of this dimension{}", rest,
                                    other ? fmt::format(" but a {}", other->name) : ""));
  }
  const double scaled = number * unit->scale, power = std::pow(10.0, std::abs(unit->power));
  return unit->power < 0 ? scaled / power : scaled * power;
}

}  // namespace bondstatic
