// Quasi-static fracture without time: which bond breaks first, at what load, and what follows.
//
// The state is that of the loads that stay (preload) and a factor times those that scale (pattern), u = u_0 +
// factor u_1, linear between two breaks. So the factor at which the next bond reaches its strength has an
// exact value; that bond is taken out, the state solved for again, and so on. Nothing heals, nothing is
// touched anew: cracks that close do not carry.
//
// Load P and displacement d are a pair: P dd is the work of the pattern. Where it is one of forces, P is
// factor * sum |force| and d the mean displacement of the loaded particles along their forces, weighed by
// them; where it is a prescribed motion, d is factor * the largest prescribed displacement and P the sum of
// the reactions along it, weighed likewise. A pattern of moments or rotations alone counts these instead; of
// a periodic cell's strain, d is factor * the largest component of the strain and P the conjugate stress
// times volume.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bondstatic/model.hpp"
#include "bondstatic/state.hpp"
#include "bondstatic/statics.hpp"
#include "bondstatic/strength.hpp"

namespace bondstatic {

/// What never falls. At a constant value of it, bonds may break one after another: an avalanche.
enum class FractureControl {
  load,          ///< P: dead weights
  displacement,  ///< d: a stiff machine
  event,         ///< neither: the factor is always what brings the next bond to its strength, and may fall.
                 ///< Shows the whole curve, snap-back included; an avalanche is then what happens below the
                 ///< largest factor so far
};

struct FractureOptions {
  Index pattern = 0;   ///< load case that scales
  Index preload = -1;  ///< load case that stays; -1: none
  FractureControl control = FractureControl::event;
  double tie = 1e-9;  ///< bonds break together whose utilisations differ by no more than this part
  // The run ends where one of these is passed, or the specimen is separated.
  Index max_breaks = std::numeric_limits<Index>::max();
  double max_factor = std::numeric_limits<double>::infinity();
  double max_displacement = std::numeric_limits<double>::infinity();
  double load_drop = 1;  ///< part of the largest load by which it has fallen; 1: however far
  Index save_every = 0;  ///< breaks between the states that are shown (hooks); 0: only the first and the last
};

struct BrokenBond {
  Index bond = 0;  ///< position in Model::bonds
  int mode = 0;    ///< position in the modes of its criterion
  double utilisation = 1;
};

/// Bonds that break together, and the state around it.
struct FractureEvent {
  double factor = 0;        ///< at which they break
  double load = 0;          ///< P, while they still carry
  double displacement = 0;  ///< d, likewise
  double factor_after = 0;  ///< when they are gone, what is controlled held constant (event: the factor)
  double load_after = 0;
  double displacement_after = 0;
  double runner_up = 0;  ///< largest utilisation among those that stay, before
  double released = 0;   ///< energy: half the work that the bonds' resultants do on their ends' separation
  double strain_energy = 0;  ///< of all bonds, after
  double work = 0;           ///< of all loads and prescribed motions since the preload was on, after
  double dissipated = 0;     ///< sum of `released`
  Index avalanche = 0;       ///< from 1
  std::vector<BrokenBond> bonds;
};

enum class FractureEnd {
  breaks,
  factor,
  displacement,
  load_drop,
  separated,
  unbreakable,
  mechanism,
  interrupted
};

/// One line for people: "specimen separated", "asked number of breaks", ...
std::string text_of(FractureEnd end);

struct SeparatedBody {
  std::vector<Index> particles;  ///< ids
  std::size_t event = 0;         ///< after which it hung on nothing
};

struct FractureReport {
  /// Solver, threads, what was dropped and warned of; the analysis is that of the last order.
  StaticReport first;
  int factorisations = 0;
  int analyses = 0;
  double backward_error = 0;  ///< largest of all states, as in Accuracy
  double forward_error = 0;   ///< likewise
  double energy_balance = 0;  ///< largest |work - strain_energy - dissipated + its start| over the work
  double seconds = 0;
};

struct Fracture {
  std::vector<FractureEvent> events;
  std::vector<Index> break_event;  ///< of each bond, position in `events`; -1: whole
  std::vector<SeparatedBody> separated;
  FractureEnd end = FractureEnd::interrupted;
  std::string reason;  ///< what exactly ended it: "particle 7 turns freely about ..."
  State last;          ///< after the last event, at the factor then; broken bonds carry nothing
  FractureReport report;
  std::vector<std::string> warnings;
};

struct FractureProgress {
  Index events = 0;
  Index breaks = 0;
  double factor = 0;
  double load = 0;
  double displacement = 0;
  double largest_load = 0;
};

/// All of them may be empty.
struct FractureHooks {
  /// Called after every event; false stops the run.
  std::function<bool(const FractureProgress&)> progress;
  /// Each event's state just before its bonds break, for columns of the history. Slower.
  std::function<void(std::size_t event, const State&)> probe;
  /// The states asked for by save_every: at the first event while all is whole, then after events.
  /// `break_event` as in Fracture.
  std::function<void(std::size_t event, const State&, const std::vector<Index>& break_event)> show;
  /// Takes a checkpoint: at most every `keep_every` seconds, and when stopped.
  std::function<void(const std::string&)> keep;
  double keep_every = 60;
  /// Content of a checkpoint to go on from, bit for bit as if there had been no stop.
  std::string resume;
  std::string resume_name = "checkpoint";  ///< in messages
};

/// Throws what solve_statics throws for the intact model; Error (invalid_input) where no bond has a strength,
/// where pattern and preload hold different degrees of freedom, or the pattern scales nothing, or both forces
/// and motions; where the preload alone breaks bonds they break at factor 0. Error
/// (invalid_input), too, where the checkpoint is damaged or of another model or other options (where to stop
/// apart).
Fracture fracture(const Model& model, const FractureOptions& options, const StaticOptions& solve,
                  const FractureHooks& hooks = {});

}  // namespace bondstatic
