#include "formats/lammps/bond_coeffs.hpp"

#include <fmt/format.h>

#include <set>

namespace bondstatic {
namespace {

constexpr std::string_view rotational = "bpm/rotational";

}  // namespace

BondCoefficients read_bond_coefficients(DataSections& sections, RowFields& fields, const TypeNumbers& types,
                                        ImportNotes& notes) {
  constexpr std::size_t numbers = bpm_rotational_columns.size();
  BondCoefficients coefficients;
  std::string style = sections.style();
  const bool hybrid = style.starts_with("hybrid");
  Index left_out = 0;
  while (const auto row = sections.next_row()) {
    fields.take(*row);
    // In a hybrid style each row names its own.
    const bool named = fields.size() > 1 && fields.text(1) == rotational;
    const bool ours = named || style == rotational || (style.empty() && fields.size() == numbers + 1);
    if (!ours || (hybrid && !named)) {
      ++left_out;
      continue;
    }
    const std::size_t first = named ? 2 : 1;
    if (fields.size() != first + numbers) {
      fields.fault(0, fmt::format("{} coefficients; bpm/rotational has {}", fields.size() - first, numbers),
                   "give kr ks kt kb, four strengths and four dampings");
      continue;
    }
    const auto type = types.number(fields, 0, 1);
    std::array<double, numbers> values{};
    for (std::size_t i = 0; i < numbers; ++i) {
      const auto value = fields.number(first + i, bpm_rotational_columns[i]);
      values[i] = value.value_or(0);
      if (value && *value < 0 && i < bpm_rotational_stiffnesses)
        fields.fault(first + i,
                     fmt::format("{} = {} must not be negative", bpm_rotational_columns[i], *value),
                     "correct the stiffness");
    }
    if (type && !coefficients.emplace(*type, values).second)
      fields.fault(0, fmt::format("bond type {} has its coefficients twice", *type),
                   "remove one of the lines");
    if (fields.gave_up()) break;
  }
  if (left_out > 0)
    notes.left_out.push_back(
        fmt::format("Bond Coeffs of {} bond types, of a style other than bpm/rotational{}.", left_out,
                    style.empty() || hybrid ? "" : " (" + style + ")"));
  if (!coefficients.empty()) {
    if (style.empty())
      notes.assumed.push_back(
          "Bond Coeffs, whose style is not named, are those of bpm/rotational: they are twelve.");
    notes.taken.push_back(
        "Bond stiffness from Bond Coeffs # bpm/rotational (kr ks kt kb, contact point at mid-length), with "
        "strengths (force, force, twisting and bending moment, in the order of LAMMPS's source) and damping, "
        "which a static solve does not use.");
    notes.assumed.push_back(
        "`normalize no` and `smooth no` of bond_style bpm/rotational: a data file does not say them.");
  }
  return coefficients;
}

std::array<std::vector<double>*, bpm_rotational_columns.size()> bpm_rotational_values(ForeignModel& model) {
  std::array<std::vector<double>*, bpm_rotational_columns.size()> values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    auto& columns = i < bpm_rotational_stiffnesses ? model.bond_columns : model.kept_columns;
    values[i] = &columns[bpm_rotational_columns[i]];
    values[i]->resize(model.bonds.size(), not_given);
  }
  return values;
}

void spread_bond_coefficients(const BondCoefficients& coefficients, const Place& section, ForeignModel& model,
                              std::vector<Fault>& faults) {
  if (coefficients.empty()) return;
  const auto column = bpm_rotational_values(model);
  std::set<Index> missing;
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    const auto found = coefficients.find(model.bonds[k].type);
    if (found == coefficients.end())
      missing.insert(model.bonds[k].type);
    else
      for (std::size_t i = 0; i < column.size(); ++i) (*column[i])[k] = found->second[i];
  }
  LimitedFaults limited(faults);
  for (const Index type : missing)
    if (!limited.add(section, fmt::format("Bond Coeffs has no line for bond type {}", type),
                     "give the coefficients of every bond type, or leave the section out"))
      break;
}

}  // namespace bondstatic
