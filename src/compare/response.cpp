#include "compare/response.hpp"

#include "solver/machine.hpp"
#include "statics/refine.hpp"

namespace bondstatic {

Response::Response(const Model& model, const BondNetwork& network, const Boundary& boundary,
                   const StaticOptions& options)
    : network_(network),
      incidence_(link_incidence(network)),
      held_(held_by(model, network, boundary.free, options.unsupported)),
      threads_(options.threads > 0 ? options.threads : cores_at_hand()) {
  if (options.yield_cores) threads_ = threads_worth_having(threads_);
  if (held_.dofs.unknowns() == 0) return;
  chosen_ = choose(network_, incidence_, held_.dofs, options, threads_);
  pivot_ratio_ = chosen_.solver->factorise(network_, held_.dofs).pivot_ratio;
}

BodyVectors<double> Response::to(const BodyVectors<double>& forces) {
  const BodyVectors<double> nothing(forces.size(), Vector6::Zero());
  if (!chosen_.solver) return nothing;
  bool any = false;
  for (std::size_t p = 0; p < forces.size() && !any; ++p)
    for (int i = 0; i < 6; ++i) any = any || (held_.dofs.is_free(Index(p), i) && forces[p][i] != 0);
  if (!any) return nothing;
  const Boundary boundary{held_.dofs.free, nothing, forces};
  Effort effort;
  const auto refined = solve_refined(network_, incidence_, held_.dofs, {&boundary}, chosen_.solver.get(),
                                     pivot_ratio_, threads_, effort, {});
  return converted<double>(refined.front().motion);
}

std::vector<Mode> Response::lowest_modes(const BodyMasses& masses, Index count) {
  if (!chosen_.solver) return {};
  return bondstatic::lowest_modes(network_, held_.dofs, masses, *chosen_.solver, count);
}

}  // namespace bondstatic
