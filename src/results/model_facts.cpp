#include <algorithm>
#include <set>

#include "bondstatic/results.hpp"

namespace bondstatic {

ModelFacts facts_of(const Model& model) {
  ModelFacts facts;
  facts.particles = Index(model.particles.size());
  facts.bonds = Index(model.bonds.size());
  facts.load_cases = model.load_cases;
  std::set<Index> supported;
  for (const Support& support : model.supports) supported.insert(support.particle);
  facts.supported_particles = Index(supported.size());
  auto& by_law = facts.bonds_by_law;
  std::vector<Index> in_block(model.blocks.size());
  for (const Bond& bond : model.bonds) ++in_block[std::size_t(bond.block)];
  for (std::size_t b = 0; b < in_block.size(); ++b) {
    const std::string& law = model.blocks[b].law;
    const auto known =
        std::find_if(by_law.begin(), by_law.end(), [&](const auto& one) { return one.first == law; });
    if (known == by_law.end())
      by_law.emplace_back(law, in_block[b]);
    else
      known->second += in_block[b];
  }
  return facts;
}

}  // namespace bondstatic
