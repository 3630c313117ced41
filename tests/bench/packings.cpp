#include "bench/packings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/case_file.hpp"
#include "model/bond_formation.hpp"
#include "support/models.hpp"

namespace bondstatic::bench {

namespace {

// Deterministic on every machine, as the standard's distributions are not.
class Uniform {
 public:
  double operator()(double from, double to) { return from + (to - from) * double(random_() >> 11) * 0x1p-53; }
  Vector3 shift(double size) {
    const double x = (*this)(-size, size), y = (*this)(-size, size), z = (*this)(-size, size);
    return {x, y, z};
  }

 private:
  std::mt19937_64 random_{20};
};

void bond(Model& model, Index a, Index b) {
  const Index k = Index(model.bonds.size());
  model.bonds.push_back({k + 1, a, b,
                         model.particles[std::size_t(b)].position - model.particles[std::size_t(a)].position,
                         0, k});
}

void hold_and_load(Model& model, double layer) {
  double lowest = model.particles.front().position.z(), highest = lowest;
  for (const Particle& particle : model.particles) {
    lowest = std::min(lowest, particle.position.z());
    highest = std::max(highest, particle.position.z());
  }
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    const double z = model.particles[p].position.z();
    if (z < lowest + layer) test::fix_all(model, Index(p));
    if (z > highest - layer) test::load(model, Index(p), test::vector6(1, 0, -1));
  }
}

BondBlock timoshenko() {
  return test::block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius_factor", 0.8}});
}

// 0 ... 1 ... 2 ... runs back and forth between the walls at 0 and `size`.
double reflected(double x, double size, Index tile) {
  return tile % 2 == 0 ? double(tile) * size + x : double(tile + 1) * size - x;
}

Index edge_of(double particles) {
  return Index(std::lround(std::cbrt(particles)));
}

}  // namespace

Model cubic_packing(Index nx, Index ny, Index nz) {
  Model model;
  model.blocks = {timoshenko()};
  const std::array<Index, 3> count{nx, ny, nz}, step{ny * nz, nz, 1};
  for (Index x = 0; x < nx; ++x)
    for (Index y = 0; y < ny; ++y)
      for (Index z = 0; z < nz; ++z) test::add_particle(model, 0.4 * Vector3(x, y, z), 0.2);
  for (Index p = 0; p < nx * ny * nz; ++p)
    for (std::size_t i = 0; i < 3; ++i)
      if ((p / step[i]) % count[i] + 1 < count[i]) bond(model, p, p + step[i]);
  hold_and_load(model, 0.2);
  return model;
}

Model disordered_fcc(Index cells) {
  constexpr double half_cell = 0.4, radius = half_cell / std::numbers::sqrt2, removed = 0.27;
  constexpr Index neighbours[6][3] = {{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}};
  Uniform uniform;
  Model model;
  model.blocks = {timoshenko()};
  // Sites of a cubic grid of half the cell whose coordinates add up to an even number.
  const Index edge = 2 * cells;
  std::vector<Index> number(std::size_t(edge * edge * edge), -1);
  const auto at = [edge](Index x, Index y, Index z) { return std::size_t((x * edge + y) * edge + z); };
  const auto for_each_site = [edge](auto visit) {
    for (Index x = 0; x < edge; ++x)
      for (Index y = 0; y < edge; ++y)
        for (Index z = (x + y) % 2; z < edge; z += 2) visit(x, y, z);
  };
  for_each_site([&](Index x, Index y, Index z) {
    const Vector3 place = half_cell * Vector3(x, y, z) + uniform.shift(0.2 * radius);
    number[at(x, y, z)] = test::add_particle(model, place, radius);
  });
  const auto inside = [edge](Index i) { return i >= 0 && i < edge; };
  for_each_site([&](Index x, Index y, Index z) {
    for (const auto& n : neighbours)
      if (inside(x + n[0]) && inside(y + n[1]) && inside(z + n[2]) && uniform(0, 1) >= removed)
        bond(model, number[at(x, y, z)], number[at(x + n[0], y + n[1], z + n[2])]);
  });
  hold_and_load(model, half_cell);
  return model;
}

Model yade_like(Index particles) {
  const std::vector<Particle> packing =
      read_case(BONDSTATIC_SOURCE_DIR "/cases/yade-packing/press.toml").model.particles;
  Vector3 low = packing.front().position, high = low;
  double mean = 0, largest = 0;
  for (const Particle& particle : packing) {
    low = low.cwiseMin(particle.position);
    high = high.cwiseMax(particle.position);
    mean += particle.radius / double(packing.size());
    largest = std::max(largest, particle.radius);
  }
  // Few spheres touch the walls; reflected there, the tiles would hang together by a few bonds.
  low += Vector3::Constant(mean);
  const Vector3 size = high - Vector3::Constant(mean) - low;
  std::vector<Particle> tile;
  for (const Particle& particle : packing) {
    const Vector3 x = particle.position - low;
    // A sphere that a wall cuts would meet its own image.
    if (std::min(x.minCoeff(), (size - x).minCoeff()) > 0.5 * particle.radius) tile.push_back(particle);
  }
  const double edge = std::cbrt(size.prod() * double(particles) / double(tile.size()));
  Uniform uniform;
  Model model;
  model.blocks = {timoshenko()};
  const auto tiles = [&](int i) { return Index(std::ceil(edge / size[i])); };
  for (Index x = 0; x < tiles(0); ++x)
    for (Index y = 0; y < tiles(1); ++y)
      for (Index z = 0; z < tiles(2); ++z)
        for (const Particle& particle : tile) {
          const Vector3 inside = particle.position - low;
          const Vector3 place(reflected(inside.x(), size.x(), x), reflected(inside.y(), size.y(), y),
                              reflected(inside.z(), size.z(), z));
          if (place.maxCoeff() < edge)
            test::add_particle(model, place + uniform.shift(0.01 * particle.radius), particle.radius);
        }
  for (const auto& [a, b] : bonded_pairs(model.particles, {0, 1.1})) bond(model, a, b);
  hold_and_load(model, 1.5 * largest);
  return model;
}

void vary_stiffness(Model& model, double decades) {
  Uniform uniform;
  BondBlock& block = model.blocks.front();
  const auto young = std::size_t(find_bond_law(block.law)->find("young"));
  std::vector<double>& values = block.overrides[young];
  for (std::size_t k = 0; k < model.bonds.size(); ++k)
    values.push_back(block.parameters[young] * std::pow(10, uniform(0, decades)));
}

const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {"cubic",
       [](Index particles) {
         const Index edge = edge_of(double(particles));
         return cubic_packing(edge, edge, edge);
       },
       true},
      {"disordered FCC", [](Index particles) { return disordered_fcc(edge_of(double(particles) / 4)); },
       true},
      {"YADE-like", yade_like, true},
      {"FCC, E over 3 decades",
       [](Index particles) {
         Model model = disordered_fcc(edge_of(double(particles) / 4));
         vary_stiffness(model, 3);
         return model;
       },
       true},
      {"slender 20x20x400", [](Index) { return cubic_packing(20, 20, 400); }, false},
  };
  return all;
}

}  // namespace bondstatic::bench
