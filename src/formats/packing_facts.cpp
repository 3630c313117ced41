#include "formats/packing_facts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/cell.hpp"

namespace bondstatic {
namespace {

/// The particle that stands for the body of particle p; the way to it is halved at each visit.
Index root(std::vector<Index>& parent, Index p) {
  while (parent[std::size_t(p)] != p) {
    Index& up = parent[std::size_t(p)];
    up = parent[std::size_t(up)];
    p = up;
  }
  return p;
}

}  // namespace

BondEnds::BondEnds(const ForeignModel& model) : model_(model) {
  position_.expect(Index(model.particles.size()));
  for (std::size_t p = 0; p < model.particles.size(); ++p) position_.add(model.particles[p].id, Index(p));
}

Vector3 BondEnds::branch(std::size_t bond) const {
  const Vector3 straight =
      model_.particles[std::size_t(b(bond))].position - model_.particles[std::size_t(a(bond))].position;
  if (!model_.cell) return straight;
  return straight + shift_of(*model_.cell, nearest_image(*model_.cell, straight).image);
}

PackingFacts packing_facts(const ForeignModel& model) {
  PackingFacts facts;
  const std::size_t count = model.particles.size();
  if (count == 0) return facts;
  facts.lowest = facts.highest = model.particles.front().position;
  for (const Particle& particle : model.particles) {
    facts.lowest = facts.lowest.cwiseMin(particle.position);
    facts.highest = facts.highest.cwiseMax(particle.position);
    facts.smallest_radius = std::fmin(facts.smallest_radius, particle.radius);
    facts.largest_radius = std::fmax(facts.largest_radius, particle.radius);
  }
  facts.coordination = 2.0 * double(model.bonds.size()) / double(count);

  const BondEnds ends(model);
  std::vector<Index> parent(count), size(count, 1);
  std::iota(parent.begin(), parent.end(), Index(0));
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    Index a = root(parent, ends.a(k)), b = root(parent, ends.b(k));
    if (a == b) continue;
    if (size[std::size_t(a)] < size[std::size_t(b)]) std::swap(a, b);
    parent[std::size_t(b)] = a;
    size[std::size_t(a)] += size[std::size_t(b)];
  }
  for (std::size_t p = 0; p < count; ++p) {
    if (parent[p] != Index(p)) continue;
    (size[p] == 1 ? facts.loose : facts.bodies) += 1;
    facts.largest_body = std::max(facts.largest_body, size[p]);
  }
  return facts;
}

}  // namespace bondstatic
