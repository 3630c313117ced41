#include "results/summary_parts.hpp"

namespace bondstatic {

namespace {

Json spread_of(const Spread& spread) {
  return {{"smallest", spread.smallest},
          {"lower_quartile", spread.lower_quartile},
          {"median", spread.median},
          {"upper_quartile", spread.upper_quartile},
          {"largest", spread.largest}};
}

Json block_of(const BlockResolution& block) {
  return {{"block", block.block},
          {"law", block.law},
          {"bonds", block.bonds},
          {"bonds_in_rows", block.in_rows},
          {"poisson_assumed", block.poisson_assumed},
          {"poisson", spread_of(block.poisson)},
          {"slenderness", spread_of(block.slenderness)},
          {"row", spread_of(block.row)},
          {"deflection_error", spread_of(block.deflection)},
          {"deflection_error_of_one_bond", spread_of(block.single)},
          {"bonds_for_one_percent", spread_of(block.enough)},
          {"part_above_one_percent", block.coarse},
          {"transverse_stiffness_error", spread_of(block.transverse)},
          {"twisting_stiffness_error", spread_of(block.twisting)},
          {"contact_point_offset", spread_of(block.offset)},
          {"kappa", spread_of(block.kappa)},
          {"beam_kappa", spread_of(block.beam_kappa)},
          {"advice", block.advice}};
}

}  // namespace

Json resolution_of(const std::vector<BlockResolution>& blocks) {
  Json all = Json::array();
  for (const BlockResolution& block : blocks) all.push_back(block_of(block));
  return all;
}

}  // namespace bondstatic
