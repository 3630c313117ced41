#include "bondstatic/results.hpp"
#include "results/largest_place.hpp"

namespace bondstatic {

LargestPlace largest_place(const State& state, Index count) {
  LargestPlace largest;
  for (Index i = 0; i < count; ++i) {
    const double magnitude = state.displacement[std::size_t(i)].head<3>().stableNorm();
    if (magnitude > largest.magnitude) largest = {i, magnitude};  // NaN is not
  }
  return largest;
}

LargestDisplacement largest_displacement(const Model& model, const State& state) {
  const Index place = largest_place(state, Index(state.displacement.size())).particle;
  if (place < 0) return {};
  return {model.particles[std::size_t(place)].id, state.displacement[std::size_t(place)].head<3>()};
}

std::vector<LargestDisplacement> largest_displacements(const Model& model, const StaticSolution& solution) {
  std::vector<LargestDisplacement> all;
  for (const State& state : solution.cases) all.push_back(largest_displacement(model, state));
  return all;
}

}  // namespace bondstatic
