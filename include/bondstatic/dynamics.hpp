// The explicit DEM run: bonds advanced increment by increment, particles by central differences. It knows the
// bond laws but nothing of stiffness matrices: that its state of rest is the static answer proves both.
//
// Scheme (leapfrog, which is velocity Verlet with its two half kicks made one): velocities stand at half
// steps, positions and forces at whole ones,
//
//     v(n+1/2) = v(n-1/2) + dt F(n) / m,    x(n+1) = x(n) + dt v(n+1/2),    dF = k v_cr(n+1/2) dt
//
// ([Chen2022] Table 8 with Eq. 1-7). Spheres: I = 2/5 m R^2, so no gyroscopic terms. Particle damping is
// Eq. 11-12, viscous bond damping Eq. 9-10; a dashpot's force is that of the velocity half a step before.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/model.hpp"
#include "bondstatic/state.hpp"

namespace bondstatic {

enum class Kinematics {
  small,   ///< bond frames and lever arms stay as they were: the limit is the linear static answer
  finite,  ///< they follow the particles, as in any DEM code
};

/// How loads and prescribed motions grow from zero to their full value.
enum class Ramp {
  linear,  ///< at constant rate
  smooth,  ///< s^2 (3 - 2s): no jump of the rate
};

/// Dashpots beside the springs of a bond, m and I reduced ([Chen2022] Eq. 9-10); where the partner is held,
/// the other's own. The two forms add up.
struct BondDamping {
  double paper = 0;   ///< eta as printed: 2 eta sqrt(kn m) for all forces, 2 eta sqrt(2 kt I) for all moments
  double normal = 0;  ///< a fraction of critical each, with its own stiffness: 2 eta sqrt(kn m)
  double shear = 0;   ///< 2 eta sqrt(ks m)
  double twisting = 0;  ///< 2 eta sqrt(kt I)
  double bending = 0;   ///< 2 eta sqrt(kb I)

  bool any() const { return paper > 0 || normal > 0 || shear > 0 || twisting > 0 || bending > 0; }
};

struct DynamicOptions {
  Kinematics kinematics = Kinematics::finite;
  double particle_damping = 0.7;  ///< gamma of Eq. 11-12: -gamma |F| sign(U), 0 <= gamma < 1
  BondDamping bond_damping;
  double time_step = 0;  ///< must be positive
  Ramp ramp = Ramp::linear;
  double ramp_time = 0;    ///< 0: full load at once
  double load_factor = 1;  ///< times all loads and prescribed motions
  int threads = 1;         ///< the run has the same bits at any number
};

/// At a whole step, since the start. Central differences hold
///
///     kinetic - held_back + strain + dissipated - work = initial kinetic energy
///
/// to rounding where kinematics are small, to second order in the step where they are finite.
struct Energies {
  double kinetic = 0;     ///< with the mean of the velocities half a step before and after
  double strain = 0;      ///< of all bonds
  double dissipated = 0;  ///< by particle damping and dashpots
  double work = 0;        ///< of loads and of moved supports
  double held_back = 0;   ///< sum of m (a dt)^2 / 8, a property of the scheme
  double initial = 0;

  /// What the identity above leaves, over the largest energy that was at work.
  double balance() const;
};

/// How far from rest. Free degrees of freedom only.
struct Unrest {
  double fastest = 0;     ///< largest speed of a particle's centre or, by its spin, of its surface
  Index particle = -1;    ///< which, by model position
  double unbalanced = 0;  ///< norm of the unbalanced forces over that of loads and reactions; moments over R
};

/// Dashpot coefficients of every bond in the places of the stiffness (force per velocity, moment per spin).
std::vector<SectionStiffness> dashpots(const Model& model, std::span<const BondProperties> properties,
                                       std::span<const std::uint8_t> free, const BondDamping& damping);

/// Bytes that a run of this model holds.
double run_memory(const Model& model, const DynamicOptions& options);

/// One load case of a model on its way through time. Starts at rest without loads.
class ExplicitRun {
 public:
  /// `left_out` particles (and their bonds) take no part. All others need a density. Throws Error
  /// (invalid_input) where one has none or supports contradict.
  ExplicitRun(const Model& model, std::span<const BondProperties> properties, Index load_case,
              const std::vector<bool>& left_out, const DynamicOptions& options);
  ~ExplicitRun();
  ExplicitRun(ExplicitRun&&) noexcept;

  /// Velocity and spin of a free particle at step 0.
  void set_velocity(Index particle, const Vector6& velocity);

  void advance(Index steps);

  Index step() const;
  double time() const;         ///< step() times the time step
  double load_factor() const;  ///< of this moment, on the ramp
  Energies energies() const;
  Unrest unrest() const;

  /// Displacements, reactions and bond forces of this moment. With finite kinematics rx, ry, rz is the
  /// rotation vector of the particle's quaternion (at most pi), otherwise the sum of all increments.
  State state() const;
  Vector6 velocity(Index particle) const;    ///< mean of the half steps before and after
  Vector6 bond_force(Index particle) const;  ///< of all its bonds, at the centre
  Eigen::Quaterniond orientation(Index particle) const;

  /// Everything that changes, bit for bit; to be loaded into a run made with the same arguments. load()
  /// throws Error (invalid_input) where the data do not fit.
  std::string save() const;
  void load(std::string_view saved);

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace bondstatic
