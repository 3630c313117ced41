// The comparison told as numbered steps.
#include "bondstatic/compare.hpp"

#include <algorithm>
#include <cmath>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/mechanism.hpp"
#include "compare/fields.hpp"
#include "compare/response.hpp"
#include "compare/suspects.hpp"
#include "compare/unbalance.hpp"
#include "compare/verdict.hpp"

namespace bondstatic {

namespace {

constexpr Index slow_modes = 10;

/// The run's motion where it is told, the static one elsewhere; nothing of the cell's strain, as K wants it.
BodyVectors<double> whole_motion(const Model& model, const State& statics, const RunState& run,
                                 const Boundary& boundary) {
  BodyVectors<double> motion(model.particles.size());
  for (std::size_t p = 0; p < motion.size(); ++p) {
    for (int i = 0; i < 6; ++i) {
      motion[p][i] = run.displacement[p][i];
      if (!std::isfinite(motion[p][i])) motion[p][i] = statics.displacement[p][i];
      if (!std::isfinite(motion[p][i])) motion[p][i] = 0;  // left out
    }
    if (model.cell)
      motion[p].head<3>() -= boundary.strain * (model.particles[p].position - model.cell->origin);
  }
  return motion;
}

/// Rotations that balance the moments where particles are held in their places.
void balance_rotations(const Model& model, const BondNetwork& network, const Boundary& boundary,
                       const StaticOptions& solve, BodyVectors<double>& motion) {
  Boundary held = boundary;
  for (std::size_t p = 0; p < motion.size(); ++p) {
    held.free[p] = std::uint8_t(held.free[p] & 0x38);
    motion[p].tail<3>() = boundary.prescribed[p].tail<3>();
  }
  Response response(model, network, held, solve);
  const auto turned = response.to(finite_residual(network, boundary, motion));
  for (std::size_t p = 0; p < motion.size(); ++p) motion[p].tail<3>() += turned[p].tail<3>();
}

}  // namespace

Comparison compare(const Model& model, const State& statics, Index load_case, const RunState& run,
                   const StaticOptions& solve, const CompareOptions& options) {
  // 1. What is apart, field by field.
  const BondNetwork network = bond_network(model, bond_properties(model));
  const Boundary boundary = boundary_of(model, load_case);
  Comparison out;
  out.run = run.name;
  out.load_case = statics.name;
  out.step = run.step;
  out.tolerance = options.tolerance;
  out.missing = run.missing;
  out.unknown = run.unknown;
  out.matched = Index(model.particles.size() - run.missing.size());
  out.notes = run.notes;
  out.worst = worst_particles(statics, run);
  BodyVectors<double> motion = whole_motion(model, statics, run, boundary);
  out.fields = compared_fields(model, network, statics, run, motion, boundary.strain);

  // 2. What the run's state carries.
  out.unbalance = unbalance_of(model, network, boundary, statics, run,
                               run.has_rotations ? motion : BodyVectors<double>{});
  const bool apart = !within_tolerance(out);
  if (!apart || !options.explain) {
    judge(out, {});
    return out;
  }

  // 3. Why they are apart.
  Evidence evidence;
  evidence.supports = support_deviation(model, statics, boundary, run);
  try {
    if (!run.has_rotations) balance_rotations(model, network, boundary, solve, motion);
  } catch (const MechanismError&) {
    out.notes.emplace_back(
        "The run tells no rotations and the bonds do not balance them: nothing is explained.");
    judge(out, {});
    return out;
  }
  Response response(model, network, boundary, solve);
  Explained explained = explain(model, network, boundary, response, statics, motion);
  out.unbalance.still_moves = explained.left;
  out.suspects = std::move(explained.suspects);
  evidence.difference = explained.difference;
  judge(out, evidence);
  if (out.verdict != CompareVerdict::unexplained) return out;

  // 4. Nothing of the case explains it: does the run move as what is slow to come to rest?
  const BodyMasses masses = masses_or_volumes(model);
  const Index count = std::min(slow_modes, response.dofs().unknowns() / 6);
  if (count == 0) return out;
  try {
    out.unbalance.slow_modes = share_of_modes(response.lowest_modes(masses, count), masses, response.dofs(),
                                              finite_residual(network, boundary, motion));
  } catch (const AccuracyError&) {
    return out;  // the modes are so close together that none stands out
  }
  judge(out, evidence);
  return out;
}

}  // namespace bondstatic
