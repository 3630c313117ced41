#include "formats/table/column_units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "io/nearest_name.hpp"

namespace bondstatic {
namespace {

/// As parse_quantity wants it: "N·m", "N.m" and "kg/m³" have other spellings here.
std::string plain_unit(std::string unit) {
  const std::vector<std::pair<std::string, std::string>> spellings{
      {"·", " "}, {".", " "}, {"**", "^"}, {"²", "2"}, {"³", "3"}};
  for (const auto& [from, to] : spellings)
    for (std::size_t at = unit.find(from); at != std::string::npos; at = unit.find(from, at))
      unit.replace(at, from.size(), to);
  return unit;
}

/// What one of the unit is in SI; the message of the exception names the units there are.
double in_si(const std::string& unit, Dimension dimension) {
  return parse_quantity("1 " + plain_unit(unit), dimension);
}

}  // namespace

bool has_unit_of(const ColumnName& heading, Dimension dimension) {
  if (heading.unit.empty()) return false;
  try {
    in_si(heading.unit, dimension);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

void bring_to_si(TableColumn& column, Dimension dimension, UnitsSeen& seen, std::vector<Fault>& faults) {
  const std::string unit = std::exchange(column.heading.unit, "");
  if (unit.empty()) {
    if (!(dimension == dimension::none)) seen.without.push_back(column.heading.text);
    return;
  }
  if (unit == "-" && dimension == dimension::none) return;
  double scale = 1;
  try {
    scale = in_si(unit, dimension);
  } catch (const std::invalid_argument& what) {
    faults.push_back({column.place,
                      fmt::format("unit of column \"{}\": {}", column.heading.text, what.what()),
                      "correct the unit in the heading, or leave it out where numbers are SI"});
    return;
  }
  // Degrees are no sign of SI.
  if (!(dimension == dimension::none)) seen.with.push_back(column.heading.text);
  if (scale == 1) return;
  // 2 mm is the double nearest to 0.002: a division by 1000 is, a product with 0.001 is not always.
  const double inverse = std::round(1 / scale);
  const bool divides = scale < 1 && inverse * scale == 1;
  for (double& number : column.numbers) number = divides ? number / inverse : number * scale;
}

bool note_units(const UnitsSeen& seen, bool edem, ImportNotes& notes) {
  if (!seen.with.empty()) {
    notes.taken.push_back(
        fmt::format("Units of the headings are honoured, numbers are SI: {}.", name_list(seen.with)));
    if (!seen.without.empty())
      notes.assumed.push_back(fmt::format("These headings have no unit, their numbers are taken as SI: {}.",
                                          name_list(seen.without)));
    return true;
  }
  if (edem)
    notes.assumed.push_back(
        "The export has no units: numbers are taken as they are; EDEM writes them in the units that are "
        "chosen in its options, which need not be SI.");
  return false;
}

}  // namespace bondstatic
