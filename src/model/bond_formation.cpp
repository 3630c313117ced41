#include "model/bond_formation.hpp"

#include <algorithm>
#include <tuple>

#include "model/neighbours.hpp"

namespace bondstatic {
namespace {

// Without it rounding loses 2 of the ten bonds of touching particles 0.4 apart.
constexpr double tolerance = 1e-9;

enum : unsigned char { first = 1, second = 2 };

std::vector<unsigned char> sides_of(std::size_t particles, const PositionLists* between) {
  std::vector<unsigned char> side(particles, between ? 0 : first | second);
  if (between) {
    for (const Index p : between->first) side[std::size_t(p)] |= first;
    for (const Index p : between->second) side[std::size_t(p)] |= second;
  }
  return side;
}

bool opposite(unsigned char a, unsigned char b) {
  return ((a & first) && (b & second)) || ((a & second) && (b & first));
}

/// Those on a side, in the order of their ids, so that pairs come out sorted by them.
std::vector<Index> sorted_by_id(std::span<const Particle> particles, const std::vector<unsigned char>& side) {
  std::vector<Index> chosen;
  for (std::size_t p = 0; p < particles.size(); ++p)
    if (side[p]) chosen.push_back(Index(p));
  const auto id = [&](Index p) { return particles[std::size_t(p)].id; };
  const auto by_id = [&](Index p, Index q) { return id(p) < id(q); };
  if (!std::is_sorted(chosen.begin(), chosen.end(), by_id))
    std::stable_sort(chosen.begin(), chosen.end(), by_id);
  return chosen;
}

/// The search may find too many (twice the tolerance, no negative gap); are_bonded() decides.
double search_reach(const Particle& particle, const Formation& formation) {
  return (formation.contact_radius_factor + 2 * tolerance) * particle.radius +
         std::max(formation.gap, 0.0) / 2;
}

bool are_bonded(const Particle& a, const Particle& b, const Vector3& branch, const Formation& formation) {
  const double sum = a.radius + b.radius;
  return branch.norm() <= formation.contact_radius_factor * sum + formation.gap + tolerance * sum;
}

}  // namespace

std::vector<std::pair<Index, Index>> bonded_pairs(std::span<const Particle> particles,
                                                  const Formation& formation, const PositionLists* between,
                                                  int threads) {
  const auto side = sides_of(particles.size(), between);
  const std::vector<Index> chosen = sorted_by_id(particles, side);
  std::vector<Vector3> positions;
  std::vector<double> reach;
  positions.reserve(chosen.size());
  reach.reserve(chosen.size());
  for (const Index p : chosen) {
    positions.push_back(particles[std::size_t(p)].position);
    reach.push_back(search_reach(particles[std::size_t(p)], formation));
  }

  // What is found is replaced by what is bonded of it.
  auto bonded = touching_pairs(positions, reach, threads);
  auto kept = bonded.begin();
  for (const auto& [i, j] : bonded) {
    const Index a = chosen[std::size_t(i)], b = chosen[std::size_t(j)];
    const Particle &pa = particles[std::size_t(a)], &pb = particles[std::size_t(b)];
    if (opposite(side[std::size_t(a)], side[std::size_t(b)]) &&
        are_bonded(pa, pb, pb.position - pa.position, formation))
      *kept++ = {a, b};
  }
  bonded.erase(kept, bonded.end());
  return bonded;
}

double longest_bond(std::span<const Particle> particles, const Formation& formation,
                    const PositionLists* between) {
  const auto side = sides_of(particles.size(), between);
  double longest = 0;
  for (std::size_t p = 0; p < particles.size(); ++p)
    if (side[p]) longest = std::max(longest, 2 * search_reach(particles[p], formation));
  return longest;
}

std::vector<BondedImage> bonded_images(std::span<const Particle> particles, const Cell& cell,
                                       const Formation& formation, const PositionLists* between,
                                       int threads) {
  const auto side = sides_of(particles.size(), between);
  const std::vector<Index> chosen = sorted_by_id(particles, side);
  std::vector<Vector3> positions;
  std::vector<double> reach;
  std::vector<CellImage> into;  // brings a particle into the cell
  for (const Index p : chosen) {
    const Particle& particle = particles[std::size_t(p)];
    into.push_back(image_inside(cell, particle.position));
    positions.push_back(particle.position + shift_of(cell, into.back()));
    reach.push_back(search_reach(particle, formation));
  }
  // Images of whatever could touch a particle inside come behind.
  const auto inside = Index(positions.size());
  const double largest = reach.empty() ? 0 : *std::max_element(reach.begin(), reach.end());
  std::vector<std::pair<Index, CellImage>> images;
  for (Index i = 0; i < inside; ++i)
    for (const CellImage& image :
         images_within(cell, positions[std::size_t(i)], reach[std::size_t(i)] + largest)) {
      images.emplace_back(i, image);
      positions.push_back(positions[std::size_t(i)] + shift_of(cell, image));
      reach.push_back(reach[std::size_t(i)]);
    }

  std::vector<BondedImage> bonded;
  for (const auto& [i, j] : touching_pairs(positions, reach, threads)) {
    if (i >= inside) continue;  // both are images
    const auto& [other, image] = j < inside ? std::pair{j, CellImage{}} : images[std::size_t(j - inside)];
    // Every pair across a face is found from both of its ends, a particle and its own image as well.
    if (other < i || (other == i && image < CellImage{})) continue;
    const Index a = chosen[std::size_t(i)], b = chosen[std::size_t(other)];
    CellImage whole = image;
    for (std::size_t e = 0; e < 3; ++e) whole[e] += into[std::size_t(other)][e] - into[std::size_t(i)][e];
    const Particle &pa = particles[std::size_t(a)], &pb = particles[std::size_t(b)];
    if (opposite(side[std::size_t(a)], side[std::size_t(b)]) &&
        are_bonded(pa, pb, pb.position - pa.position + shift_of(cell, whole), formation))
      bonded.push_back({a, b, whole});
  }
  const auto key = [&](const BondedImage& bond) {
    return std::tuple(particles[std::size_t(bond.a)].id, particles[std::size_t(bond.b)].id, bond.image);
  };
  std::sort(bonded.begin(), bonded.end(),
            [&](const BondedImage& l, const BondedImage& r) { return key(l) < key(r); });
  return bonded;
}

}  // namespace bondstatic
