// What a block says of all its bonds, looked up once, and its law at each of them.
#pragma once

#include "bond/findings.hpp"
#include "bond/parameters.hpp"
#include "bondstatic/bond_law.hpp"

namespace bondstatic {

struct BlockPlan {
  struct Override {
    std::size_t parameter;
    const std::vector<double>* values;  ///< by position in the block
    std::vector<std::size_t> rules_out;
  };

  const BondLaw* law = nullptr;  ///< null where the block is not sound
  ContactPoint contact_point;
  const std::vector<double>* fractions = nullptr;  ///< of single bonds; empty: none
  ParameterRules rules;
  std::vector<double> values;  ///< complete where there are no overrides
  std::vector<Override> overrides;
};

/// Of a block that lasts as long. Not sound, and said in `faults`, where something is wrong with it.
BlockPlan plan_block(const BondBlock& block, std::size_t number, std::vector<Fault>& faults);

/// The law at one bond. Gives the bond's complete parameters, in the plan or in `scratch`; null, and said in
/// `findings`, where something is wrong.
const std::vector<double>* evaluate(const Model& model, const Bond& bond, const BlockPlan& plan,
                                    std::vector<double>& scratch, BondProperties& out, Findings& findings);

/// How far from the law's own contact point, towards b, the bond's stiffness is transformed to; 0 where it
/// stays as the law gives it.
double transformed_by(const BlockPlan& plan, const Bond& bond, const BondSite& site);

}  // namespace bondstatic
