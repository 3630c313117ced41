// Particles on their way through time: six numbers a body in each array, bodies one after another, and behind
// the last a ghost that takes what lanes without a bond would do. Arrays end at a multiple of pack_size.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "bondstatic/dynamics.hpp"
#include "dynamics/bond_pack.hpp"
#include "model/boundary.hpp"

namespace bondstatic {

struct Bodies {
  Index count = 0;
  std::vector<double> motion;               ///< at the whole step
  std::vector<double> velocity;             ///< half a step before
  std::vector<double> force;                ///< of the bonds, at the whole step
  std::array<std::vector<double>, 4> turn;  ///< w, x, y, z of unit quaternions; where kinematics are finite

  std::vector<double> load;           ///< full, before the ramp
  std::vector<double> inverse;        ///< 1 / m, 1 / I; zero where not free
  std::vector<double> radius;         ///< one a body
  std::vector<std::uint8_t> present;  ///< one a body: 0 where left out

  /// Degrees of freedom (6 p + i) that are moved, ascending, and how far.
  std::vector<Index> moved;
  std::vector<double> how_far;
  std::vector<double>
      turned;  ///< the whole angle that its body is turned by, where kinematics are finite; else 0
};

/// Throws Error (invalid_input) that names a particle which takes part, can move and has no density.
void require_masses(const Model& model, const Boundary& boundary, const std::vector<bool>& left_out);

/// With require_masses.
Bodies make_bodies(const Model& model, const Boundary& boundary, const std::vector<bool>& left_out,
                   const DynamicOptions& options);

/// Loads and prescribed motions at a step and at the next, as parts of their full values.
struct Loading {
  double now = 1;
  double next = 1;
};

/// What a step did, over a range of bodies.
struct StepSums {
  double work = 0;
  double dissipated = 0;
};

/// Particle damping of Eq. 11-12 for one component: opposes the velocity at the whole step, which is half a
/// kick after `velocity`. Nothing where the component is not free.
inline double particle_damping(double gamma, double force, double velocity, double inverse, double dt) {
  const double size = inverse > 0 ? gamma * std::abs(force) : 0.0;
  return -std::copysign(size, velocity + 0.5 * dt * inverse * force);
}

/// At step 0 the velocity is that of the whole step; from rest, damping opposes the motion to come.
inline double first_particle_damping(double gamma, double force, double velocity, double inverse) {
  return particle_damping(gamma, force, velocity != 0 ? velocity : force, inverse, 0);
}

/// Bodies are worked on in blocks of a fixed size, so that sums do not depend on the number of threads. Whole
/// bodies and whole chunks of pack_size.
inline constexpr Index dofs_a_block = 128 * 6;

/// One step of the bodies of a block: velocities half a step on, positions a step on; forces are used up and
/// zero again.
StepSums kick_and_drift(Bodies& bodies, Index block, const DynamicOptions& options, const Loading& loading);

/// Quaternions of the bodies of a block by the spin of the step. In Cayley's form, as the bonds turn: a rigid
/// motion of the whole model then carries bodies and bonds alike.
void turn(Bodies& bodies, Index block, double dt);

}  // namespace bondstatic
