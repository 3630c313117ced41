// Packings that are hard on an iterative solver: stiffness over many decades, bonds without moments among
// others, slender and thin bodies, several of them, particles of very different sizes.
#pragma once

#include <random>

#include "support/models.hpp"

namespace bondstatic::test {

struct HardModel {
  Index count[3] = {6, 6, 6};  ///< particles along x, y, z; the face z = 0 is held
  double decades = 0;          ///< of Young's modulus from bond to bond, log-uniform
  double hinges = 0;           ///< share of bonds without moments; the packing stays sound
  double size_ratio = 1;       ///< of the largest to the smallest particle's section
  int bodies = 1;              ///< side by side, not bonded to each other
};

/// Jittered lattice bonded to its neighbours along the axes and, at random, across; loaded at the far end.
inline Model hard_model(std::mt19937_64& random, const HardModel& of) {
  std::uniform_real_distribution<double> unit(0, 1);
  Model model;
  model.blocks.push_back(block("generic", {{"kn", 1}, {"ks", 1}, {"kt", 1}, {"kb", 1}}));
  const auto join = [&](Index a, Index b, bool may_hinge) {
    const double young = 1e9 * std::pow(10.0, of.decades * (unit(random) - 0.5));
    const double r =
        0.3 * std::min(model.particles[std::size_t(a)].radius, model.particles[std::size_t(b)].radius);
    const double length =
        (model.particles[std::size_t(b)].position - model.particles[std::size_t(a)].position).norm();
    const double area = 3.14159 * r * r, second_moment = area * r * r / 4;
    const bool hinge = may_hinge && unit(random) < of.hinges;
    // kn, ks, kt, kb of Timoshenko's order of magnitude, of round sections.
    const std::vector<double> c{young * area / length, 0.4 * young * area / length,
                                hinge ? 0 : 0.8 * young * second_moment / length,
                                hinge ? 0 : young * second_moment / length};
    add_bond(model, a, b);
    for (std::size_t i = 0; i < c.size(); ++i) model.blocks.front().overrides[i].push_back(c[i]);
  };
  for (int body = 0; body < of.bodies; ++body) {
    const Index first = Index(model.particles.size());
    const Index nx = of.count[0], ny = of.count[1], nz = of.count[2];
    const auto at = [&](Index x, Index y, Index z) { return first + (x * ny + y) * nz + z; };
    for (Index x = 0; x < nx; ++x)
      for (Index y = 0; y < ny; ++y)
        for (Index z = 0; z < nz; ++z) {
          const Vector3 jitter(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
          const double radius = 0.5 * std::pow(of.size_ratio, unit(random) - 1);
          add_particle(model,
                       Vector3(double(x) + 2.0 * double(nx) * body, double(y), double(z)) + 0.1 * jitter,
                       radius);
        }
    for (Index x = 0; x < nx; ++x)
      for (Index y = 0; y < ny; ++y)
        for (Index z = 0; z < nz; ++z) {
          // One axis never hinges, so that no particle is left to spin.
          if (z + 1 < nz) join(at(x, y, z), at(x, y, z + 1), false);
          if (x + 1 < nx) join(at(x, y, z), at(x + 1, y, z), true);
          if (y + 1 < ny) join(at(x, y, z), at(x, y + 1, z), true);
          if (x + 1 < nx && z + 1 < nz && unit(random) < 0.5) join(at(x, y, z), at(x + 1, y, z + 1), true);
        }
    for (Index x = 0; x < nx; ++x)
      for (Index y = 0; y < ny; ++y) {
        fix_all(model, at(x, y, 0));
        load(model, at(x, y, nz - 1), vector6(unit(random), unit(random) - 0.5, -1, 0.01));
      }
  }
  return model;
}

/// Any of them, with contrast to 10^8 and aspect to 400.
inline HardModel any_hard_model(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  HardModel of;
  const double shape = unit(random);
  const auto between = [&](double from, double to) {
    return Index(from + unit(random) * (to - from + 0.999));
  };
  if (shape < 0.35) {
    const Index width = between(1, 3), aspect = between(20, 400);
    of = {{width, width, width * aspect}, 0, 0, 1, 1};
    if (of.count[2] > 500) of.count[2] = 500;
  } else if (shape < 0.6) {
    of = {{between(15, 30), 1 + between(0, 1), between(15, 30)}, 0, 0, 1, 1};
  } else {
    of = {{between(4, 10), between(4, 10), between(4, 10)}, 0, 0, 1, 1};
  }
  if (unit(random) < 0.7) of.decades = 8 * unit(random);
  if (unit(random) < 0.5) of.hinges = unit(random);
  if (unit(random) < 0.5) of.size_ratio = 1 + 9 * unit(random);
  if (unit(random) < 0.3) of.bodies = int(between(2, 4));
  return of;
}

}  // namespace bondstatic::test
