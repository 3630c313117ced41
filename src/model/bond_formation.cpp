#include "model/bond_formation.hpp"

#include <algorithm>

#include "model/neighbours.hpp"

namespace bondstatic {
namespace {

// Without it rounding loses 2 of the ten bonds of touching particles 0.4 apart.
constexpr double tolerance = 1e-9;

}  // namespace

std::vector<std::pair<Index, Index>> bonded_pairs(std::span<const Particle> particles,
                                                  const Formation& formation, const PositionLists* between) {
  enum : unsigned char { first = 1, second = 2 };
  std::vector<unsigned char> side(particles.size(), between ? 0 : first | second);
  if (between) {
    for (const Index p : between->first) side[std::size_t(p)] |= first;
    for (const Index p : between->second) side[std::size_t(p)] |= second;
  }
  std::vector<Index> chosen;
  for (std::size_t p = 0; p < particles.size(); ++p)
    if (side[p]) chosen.push_back(Index(p));

  std::vector<Vector3> positions;
  std::vector<double> reach;
  for (const Index p : chosen) {
    const Particle& particle = particles[std::size_t(p)];
    positions.push_back(particle.position);
    // The search may find too many (twice the tolerance, no negative gap); the comparison below decides.
    const double factor = formation.contact_radius_factor + 2 * tolerance;
    reach.push_back(factor * particle.radius + std::max(formation.gap, 0.0) / 2);
  }

  std::vector<std::pair<Index, Index>> bonded;
  for (const auto& [i, j] : touching_pairs(positions, reach)) {
    Index a = chosen[std::size_t(i)], b = chosen[std::size_t(j)];
    const auto side_a = side[std::size_t(a)], side_b = side[std::size_t(b)];
    if (!((side_a & first) && (side_b & second)) && !((side_a & second) && (side_b & first))) continue;
    if (particles[std::size_t(a)].id > particles[std::size_t(b)].id) std::swap(a, b);
    const Particle &pa = particles[std::size_t(a)], &pb = particles[std::size_t(b)];
    const double sum = pa.radius + pb.radius, distance = (pb.position - pa.position).norm();
    if (distance <= formation.contact_radius_factor * sum + formation.gap + tolerance * sum)
      bonded.push_back({a, b});
  }
  const auto ids = [&](const std::pair<Index, Index>& pair) {
    return std::pair(particles[std::size_t(pair.first)].id, particles[std::size_t(pair.second)].id);
  };
  const auto by_ids = [&](const auto& left, const auto& right) { return ids(left) < ids(right); };
  if (!std::is_sorted(bonded.begin(), bonded.end(), by_ids)) std::sort(bonded.begin(), bonded.end(), by_ids);
  return bonded;
}

}  // namespace bondstatic
