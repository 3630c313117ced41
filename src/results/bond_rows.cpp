#include "results/bond_rows.hpp"

#include "mechanism/partition.hpp"

namespace bondstatic {

UnbranchedRows bond_rows(const Model& model) {
  const auto bonds = model.bonds.size();
  std::vector<Index> at(model.particles.size()), last(model.particles.size(), -1);
  for (const Bond& bond : model.bonds)
    for (const Index p : {bond.a, bond.b}) ++at[std::size_t(p)];

  Partition rows{Index(bonds)};
  for (std::size_t k = 0; k < bonds; ++k)
    for (const Index p : {model.bonds[k].a, model.bonds[k].b}) {
      if (at[std::size_t(p)] != 2) continue;
      Index& other = last[std::size_t(p)];
      if (other >= 0) rows.unite(other, Index(k));
      other = Index(k);
    }

  std::vector<Index> size(bonds);
  for (std::size_t k = 0; k < bonds; ++k) ++size[std::size_t(rows.find(Index(k)))];
  UnbranchedRows out{std::vector<Index>(bonds), std::vector<bool>(bonds)};
  for (std::size_t k = 0; k < bonds; ++k) {
    out.length[k] = size[std::size_t(rows.find(Index(k)))];
    out.unbranched[k] = at[std::size_t(model.bonds[k].a)] <= 2 && at[std::size_t(model.bonds[k].b)] <= 2;
  }
  return out;
}

}  // namespace bondstatic
