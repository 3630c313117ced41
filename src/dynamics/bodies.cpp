#include "dynamics/bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bondstatic/error.hpp"
#include "io/wide.hpp"

namespace bondstatic {

void require_masses(const Model& model, const Boundary& boundary, const std::vector<bool>& left_out) {
  for (std::size_t p = 0; p < model.particles.size(); ++p)
    if (!left_out[p] && boundary.free[p] && !(mass(model.particles[p]) > 0))
      throw Error(ExitCode::invalid_input,
                  fmt::format("particle {} has no density, which a run through time needs for its mass\n"
                              "    cure: add density = RHO to its [[particles]] block",
                              model.particles[p].id));
}

Bodies make_bodies(const Model& model, const Boundary& boundary, const std::vector<bool>& left_out,
                   const DynamicOptions& options) {
  require_masses(model, boundary, left_out);
  const std::size_t count = model.particles.size();
  Bodies bodies;
  bodies.count = Index(count);
  for (auto* array : {&bodies.motion, &bodies.velocity, &bodies.force, &bodies.load, &bodies.inverse})
    array->assign(std::size_t((6 * (count + 1) + pack_size - 1) / pack_size * pack_size), 0.0);
  bodies.radius.resize(count);
  bodies.present.assign(count, 1);
  if (options.kinematics == Kinematics::finite) {
    for (std::vector<double>& component : bodies.turn) component.assign(count, 0.0);
    bodies.turn[0].assign(count, 1.0);
  }
  for (std::size_t p = 0; p < count; ++p) {
    const Particle& particle = model.particles[p];
    bodies.radius[p] = particle.radius;
    if (left_out[p]) {
      bodies.present[p] = 0;
      continue;
    }
    const double m = mass(particle), inertia = moment_of_inertia(particle);
    for (std::size_t i = 0; i < 6; ++i) {
      const std::size_t dof = 6 * p + i;
      bodies.load[dof] = options.load_factor * boundary.load[p][Eigen::Index(i)];
      const double to = options.load_factor * boundary.prescribed[p][Eigen::Index(i)];
      if ((boundary.free[p] >> i) & 1) {
        bodies.inverse[dof] = 1 / (i < 3 ? m : inertia);
      } else if (to != 0) {
        bodies.moved.push_back(Index(dof));
        bodies.how_far.push_back(to);
        const bool turns =
            options.kinematics == Kinematics::finite && i >= 3 && (boundary.free[p] & 0x38) == 0;
        bodies.turned.push_back(turns ? options.load_factor * boundary.prescribed[p].tail<3>().norm() : 0);
      }
    }
  }
  return bodies;
}

namespace {

/// Velocities of moved supports; the work of their reactions, and of loads on them, beyond what the kick will
/// count for a degree of freedom that keeps its velocity.
double move_supports(Bodies& bodies, Index first, Index last, double dt, const Loading& loading) {
  double work = 0;
  auto at = std::lower_bound(bodies.moved.begin(), bodies.moved.end(), first);
  for (; at != bodies.moved.end() && *at < last; ++at) {
    const auto dof = std::size_t(*at), which = std::size_t(at - bodies.moved.begin());
    const double applied = loading.now * bodies.load[dof];
    const double before = bodies.velocity[dof];
    // Cayley's rotation by spin w turns by 2 atan(w dt / 2): the angle of the step is to come out exactly.
    const double part = loading.next - loading.now, half = 0.5 * part * bodies.turned[which];
    const double stretch = half != 0 ? std::tan(half) / half : 1;
    const double after = stretch * bodies.how_far[which] * (part / dt);
    work -= 0.5 * dt * (bodies.force[dof] * (before + after) + 2 * applied * after);
    bodies.velocity[dof] = after;
  }
  return work;
}

}  // namespace

WIDE_AS_THE_MACHINE StepSums kick_and_drift(Bodies& bodies, Index block, const DynamicOptions& options,
                                            const Loading& loading) {
  const Index first = block * dofs_a_block;
  const Index last = std::min(Index(bodies.motion.size()), first + dofs_a_block);
  const double dt = options.time_step, gamma = options.particle_damping, ramp = loading.now;
  StepSums sums;
  sums.work = move_supports(bodies, first, last, dt, loading);
  double* const motion = bodies.motion.data();
  double* const velocity = bodies.velocity.data();
  double* const force = bodies.force.data();
  const double* const load = bodies.load.data();
  const double* const inverse = bodies.inverse.data();
  // As many running sums as lanes: their order is the same on every machine.
  double work[pack_size] = {}, damped[pack_size] = {};
  for (Index chunk = first; chunk < last; chunk += pack_size) {
#pragma omp simd
    for (int lane = 0; lane < pack_size; ++lane) {
      const Index dof = chunk + lane;
      const double applied = ramp * load[dof], f = force[dof] + applied, v = velocity[dof];
      const double d = particle_damping(gamma, f, v, inverse[dof], dt);
      const double on = v + dt * inverse[dof] * (f + d);
      work[lane] += applied * (v + on);
      damped[lane] -= d * (v + on);
      velocity[dof] = on;
      motion[dof] += dt * on;
      force[dof] = 0;
    }
  }
  for (int lane = 0; lane < pack_size; ++lane) {
    sums.work += 0.5 * dt * work[lane];
    sums.dissipated += 0.5 * dt * damped[lane];
  }
  return sums;
}

WIDE_AS_THE_MACHINE void turn(Bodies& bodies, Index block, double dt) {
  const Index first = block * (dofs_a_block / 6), last = std::min(bodies.count, first + dofs_a_block / 6);
  double* const w = bodies.turn[0].data();
  double* const x = bodies.turn[1].data();
  double* const y = bodies.turn[2].data();
  double* const z = bodies.turn[3].data();
  const double* const velocity = bodies.velocity.data();
#pragma omp simd
  for (Index body = first; body < last; ++body) {
    const double a = 0.5 * dt * velocity[6 * body + 3];
    const double b = 0.5 * dt * velocity[6 * body + 4];
    const double c = 0.5 * dt * velocity[6 * body + 5];
    const double norm = 1 / std::sqrt(1 + a * a + b * b + c * c);
    const double w0 = w[body], x0 = x[body], y0 = y[body], z0 = z[body];
    w[body] = norm * (w0 - a * x0 - b * y0 - c * z0);
    x[body] = norm * (x0 + a * w0 + b * z0 - c * y0);
    y[body] = norm * (y0 + b * w0 + c * x0 - a * z0);
    z[body] = norm * (z0 + c * w0 + a * y0 - b * x0);
  }
}

}  // namespace bondstatic
