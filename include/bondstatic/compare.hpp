// A DEM run's end state beside the static answer: how far apart they are, what forces the run's state still
// carries, and why.
//
// With u the motion of the run, f the loads and K the case's stiffness, the run's state carries the residual
// r = f - K u, and u - u_static = -K^-1 r whatever the reason for it. So each possible reason is put in place
// of what the case says, and what is left of K^-1 r is how badly it explains the run: factors on the normal,
// shear, twisting and bending stiffness of all bonds (r is linear in them), another contact point, other
// loads, kinematics of finite rotations. Nothing but the case's own K is ever solved with.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/model.hpp"
#include "bondstatic/state.hpp"
#include "bondstatic/statics.hpp"

namespace bondstatic {

/// What a run says of a case's particles and bonds, in the case's order. NaN where it does not say.
struct RunState {
  std::string name;  ///< where it comes from: "dump.final"
  Index step = 0;
  std::vector<Vector6> displacement;  ///< from the case's positions; rotation vectors
  bool has_rotations = false;
  std::vector<Vector6> velocity;    ///< and spin; empty where not written
  std::vector<Vector6> net_force;   ///< and torque, of all that acts on a particle; empty where not written
  std::vector<Vector6> bond_force;  ///< on b at the contact point, and moment, as BondResult; empty likewise
  bool normal_force_only = false;   ///< bond_force has only the component along the bond
  std::vector<Index> missing;       ///< ids of the case that the run lacks
  std::vector<Index> unknown;       ///< ids of the run that the case lacks
  std::vector<std::string> notes;   ///< what was assumed of the run's file, full sentences
};

/// One field of the answer. Relative figures are over the static field, or a thousandth of what its kind
/// could be where it vanishes.
struct FieldComparison {
  std::string field;  ///< displacement, rotation, normal force, shear force, ..., energy
  double static_norm = 0;
  double run_norm = 0;
  double difference = 0;  ///< norm of the difference, relative
  double largest = 0;     ///< largest difference, relative to the largest magnitude
  Index at = -1;          ///< where: model position of the particle or bond; -1 for the energy
  bool of_bond = false;
  double scale = not_given;   ///< s that brings s * static nearest to the run
  double misfit = not_given;  ///< norm of what is left then, relative
};

/// Of particles, in descending order of |difference|.
struct WorstParticle {
  Index particle = 0;  ///< model position
  Vector6 statics = Vector6::Zero();
  Vector6 run = Vector6::Zero();
};

/// What the run's state carries that rest does not. Forces over the norm of loads and static reactions,
/// moments over network.rotation_length; free degrees of freedom only. NaN where the run does not tell.
struct Unbalance {
  double linear = not_given;       ///< |f - K u|: the finer the state is written, the less noise it has
  double finite = not_given;       ///< the same where bonds turn with their particles
  double still_moves = not_given;  ///< |K^-1 r| over |u_static|, r as `finite`: how far away rest is
  double kinetic = not_given;      ///< kinetic energy over the static strain energy
  double fastest = not_given;      ///< largest speed of a particle's centre
  double net_force = not_given;    ///< of the forces that the run itself writes
  double moving_part = not_given;  ///< share of r that the run's own net force confirms
  double slow_modes = not_given;   ///< share of the acceleration M^-1 r that the slowest modes have
};

/// One thing that could be different from what the case says.
struct Suspect {
  std::string what;  ///< "shear stiffness", "contact point", "all stiffness or all loads", "each stiffness"
  std::string text;  ///< "shear stiffness 0.9901 times the case's"
  std::vector<double> factors;  ///< times the case's; the fraction of radii for a contact point
  double left = 0;              ///< |K^-1 r| with it over |u_static|
};

enum class CompareVerdict { same_state, still_moving, different_model, unexplained };

struct Comparison {
  std::string run;
  std::string load_case;
  Index step = 0;
  double tolerance = 0;
  CompareVerdict verdict = CompareVerdict::unexplained;
  std::string reason;  ///< one sentence
  std::vector<FieldComparison> fields;
  std::vector<WorstParticle> worst;
  Unbalance unbalance;
  std::vector<Suspect> suspects;  ///< best first; empty where nothing had to be explained
  Index matched = 0;
  std::vector<Index> missing, unknown;
  std::vector<std::string> notes;
};

const char* name_of(CompareVerdict verdict);  ///< "same state", ...

struct CompareOptions {
  /// On the norms of displacement and rotation, relative. A run of finite rotations at rest by the usual
  /// criteria is within some 1e-4 of the linear answer; a stiffness that is wrong by 1 % is beyond 1e-3.
  double tolerance = 1e-3;
  bool explain = true;  ///< false: the differences alone, without any solve
};

/// `statics` is the static answer of load case `load_case`. Throws what solve_statics throws.
Comparison compare(const Model& model, const State& statics, Index load_case, const RunState& run,
                   const StaticOptions& solve, const CompareOptions& options = {});

}  // namespace bondstatic
