// What a solve will take, known before it is begun, and the choice that follows. The rates were measured by
// tests/bench/run solvers on one machine (AMD EPYC 7003, 45 Gflop/s of dgemm a core); on another all of them
// move together, so that the crossovers stay where they are.
#pragma once

#include <span>
#include <string>

#include "bondstatic/linear_solver.hpp"

namespace bondstatic {

struct Cost {
  double seconds = 0;  ///< from the start of the analysis to the refined answer of one load case
  double bytes = 0;    ///< peak, what stands in memory already not counted
};

std::string size_text(double bytes);
std::string figures(const Cost& cost);  ///< "1.2 s and 46 MB"

/// Seconds a direct solver takes for each unit of work, on one thread, and what threads do for the
/// factorisation: with t of them it is t^thread_exponent times as fast.
struct DirectRates {
  double per_flop;          ///< of the factor
  double per_factor_entry;  ///< pages first touched, updates added, a handful of back-substitutions
  double per_matrix_entry;  ///< ordering, analysis, assembly, residuals
  double thread_exponent;
};
inline constexpr DirectRates cholmod_rates{1 / 40e9, 1.2e-8, 3.5e-7, 0.6};
inline constexpr DirectRates eigen_rates{1 / 1.5e9, 1.2e-8, 3.5e-7, 0};
Cost direct_cost(const AnalysisReport& analysis, const DirectRates& rates, int threads);

/// Of one thread, likewise: a numerical factorisation alone, and an iteration that has such a factor as its
/// preconditioner, one right-hand side.
double factorisation_seconds(const AnalysisReport& analysis, const DirectRates& rates);
double kept_factor_seconds(const AnalysisReport& analysis, Index links);

/// Of a method whose work grows as the model does.
struct LinearRates {
  double seconds_per_body;
  double seconds_per_link;
  double bytes_per_body;
  double bytes_per_link;
  double thread_exponent;  ///< with t threads all of it is t^thread_exponent times as fast
};
inline constexpr LinearRates multigrid_rates{3e-5, 3e-6, 880, 190, 0.7};
/// The rates are those of packings; sheets and chains one particle thick take many more iterations.
inline constexpr double multigrid_doubt = 2;
Cost linear_cost(Index bodies, Index links, const LinearRates& rates, int threads);

/// Bytes that the caller of a solver keeps while it refines and recovers one load case: motion, residual and
/// resultants in extended precision, right-hand sides and corrections, the state.
double solution_bytes(double links, double bodies);

struct Candidate {
  std::string solver;
  Cost cost;
  double doubt =
      1;  ///< it may take this many times as long as predicted: others are preferred that take less
};

struct Choice {
  std::string solver;
  std::string reason;  ///< a sentence with the figures
  bool fits = true;    ///< false: nothing fits, and this takes least
};

/// The fastest, doubts included, that fits into `memory` (bytes); the earlier of two equals. Throws
/// std::invalid_argument where there is no candidate.
Choice choose_solver(std::span<const Candidate> candidates, double memory);

}  // namespace bondstatic
