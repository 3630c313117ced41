#include "statics/choose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bondstatic/error.hpp"
#include "solver/cost_model.hpp"
#include "solver/machine.hpp"
#include "system/level_elimination.hpp"

namespace bondstatic {

namespace {

// Below this many particles a direct solver takes no time worth asking about, and nothing stops it.
constexpr Index always_direct = 1500;

// How many times the operations of nested dissection an elimination level by level takes, at most: on a sheet
// of n particles the first takes n^1.5 of them and the second n^2.
double dissection_gains(Index bodies) {
  return std::max(20.0, std::sqrt(double(bodies)) / 5);
}

double memory_at_hand(const StaticOptions& options) {
  return options.memory_limit > 0 ? options.memory_limit : available_memory();
}

Cost multigrid_cost(const BondNetwork& network, int threads) {
  return linear_cost(network.bodies, Index(network.links.size()), multigrid_rates, threads);
}

[[noreturn]] void does_not_fit(const AnalysisReport& analysis, double limit, const std::string& name,
                               double multigrid_bytes) {
  const bool other = name != "multigrid" && multigrid_bytes <= limit;
  throw MemoryError(
      fmt::format("the solve of {} unknowns by {} needs {} of memory, {} are at hand\n    cure: {}",
                  analysis.unknowns, name, size_text(analysis.predicted_bytes), size_text(limit),
                  other ? fmt::format("--solver multigrid needs {}", size_text(multigrid_bytes))
                        : "use a machine with more memory, several with --solver petsc, or a smaller model"));
}

std::string first_direct() {
  for (const SolverInfo& info : available_solvers())
    if (!info.on_ranks) return info.name;
  return "eigen";
}

Chosen analysed(const std::string& name, const BondNetwork& network, const FreeDofs& dofs,
                const StaticOptions& options, int threads) {
  Chosen chosen{make_solver(name, threads, options.backend_options), name, "", {}};
  chosen.analysis = chosen.solver->analyse(network, dofs);
  return chosen;
}

}  // namespace

Chosen choose(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
              const StaticOptions& options, int threads, int solves) {
  const double limit = memory_at_hand(options);
  Cost multigrid = multigrid_cost(network, threads);
  multigrid.seconds *= solves;
  if (options.solver != "auto") {
    Chosen chosen = analysed(options.solver, network, dofs, options, threads);
    if (chosen.analysis.predicted_bytes > limit)
      does_not_fit(chosen.analysis, limit, chosen.name, multigrid.bytes);
    return chosen;
  }
  // Ordering and analysis of a direct solver take as long as the whole multigrid: not for a packing that it
  // will not get.
  const std::string direct_name = first_direct();
  const DirectRates& rates = direct_name == "cholmod" ? cholmod_rates : eigen_rates;
  const double worthwhile =
      dissection_gains(network.bodies) * multigrid_doubt * multigrid.seconds / rates.per_flop;
  if (network.bodies > always_direct && multigrid.bytes <= limit &&
      level_elimination_flops(network, incidence, dofs, worthwhile) >= worthwhile) {
    Chosen chosen = analysed("multigrid", network, dofs, options, threads);
    chosen.reason = fmt::format("multigrid: predicted {}, a direct solver more", figures(multigrid));
    return chosen;
  }
  Chosen direct = analysed(direct_name, network, dofs, options, threads);
  if (network.bodies <= always_direct && direct.analysis.predicted_bytes <= limit) {
    direct.reason = fmt::format("{}: at most {} particles", direct.name, always_direct);
    return direct;
  }
  const std::array<Candidate, 2> candidates{
      Candidate{direct.name, direct_cost(direct.analysis, rates, threads)},
      Candidate{"multigrid", multigrid, multigrid_doubt}};
  const Choice choice = choose_solver(candidates, limit);
  if (!choice.fits) does_not_fit(direct.analysis, limit, direct.name, multigrid.bytes);
  if (choice.solver == "multigrid") direct = analysed("multigrid", network, dofs, options, threads);
  direct.reason = choice.reason;
  return direct;
}

Chosen choose_direct(const BondNetwork& network, const FreeDofs& dofs, const StaticOptions& options,
                     int threads) {
  Chosen direct = analysed(first_direct(), network, dofs, options, threads);
  if (direct.analysis.predicted_bytes > memory_at_hand(options)) direct.solver.reset();
  return direct;
}

}  // namespace bondstatic
