#include "bond/strength/criteria.hpp"

namespace bondstatic {
namespace {

enum Input : std::size_t { normal_strength, tangential_strength };
enum Mode { tension, shear };

void failure_modes(const BondSection& bond, std::span<const double> in, std::vector<FailureMode>& out) {
  // MUSEN sums up its moments about the middle of the bond, whatever the radii of the particles.
  out.push_back(edge_normal_stress(tension, bond.radius, in[normal_strength], 0.5));
  out.push_back(edge_shear_stress(shear, bond.radius, in[tangential_strength]));
}

}  // namespace

StrengthCriterion musen_strength() {
  return {
      .name = "musen",
      .title = "MUSEN, solid bond with the model \"Elastic bond\", standard criterion",
      .source = "msolids/musen, Models/SolidBonds/BondModelElastic/ModelSBElastic.cpp, CONSIDER_BREAKAGE = 1",
      .formulas = {"tension: N/A + M r/I = normal_strength, M in the middle of the bond",
                   "shear: |S|/A + |T| r/J = tangential_strength"},
      .parameters = {required_input("normal_strength", dimension::stress, "normal strength of the bond"),
                     required_input("tangential_strength", dimension::stress,
                                    "tangential strength of the bond")},
      .scatters = {true, true},
      .modes = {"tension", "shear"},
      .remark =
          "As edem-v2, but for the place of the bending moment. MUSEN's alternative criterion "
          "(CONSIDER_BREAKAGE "
          "= 2: each stress on its own, bending only under tension) is not here: it jumps where tension "
          "turns "
          "into compression.",
      .failure_modes = failure_modes,
  };
}

}  // namespace bondstatic
