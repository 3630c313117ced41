#include "model/space_order.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace bondstatic {

namespace {

constexpr int bits = 21;  // three times as many fit into 64

// Two zeros behind each bit: 1011 becomes 1000001001.
std::uint64_t spread_out(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

std::vector<Index> along_curve(const std::vector<Particle>& particles, int threads) {
  Eigen::AlignedBox3d box;
  for (const Particle& p : particles) box.extend(p.position);
  const double cubes = double((1 << bits) - 1), longest = particles.empty() ? 0 : box.sizes().maxCoeff();
  const double scale = longest > 0 ? cubes / longest : 0;
  std::vector<std::pair<std::uint64_t, Index>> places(particles.size());
  const Index count = Index(particles.size());
#pragma omp parallel for schedule(static) num_threads(threads)
  for (Index p = 0; p < count; ++p) {
    const Vector3 cube = scale * (particles[std::size_t(p)].position - box.min());
    std::uint64_t place = 0;
    for (int i = 0; i < 3; ++i) place |= spread_out(std::uint64_t(std::clamp(cube[i], 0.0, cubes))) << i;
    places[std::size_t(p)] = {place, p};
  }
  std::sort(places.begin(), places.end());
  std::vector<Index> order;
  order.reserve(places.size());
  for (const auto& [place, p] : places) order.push_back(p);
  return order;
}

std::vector<Index> by_first_particle(const std::vector<Bond>& bonds, const std::vector<Index>& position,
                                     int threads) {
  const Index count = Index(bonds.size());
  std::vector<Index> first(bonds.size()), next(position.size() + 1, 0), order(bonds.size());
#pragma omp parallel for schedule(static) num_threads(threads)
  for (Index k = 0; k < count; ++k) {
    const Bond& bond = bonds[std::size_t(k)];
    first[std::size_t(k)] = std::min(position[std::size_t(bond.a)], position[std::size_t(bond.b)]);
  }
  for (const Index p : first) ++next[std::size_t(p) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::size_t k = 0; k < first.size(); ++k) order[std::size_t(next[std::size_t(first[k])]++)] = Index(k);
  return order;
}

}  // namespace

std::vector<Index> positions_in(const std::vector<Index>& order) {
  std::vector<Index> position(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) position[std::size_t(order[i])] = Index(i);
  return position;
}

SpaceOrder space_order(const Model& model, int threads) {
  SpaceOrder order;
  order.particle = along_curve(model.particles, threads);
  order.bond = by_first_particle(model.bonds, positions_in(order.particle), threads);
  return order;
}

SpaceOrder space_order(const Piece& piece, int threads) {
  SpaceOrder order;
  order.particle = along_curve(piece.model.particles, threads);
  std::stable_partition(order.particle.begin(), order.particle.end(), [&](Index p) { return piece.has(p); });
  order.bond = by_first_particle(piece.model.bonds, positions_in(order.particle), threads);
  return order;
}

Model renumbered(const Model& model, const SpaceOrder& order, int threads) {
  const std::vector<Index> position = positions_in(order.particle);
  const Index particles = Index(model.particles.size()), bonds = Index(model.bonds.size());
  Model result{.particles = vector_of<Particle>(model.particles.size(), threads),
               .blocks = model.blocks,
               .bonds = vector_of<Bond>(model.bonds.size(), threads),
               .supports = model.supports,
               .loads = model.loads,
               .load_cases = model.load_cases,
               .cell = model.cell,
               .strains = model.strains};
#pragma omp parallel num_threads(threads)
  {
#pragma omp for schedule(static)
    for (Index p = 0; p < particles; ++p)
      result.particles[std::size_t(p)] = model.particles[std::size_t(order.particle[std::size_t(p)])];
#pragma omp for schedule(static)
    for (Index k = 0; k < bonds; ++k) {
      Bond bond = model.bonds[std::size_t(order.bond[std::size_t(k)])];
      bond.a = position[std::size_t(bond.a)];
      bond.b = position[std::size_t(bond.b)];
      result.bonds[std::size_t(k)] = bond;
    }
  }
  for (Support& support : result.supports) support.particle = position[std::size_t(support.particle)];
  for (Load& load : result.loads) load.particle = position[std::size_t(load.particle)];
  return result;
}

Piece renumbered(const Piece& piece, const SpaceOrder& order, int threads) {
  Piece result;
  result.model = renumbered(piece.model, order, threads);
  result.own = piece.own;
  for (const Index p : order.particle) {
    result.particle.push_back(piece.particle[std::size_t(p)]);
    if (!piece.has(p)) result.owner.push_back(piece.owner[std::size_t(p - piece.own)]);
  }
  for (const Index k : order.bond) result.bond.push_back(piece.bond[std::size_t(k)]);
  return result;
}

}  // namespace bondstatic
