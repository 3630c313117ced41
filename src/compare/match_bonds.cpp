#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "compare/match.hpp"
#include "io/nearest_name.hpp"

namespace bondstatic {

namespace {

/// Forces whose part across their bonds is below this are normal forces, with the digits that dumps have.
constexpr double along_bond = 1e-2;

/// One row of the file that is a bond of the case.
struct Row {
  std::size_t bond;
  std::size_t row;
  double sense;   ///< -1 where the file names b first
  Vector3 axis;   ///< from a to b, in the run's state
  double length;  ///< of the branch then
};

std::vector<Row> rows_of(const Model& model, const BondState& bonds, const RunState& run) {
  // Two bonds on one pair are told apart by their order.
  std::map<std::pair<Index, Index>, std::vector<std::size_t>> of_pair;
  for (std::size_t k = model.bonds.size(); k-- > 0;) {
    const Index a = model.particles[std::size_t(model.bonds[k].a)].id;
    const Index b = model.particles[std::size_t(model.bonds[k].b)].id;
    of_pair[std::minmax(a, b)].push_back(k);
  }
  std::vector<Row> rows;
  for (std::size_t i = 0; i < bonds.a.size(); ++i) {
    const auto found = of_pair.find(std::minmax(bonds.a[i], bonds.b[i]));
    if (found == of_pair.end() || found->second.empty()) continue;
    const std::size_t k = found->second.back();
    found->second.pop_back();
    const Bond& bond = model.bonds[k];
    Vector3 branch = bond.branch;
    const Vector3 apart =
        (run.displacement[std::size_t(bond.b)] - run.displacement[std::size_t(bond.a)]).head<3>();
    if (apart.allFinite()) branch += apart;
    const bool same = model.particles[std::size_t(bond.a)].id == bonds.a[i];
    rows.push_back({k, i, same ? 1.0 : -1.0, branch.normalized(), branch.norm()});
  }
  return rows;
}

/// Columns of three, or null where one of them is missing.
using Triple = std::array<const std::vector<double>*, 3>;
Triple triple(const BondState& bonds, const std::array<std::string, 3>& names) {
  Triple columns{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto found = bonds.columns.find(names[i]);
    if (found == bonds.columns.end()) return {};
    columns[i] = &found->second;
  }
  return columns;
}

Vector3 at(const Triple& columns, std::size_t row) {
  return {(*columns[0])[row], (*columns[1])[row], (*columns[2])[row]};
}

Fault no_columns(const BondState& bonds, const std::array<std::string, 3>& names, const std::string& file) {
  std::vector<std::string> there;
  for (const auto& [name, values] : bonds.columns) there.push_back(name);
  return {{file, 0, 0},
          fmt::format("no columns {}, {}, {} with the forces of bonds; there are {}", names[0], names[1],
                      names[2], there.empty() ? "none" : name_list(there)),
          "name them: --bond-force FX,FY,FZ"};
}

/// Of normal forces, or normal forces times lengths, with the static ones: best-fit scale and what it leaves,
/// relative.
struct NormalFit {
  double scale = 0, left = 1;
};
NormalFit normal_fit(const std::vector<double>& values, const std::vector<double>& statics) {
  double product = 0, own = 0, theirs = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]) || !std::isfinite(statics[i])) continue;
    product += values[i] * statics[i];
    own += statics[i] * statics[i];
    theirs += values[i] * values[i];
  }
  if (!(own > 0) || !(theirs > 0)) return {};
  return {product / own, std::sqrt(std::max(0.0, 1 - product * product / (own * theirs)))};
}

}  // namespace

void match_bonds(const Model& model, const State& statics, const BondState& bonds,
                 const BondForceColumns& columns, const std::string& file, RunState& run,
                 std::vector<Fault>& faults) {
  const Triple force = triple(bonds, columns.force), moment = triple(bonds, columns.moment);
  if (!force[0]) return faults.push_back(no_columns(bonds, columns.force, file));
  const std::vector<Row> rows = rows_of(model, bonds, run);
  if (2 * rows.size() < model.bonds.size())
    return faults.push_back(
        {{file, 0, 0},
         fmt::format("only {} of the case's {} bonds are in the file", rows.size(), model.bonds.size()),
         "these are the bonds of another packing, or other columns name the particles: --bond-columns A,B"});
  if (rows.size() < model.bonds.size() || rows.size() < bonds.a.size())
    run.notes.push_back(
        fmt::format("{} of the case's {} bonds are in the file, which has {}; the others are "
                    "left out of the comparison of bond forces.",
                    rows.size(), model.bonds.size(), bonds.a.size()));

  // Along their bonds, or not? Whose force, by what agrees with the static answer?
  double whole = 0, across = 0;
  std::vector<double> normal, normal_by_length, expected;
  for (const Row& row : rows) {
    const Vector3 value = row.sense * at(force, row.row);
    if (!value.allFinite()) continue;
    const double along = value.dot(row.axis);
    whole = std::hypot(whole, value.norm());
    across = std::hypot(across, (value - along * row.axis).norm());
    normal.push_back(along);
    normal_by_length.push_back(along / row.length);
    expected.push_back(-statics.bonds[row.bond].normal_force);
  }
  const bool normal_only = across <= along_bond * whole;
  const NormalFit plain = normal_fit(normal, expected), by_length = normal_fit(normal_by_length, expected);
  const bool times_length = normal_only && by_length.left < 0.5 * plain.left;
  const double sign = (times_length ? by_length : plain).scale < 0 ? -1 : 1;
  run.normal_force_only = normal_only;
  run.notes.push_back(
      fmt::format("Bond forces of the run are taken as those on the {} particle of a row{}{}.",
                  sign < 0 ? "first" : "second", normal_only ? ", along the bond alone (normal forces)" : "",
                  times_length ? ", times the bond's length, as LAMMPS writes them for bond style "
                                 "bpm/rotational; the length is divided out"
                               : ""));

  run.notes.insert(run.notes.end(), bonds.notes.begin(), bonds.notes.end());
  run.bond_force.assign(model.bonds.size(), Vector6::Constant(not_given));
  for (const Row& row : rows) {
    const double flip = sign * row.sense;
    const Vector3 value = flip * at(force, row.row);
    Vector6& out = run.bond_force[row.bond];
    out.head<3>() = value;
    // The static answer's axis is that of the case's positions.
    if (normal_only)
      out.head<3>() =
          value.dot(row.axis) / (times_length ? row.length : 1) * model.bonds[row.bond].branch.normalized();
    if (moment[0]) out.tail<3>() = flip * at(moment, row.row);
  }
}

}  // namespace bondstatic
