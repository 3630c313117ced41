#include "formats/write/lammps_bonds.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace bondstatic {

namespace {

/// The limits of what a few lines of a deck can hold before a user should know.
constexpr std::size_t many_types = 5000;

constexpr double mid_length = 0.5, rounding = 1e-12;

std::string of_bonds(Index count, std::size_t all) {
  return fmt::format("{} of {} bonds", count, all);
}

/// LAMMPS takes the shortest of all images of x_b - x_a.
bool is_shortest_image(const Model& model, const Bond& bond) {
  if (!model.cell) return true;
  const Vector3 parts = model.cell->edges.inverse() * bond.branch;
  for (int i = 0; i < 3; ++i)
    if (model.cell->periodic[std::size_t(i)] && std::abs(parts[i]) >= 0.5) return false;
  return true;
}

/// Bonds on a pair that has one before them.
Index repeated_pairs(const Model& model) {
  std::vector<std::array<Index, 2>> pairs;
  pairs.reserve(model.bonds.size());
  for (const Bond& bond : model.bonds) pairs.push_back({std::min(bond.a, bond.b), std::max(bond.a, bond.b)});
  std::sort(pairs.begin(), pairs.end());
  return Index(pairs.end() - std::unique(pairs.begin(), pairs.end()));
}

void tell_what_does_not_fit(const ExportInput& input, ExportNotes& notes) {
  const std::size_t all = input.model.bonds.size();
  Index off_middle = 0, coupled = 0, other_image = 0, without_feedback = 0;
  double farthest = mid_length;
  for (std::size_t k = 0; k < all; ++k) {
    const BondProperties& bond = input.properties[k];
    if (std::abs(bond.fraction - mid_length) > rounding) ++off_middle;
    if (std::abs(bond.fraction - mid_length) > std::abs(farthest - mid_length)) farthest = bond.fraction;
    coupled += bond.stiffness.coupling != 0;
    without_feedback += !bond.moments_fed_back;
    other_image += !is_shortest_image(input.model, input.model.bonds[k]);
  }
  if (off_middle > 0)
    notes.not_expressed.push_back(
        fmt::format("{} act at another contact point than mid-length (up to {:.6g} of the length from a); "
                    "bpm/rotational takes mid-length for all. `contact_point = \"beam\"` on [[bonds]] gives "
                    "the static answer for that.",
                    of_bonds(off_middle, all), farthest));
  if (coupled > 0)
    notes.not_expressed.push_back(fmt::format(
        "{} couple shear and bending (stepped sections); bpm/rotational has no such term, and the "
        "deck goes without.",
        of_bonds(coupled, all)));
  if (other_image > 0)
    notes.not_expressed.push_back(fmt::format(
        "{} reach half of the periodic cell or farther; LAMMPS takes the shortest image of a pair, "
        "which may be another one. Repeat the cell (2x2x2) before exporting.",
        of_bonds(other_image, all)));
  if (const Index twice = repeated_pairs(input.model); twice > 0)
    notes.not_expressed.push_back(
        fmt::format("{} join a pair that is joined already; bpm/rotational keeps one reference state a pair.",
                    of_bonds(twice, all)));
  if (without_feedback > 0)
    notes.remarks.push_back(
        fmt::format("{} keep their moments to themselves (torque feedback off): written with k_t = k_b = 0, "
                    "which is the same equilibrium; their stresses from moments are not known to LAMMPS.",
                    of_bonds(without_feedback, all)));
}

}  // namespace

LammpsBonds lammps_bonds(const ExportInput& input, ExportNotes& notes) {
  tell_what_does_not_fit(input, notes);
  LammpsBonds bonds;
  bonds.type.reserve(input.properties.size());
  std::map<std::array<double, 4>, Index> known;
  for (const BondProperties& bond : input.properties) {
    SectionStiffness k = bond.stiffness;
    k.coupling = 0;
    if (!bond.moments_fed_back) k.kt = k.kb = 0;
    const auto [found, is_new] = known.try_emplace({k.kn, k.ks, k.kt, k.kb}, Index(bonds.types.size()) + 1);
    if (is_new) bonds.types.push_back(k);
    bonds.type.push_back(found->second);
  }
  bonds.shortest = std::numeric_limits<double>::infinity();
  for (const Bond& bond : input.model.bonds) {
    bonds.shortest = std::min(bonds.shortest, bond.branch.norm());
    bonds.longest = std::max(bonds.longest, bond.branch.norm());
  }
  if (bonds.types.size() > many_types)
    notes.remarks.push_back(
        fmt::format("{} distinct stiffnesses make as many bond types. LAMMPS keeps types in plain arrays and "
                    "sets no limit, but takes their bond_coeff lines one by one: some seconds for a hundred "
                    "thousand.",
                    bonds.types.size()));
  return bonds;
}

}  // namespace bondstatic
