// From a model to its state of rest by an explicit DEM run: time step from the highest frequency, loads
// ramped, damped until nothing moves for a period of the slowest mode.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bondstatic/dynamics.hpp"
#include "bondstatic/statics.hpp"

namespace bondstatic {

struct RelaxOptions {
  Kinematics kinematics = Kinematics::finite;
  double particle_damping = 0.7;
  BondDamping bond_damping;
  double time_step = 0;  ///< 0: safety times the critical one
  double safety = 0.8;   ///< of the critical one; at 1 and beyond a run may blow up
  Ramp ramp = Ramp::linear;
  double ramp_time = not_given;  ///< NaN: one period of the lowest frequency, 0: at once
  double velocity_limit = 1e-9;  ///< on the fastest particle, in the model's units ([Chen2022]: 1e-9 m/s)
  double force_limit = 1e-8;     ///< on the unbalanced force over the loads
  double hold_time = not_given;  ///< both limits hold for so long; NaN: one period of the lowest frequency
  Index max_steps = 1'000'000'000;
  double record_interval = not_given;  ///< between rows of the history; NaN: a sixteenth of the hold time
  double save_interval = not_given;    ///< between states kept on the way (RelaxHooks::show); NaN: none
  double load_factor = 1;              ///< times all loads and prescribed motions
  double check_tolerance = 1e-6;       ///< on the differences that the certificate compares
};

/// What is known of a run before its first step, for one load case.
struct DynamicPlan {
  double critical_time_step = 0;  ///< largest stable one (modes.hpp), dashpots and particle damping counted
  double time_step = 0;           ///< safety times that, rounded down to three digits, or as asked for
  double highest = 0;             ///< angular frequency
  std::vector<double> lowest;     ///< a few, angular, ascending; empty where the factor did not fit in memory
  double ramp_time = 0;
  double hold_time = 0;
  double speed = 0;            ///< of the slowest mode when the ramp ends, estimated from the static answer
  double decay = 0;            ///< of its amplitude, one over time, by the damping asked for
  double predicted_steps = 0;  ///< until at rest; infinite without damping
  double best_particle_damping = 0;
  double best_decay = 0;
  double best_predicted_steps = 0;  ///< with it in place of the particle damping asked for
};

enum class RunEnd { at_rest, step_limit, interrupted };

struct HistoryColumn {
  std::string name;
  std::vector<double> values;
};

/// A state that was kept on the way, by its place in time.
struct SavedState {
  Index step = 0;
  double time = 0;  ///< of the model
};

/// More are never kept of a load case, the last state apart: where a run is so long, every second one is
/// dropped and the interval doubles, again and again. So a run of any length writes 512 states, and 256 more
/// each time that it has become twice as long.
inline constexpr std::size_t most_saved_states = 512;

struct RelaxedCase {
  State state;
  DynamicPlan plan;
  RunEnd end = RunEnd::interrupted;
  Index steps = 0;
  double time = 0;  ///< of the model
  Energies energies;
  Unrest unrest;
  double seconds = 0;  ///< of the clock on the wall, those before a resumption included

  /// step, time, load_factor, kinetic, strain, work, dissipated, balance, fastest, unbalanced, probes. At
  /// most some thousand rows: of longer runs, every second row is dropped again and again.
  std::vector<HistoryColumn> history;

  /// What RelaxHooks::show has heard of, ascending, without what was dropped again.
  std::vector<SavedState> saved;
};

struct Relaxation {
  std::vector<RelaxedCase> cases;           ///< in the order of Model::load_cases; fewer where interrupted
  std::vector<std::vector<Index>> dropped;  ///< bodies left out, by particle id
  std::vector<std::string> warnings;
  double planning_seconds = 0;
  int threads = 1;
  bool interrupted = false;  ///< the progress hook stopped it

  bool at_rest() const;  ///< every load case of the model
};

struct RelaxProgress {
  std::string load_case;
  Index step = 0;
  double time = 0;
  Unrest unrest;
  double seconds_left = 0;  ///< for this load case, estimated; NaN where nothing is known
};

using Probes = std::vector<std::pair<std::string, double>>;

/// All of them may be empty.
struct RelaxHooks {
  /// Further columns of the history, the same names at every call for a load case.
  std::function<Probes(const State&)> probe;
  /// Tells probes apart: a checkpoint made with another is refused.
  std::uint64_t probe_fingerprint = 0;
  /// Takes the states that save_interval asks for. They stand at looks: the first one at or after each
  /// multiple of the interval, beginning with step 0, and where the run ends. A look is no nearer to the next
  /// than rows of the history are (record_interval); none is added, so that the answer does not depend on
  /// what is kept. `velocity` of each particle, NaN where it was left out; `saved`: all states of the load
  /// case that stand from now on, this one the last of them. After a resumption states may come again, with
  /// the same bits.
  std::function<void(const State&, const std::vector<Vector6>& velocity,
                     const std::vector<SavedState>& saved)>
      show;
  /// Hears of the states that the run to go on with has shown, for each load case that it had begun.
  std::function<void(const std::vector<std::vector<SavedState>>&)> resumed;
  /// Called before a load case is planned, which may take a while and hears of nothing, and before it runs.
  std::function<void(bool planning)> phase;
  /// Called at every look, often or not; false stops the run.
  std::function<bool(const RelaxProgress&)> progress;
  /// Takes a checkpoint: at most every `keep_every` seconds, when stopped, and where a run ends at its limit
  /// of steps.
  std::function<void(const std::string&)> keep;
  double keep_every = 60;
  /// Content of a checkpoint to go on from, bit for bit as if there had been no stop.
  std::string resume;
  std::string resume_name = "checkpoint";  ///< in messages
};

/// Throws what solve_statics throws before the solver runs; AccuracyError where a run blows up; Error
/// (invalid_input) where the checkpoint is damaged or of another model or other options (max_steps apart), or
/// a particle has no density; MemoryError where the factor for the slowest mode does not fit and neither
/// ramp_time nor hold_time say how slow it is.
Relaxation relax(const Model& model, const RelaxOptions& options, const StaticOptions& solve,
                 const RelaxHooks& hooks = {});

/// Decay of a single mode's amplitude under particle damping, as a part of its angular frequency. From rest
/// at amplitude A the oscillator falls with (1 - gamma) of its force and is stopped by (1 + gamma) of it, so
/// that half a cycle later A' = A sqrt((1 - gamma)/(1 + gamma)), after pi/2w (1/sqrt(1 - gamma) + 1/sqrt(1 +
/// gamma)).
double particle_damping_decay(double gamma);

}  // namespace bondstatic
