#include "model/bond_formation.hpp"

#include <algorithm>

#include "model/neighbours.hpp"

namespace bondstatic {
namespace {

// Without it rounding loses 2 of the ten bonds of touching particles 0.4 apart.
constexpr double tolerance = 1e-9;

}  // namespace

std::vector<std::pair<Index, Index>> bonded_pairs(std::span<const Particle> particles,
                                                  const Formation& formation, const PositionLists* between,
                                                  int threads) {
  enum : unsigned char { first = 1, second = 2 };
  std::vector<unsigned char> side(particles.size(), between ? 0 : first | second);
  if (between) {
    for (const Index p : between->first) side[std::size_t(p)] |= first;
    for (const Index p : between->second) side[std::size_t(p)] |= second;
  }
  std::vector<Index> chosen;
  for (std::size_t p = 0; p < particles.size(); ++p)
    if (side[p]) chosen.push_back(Index(p));
  // In the order of the ids, so that pairs come out sorted by them.
  const auto id = [&](Index p) { return particles[std::size_t(p)].id; };
  const auto by_id = [&](Index p, Index q) { return id(p) < id(q); };
  if (!std::is_sorted(chosen.begin(), chosen.end(), by_id))
    std::stable_sort(chosen.begin(), chosen.end(), by_id);

  std::vector<Vector3> positions;
  std::vector<double> reach;
  positions.reserve(chosen.size());
  reach.reserve(chosen.size());
  for (const Index p : chosen) {
    const Particle& particle = particles[std::size_t(p)];
    positions.push_back(particle.position);
    // The search may find too many (twice the tolerance, no negative gap); the comparison below decides.
    const double factor = formation.contact_radius_factor + 2 * tolerance;
    reach.push_back(factor * particle.radius + std::max(formation.gap, 0.0) / 2);
  }

  // What is found is replaced by what is bonded of it.
  auto bonded = touching_pairs(positions, reach, threads);
  auto kept = bonded.begin();
  for (const auto& [i, j] : bonded) {
    const Index a = chosen[std::size_t(i)], b = chosen[std::size_t(j)];
    const auto side_a = side[std::size_t(a)], side_b = side[std::size_t(b)];
    if (!((side_a & first) && (side_b & second)) && !((side_a & second) && (side_b & first))) continue;
    const Particle &pa = particles[std::size_t(a)], &pb = particles[std::size_t(b)];
    const double sum = pa.radius + pb.radius, distance = (pb.position - pa.position).norm();
    if (distance <= formation.contact_radius_factor * sum + formation.gap + tolerance * sum) *kept++ = {a, b};
  }
  bonded.erase(kept, bonded.end());
  return bonded;
}

}  // namespace bondstatic
