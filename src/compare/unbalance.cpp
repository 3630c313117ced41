#include "compare/unbalance.hpp"

#include <algorithm>
#include <cmath>

#include "compare/finite_forces.hpp"
#include "statics/residual.hpp"

namespace bondstatic {

namespace {

/// Sum over the free degrees of freedom, moments divided by the length. Particles that either leaves out do
/// not count.
double product(const BodyVectors<double>& a, const BodyVectors<double>& b,
               const std::vector<std::uint8_t>& free, double length) {
  double sum = 0;
  for (std::size_t p = 0; p < free.size(); ++p)
    for (int i = 0; i < 6; ++i) {
      const double scale = i < 3 ? 1 : length;
      const double term = a[p][i] / scale * (b[p][i] / scale);
      if (((free[p] >> i) & 1) && std::isfinite(term)) sum += term;
    }
  return sum;
}

/// Of loads, of what a cell's strain asks for, and of static reactions.
double load_norm(const BondNetwork& network, const Boundary& boundary, const State& statics, double length) {
  const BodyVectors<Extended> still(boundary.load.size(), Vector6T<Extended>::Zero());
  const auto applied = converted<double>(residual(network, boundary, still, 1));
  double norm = 0;
  for (std::size_t p = 0; p < applied.size(); ++p)
    for (const Vector6* f : {&applied[p], &statics.reaction[p]})
      for (int i = 0; i < 6; ++i)
        if (std::isfinite((*f)[i])) norm = std::hypot(norm, (*f)[i] / (i < 3 ? 1 : length));
  return norm;
}

double kinetic_energy(const Model& model, const std::vector<Vector6>& velocity) {
  const BodyMasses masses = body_masses(model);
  double energy = 0;
  for (std::size_t p = 0; p < velocity.size(); ++p) {
    const Vector3 v = velocity[p].head<3>(), spin = velocity[p].tail<3>();
    if (v.allFinite()) energy += 0.5 * masses.mass[p] * v.squaredNorm();  // NaN without density
    if (spin.allFinite()) energy += 0.5 * masses.inertia[p] * spin.squaredNorm();
  }
  return energy;
}

}  // namespace

BodyVectors<double> finite_residual(const BondNetwork& network, const Boundary& boundary,
                                    const BodyVectors<double>& motion) {
  BodyVectors<double> r = boundary.load;
  const auto carried = sum_of(finite_forces(network, motion, boundary.strain));
  for (std::size_t p = 0; p < r.size(); ++p) r[p] -= carried[p];
  return r;
}

Unbalance unbalance_of(const Model& model, const BondNetwork& network, const Boundary& boundary,
                       const State& statics, const RunState& run, const BodyVectors<double>& motion) {
  Unbalance out;
  const double length = network.rotation_length;
  const double loads = load_norm(network, boundary, statics, length);
  const auto norm = [&](const BodyVectors<double>& f) {
    return std::sqrt(product(f, f, boundary.free, length)) / loads;
  };
  BodyVectors<double> r;
  if (!motion.empty() && loads > 0) {
    out.linear = norm(converted<double>(residual(network, boundary, converted<Extended>(motion), 1)));
    r = finite_residual(network, boundary, motion);
    out.finite = norm(r);
  }
  if (!run.velocity.empty()) {
    out.fastest = 0;
    for (std::size_t p = 0; p < run.velocity.size(); ++p)
      if ((boundary.free[p] & 7) != 0) out.fastest = std::fmax(out.fastest, run.velocity[p].head<3>().norm());
    if (statics.energy > 0) out.kinetic = kinetic_energy(model, run.velocity) / statics.energy;
  }
  if (!run.net_force.empty() && loads > 0) {
    out.net_force = norm(run.net_force);
    if (!r.empty())
      out.moving_part =
          product(run.net_force, r, boundary.free, length) / product(r, r, boundary.free, length);
  }
  return out;
}

double share_of_modes(const std::vector<Mode>& modes, const BodyMasses& masses, const FreeDofs& dofs,
                      const BodyVectors<double>& residual) {
  double whole = 0, part = 0;
  const auto sum = [&](auto term) {
    double total = 0;
    for (std::size_t p = 0; p < residual.size(); ++p)
      for (int i = 0; i < 6; ++i)
        if (dofs.is_free(Index(p), i)) total += term(p, i);
    return total;
  };
  whole = sum([&](std::size_t p, int i) {
    return residual[p][i] * residual[p][i] / (i < 3 ? masses.mass[p] : masses.inertia[p]);
  });
  for (const Mode& mode : modes) {
    const double along = sum([&](std::size_t p, int i) { return mode.shape[p][i] * residual[p][i]; });
    part += along * along;
  }
  return whole > 0 ? part / whole : 0;
}

BodyMasses masses_or_volumes(const Model& model) {
  const bool known = std::all_of(model.particles.begin(), model.particles.end(),
                                 [](const Particle& p) { return p.density > 0; });
  if (known) return body_masses(model);
  Model equal;
  equal.particles = model.particles;
  for (Particle& particle : equal.particles) particle.density = 1;
  return body_masses(equal);
}

}  // namespace bondstatic
