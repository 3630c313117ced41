#include "model/middle_third.hpp"

#include <algorithm>

namespace bondstatic {

std::vector<Index> middle_third(const Model& model, const std::vector<Index>& base,
                                const std::vector<Index>& at, const Vector3& axis) {
  const auto height = [&](Index p) { return axis.dot(model.particles[std::size_t(p)].position); };
  const auto mean = [&](const std::vector<Index>& platen) {
    double sum = 0;
    for (const Index p : platen) sum += height(p);
    return sum / double(platen.size());
  };
  const auto [low, high] = std::minmax({mean(base), mean(at)});
  // Centres of a lattice that lie on the boundary are inside, whatever their rounding.
  const double third = (high - low) / 3, slack = 1e-9 * third;
  std::vector<Index> middle;
  for (Index p = 0; p < Index(model.particles.size()); ++p)
    if (height(p) >= low + third - slack && height(p) <= high - third + slack) middle.push_back(p);
  return middle;
}

}  // namespace bondstatic
