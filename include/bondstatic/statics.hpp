// The static answer: K U = F solved to the last digit that double input allows.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bondstatic/effective_stiffness.hpp"
#include "bondstatic/linear_solver.hpp"
#include "bondstatic/model.hpp"
#include "bondstatic/state.hpp"

namespace bondstatic {

/// What happens to bodies that no support touches (rattlers of a real packing).
enum class Unsupported { error, drop };

struct StaticOptions {
  std::string solver = "auto";
  std::vector<std::string> backend_options;  ///< handed on to the solver's own library (PETSc)
  int threads = 0;                           ///< at most; 0: the cores at hand
  bool yield_cores = true;   ///< fewer threads where other processes keep cores busy; the answer is the same
  double tolerance = 1e-12;  ///< on the backward error
  Unsupported unsupported = Unsupported::error;
  double memory_limit = 0;  ///< bytes; 0: what the machine and its control group have left
  std::function<void(const std::string& phase)> progress;  ///< called as each phase begins; may be null
};

/// How good the answer is. Norms run over all unknowns, rotations times network.rotation_length.
struct Accuracy {
  /// max |f - K u| / (|B^T| |C| |B| |u| + |f|), residual in natural form; rows of nothing but noise are held
  /// against what they could carry.
  double backward_error = 0;
  double forward_error = 0;  ///< bound on max |u - exact| / max |exact|
  int refinements = 0;
  double pivot_ratio = 1;
  /// |sum of loads and reactions| (force; moment about the centroid) over the sum of their magnitudes.
  double force_balance = 0;
  double moment_balance = 0;
  double energy_balance = 0;  ///< |2 U - work| / (2 U)
};

struct LoadCaseResult : State {
  Accuracy accuracy;
};

struct Phase {
  std::string name;
  double seconds = 0;
};

struct StaticReport {
  std::string solver;
  std::string solver_reason;  ///< why "auto" chose it; "" where it was asked for by name
  int threads = 1;            ///< used
  int threads_asked = 1;      ///< more than used where the machine was busy
  AnalysisReport analysis;    ///< of the largest system where supports differ between load cases
  int factorisations = 0;
  Index iterations = 0;  ///< all rounds, of an iterative solver or on an earlier factor; 0: a direct one
  std::vector<Phase> phases;
  double peak_bytes = 0;                    ///< resident peak of the process
  std::vector<std::vector<Index>> dropped;  ///< bodies left out, ids of their particles
  std::vector<std::string> warnings;
};

struct StaticSolution {
  std::vector<LoadCaseResult> cases;  ///< in the order of Model::load_cases
  StaticReport report;
  /// Of a cell that is periodic in all directions, where the load cases are nothing but strains, six of them
  /// independent.
  std::optional<EffectiveStiffness> effective = {};
};

/// Throws MechanismError, AccuracyError, MemoryError; Error (invalid_input) for an unknown solver or a degree
/// of freedom that two supports prescribe differently.
StaticSolution solve_statics(const Model& model, const StaticOptions& options);

}  // namespace bondstatic
