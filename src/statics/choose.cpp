#include "statics/choose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bondstatic/error.hpp"
#include "solver/cost_model.hpp"
#include "solver/machine.hpp"

namespace bondstatic {

namespace {

// Below this many particles a direct solver takes no time worth asking about, and nothing stops it.
constexpr Index always_direct = 1500;

// Above this many, the analysis of a direct solver alone takes as long as the whole multigrid, unless the
// bonds make chains and little more.
constexpr Index hardly_direct = 200000;
constexpr double chain_like = 1.3;  // bonds a particle

std::string size_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.3g} MB", bytes / 1e6) : fmt::format("{:.3g} GB", bytes / 1e9);
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
    if (info.name != "multigrid" && !info.on_ranks) return info.name;
  return "eigen";
}

Chosen analysed(const std::string& name, const BondNetwork& network, const FreeDofs& dofs,
                const StaticOptions& options, int threads) {
  Chosen chosen{make_solver(name, threads, options.backend_options), name, "", {}};
  chosen.analysis = chosen.solver->analyse(network, dofs);
  return chosen;
}

}  // namespace

Chosen choose(const BondNetwork& network, const FreeDofs& dofs, const StaticOptions& options, int threads) {
  const double limit = memory_at_hand(options);
  const Cost multigrid = multigrid_cost(network, threads);
  if (options.solver != "auto") {
    Chosen chosen = analysed(options.solver, network, dofs, options, threads);
    if (chosen.analysis.predicted_bytes > limit)
      does_not_fit(chosen.analysis, limit, chosen.name, multigrid.bytes);
    return chosen;
  }
  const bool chains = double(network.links.size()) < chain_like * double(network.bodies);
  if (network.bodies > hardly_direct && !chains && multigrid.bytes <= limit) {
    Chosen chosen = analysed("multigrid", network, dofs, options, threads);
    chosen.reason = fmt::format("multigrid: more than {} particles", hardly_direct);
    return chosen;
  }
  Chosen direct = analysed(first_direct(), network, dofs, options, threads);
  if (network.bodies <= always_direct && direct.analysis.predicted_bytes <= limit) {
    direct.reason = fmt::format("{}: at most {} particles", direct.name, always_direct);
    return direct;
  }
  const DirectRates& rates = direct.name == "cholmod" ? cholmod_rates : eigen_rates;
  const std::array<Candidate, 2> candidates{
      Candidate{direct.name, direct_cost(direct.analysis, rates, threads)},
      Candidate{"multigrid", multigrid}};
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
