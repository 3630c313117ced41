#include "formats/write/lammps_bonds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace bondstatic {

namespace {

constexpr std::size_t many_types = 5000;

constexpr double mid_length = 0.5, rounding = 1e-12;

std::string of_bonds(Index count, std::size_t all) {
  return fmt::format("{} of {} bonds", count, all);
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
  Index off_middle = 0, coupled = 0, without_feedback = 0;
  double farthest = mid_length;
  for (std::size_t k = 0; k < all; ++k) {
    const BondProperties& bond = input.properties[k];
    if (std::abs(bond.fraction - mid_length) > rounding) ++off_middle;
    if (std::abs(bond.fraction - mid_length) > std::abs(farthest - mid_length)) farthest = bond.fraction;
    coupled += bond.stiffness.coupling != 0;
    without_feedback += !bond.moments_fed_back;
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
  if (const Index other_image = bonds_to_other_images(input.model); other_image > 0)
    notes.not_expressed.push_back(fmt::format(
        "{} do not go to the one nearest image of their far end, which LAMMPS takes. Repeat the cell "
        "(2x2x2) before exporting.",
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
