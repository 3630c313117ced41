#include "model/hold_cell.hpp"

#include <algorithm>
#include <numeric>

namespace bondstatic {

void hold_translation(Model& model) {
  if (model.particles.empty()) return;
  std::vector<Index> root(model.particles.size());
  std::iota(root.begin(), root.end(), Index(0));
  const auto root_of = [&](Index p) {
    while (root[std::size_t(p)] != p) p = root[std::size_t(p)] = root[std::size_t(root[std::size_t(p)])];
    return p;
  };
  // The smaller number stays the root, so that each body is known by its first particle.
  for (const Bond& bond : model.bonds) {
    const Index a = root_of(bond.a), b = root_of(bond.b);
    root[std::size_t(std::max(a, b))] = std::min(a, b);
  }
  std::vector<Index> size(root.size(), 0);
  for (Index p = 0; p < Index(root.size()); ++p) ++size[std::size_t(root_of(p))];
  Support support;
  support.particle = std::max_element(size.begin(), size.end()) - size.begin();
  support.fixed = {true, true, true, false, false, false};
  model.supports.push_back(support);
}

}  // namespace bondstatic
