#include "case/foreign_bonds.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/nearest_name.hpp"
#include "model/cell.hpp"

namespace bondstatic {
namespace {

constexpr int most_faults = 20;

void take_columns(Draft& draft, const std::string& path, ForeignModel& model, const BondLaw& law,
                  const GivenStrengths* strengths, BondRows& rows) {
  std::vector<std::string> stiffness, unused;
  const auto take_strength = [&](const std::string& name, std::vector<double>& values) {
    const Index strength = strengths ? strengths->criterion->find(name) : -1;
    if (strength >= 0) rows.strengths[std::size_t(strength)] = std::move(values);
    return strength >= 0;
  };
  for (auto& [name, values] : model.bond_columns) {
    const Index parameter = law.find(name);
    if (name == "contact_point")
      rows.fractions = std::move(values);
    else if (parameter >= 0)
      rows.overrides[std::size_t(parameter)] = std::move(values);
    else if (std::find(stiffness_names.begin(), stiffness_names.end(), name) != stiffness_names.end())
      stiffness.push_back(name);
    else if (!take_strength(name, values))
      unused.push_back(name);
  }
  for (auto& [name, values] : model.kept_columns)
    if (!take_strength(name, values)) unused.push_back(name);
  if (!stiffness.empty())
    draft.reading.warnings.push_back(fmt::format("{}: its stiffness ({}) is left out: the block has law {}",
                                                 path, name_list(stiffness), law.name));
  if (!unused.empty())
    draft.reading.warnings.push_back(fmt::format("{}: not used: {}", path, name_list(unused)));
}

/// A bond that a periodic file means to go through a face of its box would go the other way round.
void need_cell(Draft& draft, const ForeignModel& model, const BondRows& rows) {
  if (!model.cell || draft.model.cell || !draft.particles_known) return;
  Index across = 0;
  const std::vector<Particle>& particles = draft.model.particles;
  for (std::size_t k = 0; k < rows.a.size(); ++k) {
    const Vector3 branch =
        particles[std::size_t(rows.b[k])].position - particles[std::size_t(rows.a[k])].position;
    across += nearest_image(*model.cell, branch).image != CellImage{};
  }
  if (across > 0)
    draft.reading.fault(rows.places[0],
                        fmt::format("the file's box is periodic, and {} of its bonds go through its "
                                    "faces, but the case has no [cell]",
                                    across),
                        "add it; `bondstatic import` writes the table");
}

}  // namespace

std::optional<BondRows> rows_of_foreign_bonds(Draft& draft, const std::string& path, ForeignModel model,
                                              const BondLaw& law, const std::vector<double>& given,
                                              const GivenStrengths* strengths) {
  BondRows rows;
  const std::size_t count = model.bonds.size();
  rows.places = RowPlaces(path, model.bond_line, count);
  bool numbered = false;
  int unknown = 0;
  const auto position_of = [&](Index id, std::size_t row) {
    const Index* found = draft.particle_of_id.position_of(id);
    if (!found && draft.particles_known && ++unknown <= most_faults)
      draft.reading.fault(rows.places[row], fmt::format("there is no particle {}", id),
                          "bonds join particles by their ids: read all particles, and these ids, too");
    return found ? *found : -1;
  };
  for (std::size_t k = 0; k < count; ++k) {
    const ForeignBond& bond = model.bonds[k];
    rows.a.push_back(position_of(bond.a, k));
    rows.b.push_back(position_of(bond.b, k));
    rows.ids.push_back(bond.id);
    numbered |= bond.id >= 0;
  }
  if (!numbered) rows.ids.clear();
  if (unknown > 0) return std::nullopt;
  take_columns(draft, path, model, law, strengths, rows);
  const auto place_of = [&](Index row, Index) { return rows.places[std::size_t(row)]; };
  check_bond_parameters(draft, law, given, rows, place_of);
  check_bond_strengths(draft, strengths, rows, place_of);
  check_fractions(draft, rows, [&](Index row) { return rows.places[std::size_t(row)]; });
  need_cell(draft, model, rows);
  return rows;
}

}  // namespace bondstatic
