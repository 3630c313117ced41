// The route to any state of a fracture run that knows nothing of the run: a plain solve of what was left of
// the model, under the loads of that moment.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "bondstatic/fracture.hpp"
#include "model/boundary.hpp"

namespace bondstatic::test {

/// One load case, the preload and `factor` times the pattern, without the bonds that broke before `event`.
inline Model broken_model(Model model, const FractureOptions& options, const Fracture& found,
                          std::size_t event, double factor) {
  std::vector<Bond> left;
  for (std::size_t k = 0; k < model.bonds.size(); ++k)
    if (found.break_event[k] < 0 || found.break_event[k] >= Index(event)) left.push_back(model.bonds[k]);
  model.bonds = std::move(left);
  const Boundary scaled = boundary_of(model, options.pattern);
  Boundary then = scaled;
  if (options.preload >= 0)
    then = boundary_of(model, options.preload);
  else
    for (std::size_t p = 0; p < then.load.size(); ++p) then.load[p] = then.prescribed[p] = Vector6::Zero();
  if (options.preload < 0) then.strain.setZero();
  model.supports.clear();
  model.loads.clear();
  for (std::size_t p = 0; p < then.load.size(); ++p) {
    Support support{Index(p), {}, then.prescribed[p] + factor * scaled.prescribed[p], every_case};
    for (std::size_t i = 0; i < 6; ++i) support.fixed[i] = !((scaled.free[p] >> i) & 1);
    if (scaled.free[p] != 0x3f) model.supports.push_back(support);
    const Vector6 force = then.load[p] + factor * scaled.load[p];
    if (!force.isZero(0)) model.loads.push_back({Index(p), force, every_case});
  }
  model.strains.clear();
  if (model.cell) model.strains.push_back({then.strain + factor * scaled.strain, every_case});
  model.load_cases = {"then"};
  return model;
}

inline State solved_with_drop(const Model& model) {
  StaticOptions plain;
  plain.threads = 1;
  plain.unsupported = Unsupported::drop;
  return solve_statics(model, plain).cases[0];
}

/// Largest difference of translations, rotations (of `found` by particle, both in the same order) or of
/// resultants, over the largest of its kind; infinite where one is left out and the other is not.
struct StateDifference {
  double translation = 0;
  double rotation = 0;
  double reaction = 0;
  double bond_force = 0;
  double energy = 0;
  double largest() const { return std::max({translation, rotation, reaction, bond_force, energy}); }
};

/// `fresh` is of broken_model(model, ..., event, ...): its bonds are those that had not broken.
inline StateDifference difference(const State& found, const State& fresh, const Fracture& run,
                                  std::size_t event) {
  struct Field {
    double apart = 0, size = 0;
    void take(const Vector3& l, const Vector3& r) {
      if (std::isnan(l[0]) != std::isnan(r[0])) apart = std::numeric_limits<double>::infinity();
      if (std::isnan(l[0]) || std::isnan(r[0])) return;
      apart = std::max(apart, (l - r).cwiseAbs().maxCoeff());
      size = std::max(size, r.cwiseAbs().maxCoeff());
    }
    double relative() const { return apart == 0 ? 0 : apart / size; }
  } translation, rotation, reaction, bond_force;
  EXPECT_EQ(found.displacement.size(), fresh.displacement.size());
  for (std::size_t p = 0; p < fresh.displacement.size(); ++p) {
    translation.take(found.displacement[p].head<3>(), fresh.displacement[p].head<3>());
    rotation.take(found.displacement[p].tail<3>(), fresh.displacement[p].tail<3>());
    reaction.take(found.reaction[p].head<3>(), fresh.reaction[p].head<3>());
  }
  std::size_t left = 0;
  for (std::size_t k = 0; k < run.break_event.size(); ++k) {
    if (run.break_event[k] >= 0 && run.break_event[k] < Index(event)) continue;
    bond_force.take(found.bonds[k].force.head<3>(), fresh.bonds.at(left++).force.head<3>());
  }
  EXPECT_EQ(left, fresh.bonds.size());
  return {translation.relative(), rotation.relative(), reaction.relative(), bond_force.relative(),
          std::abs(found.energy / fresh.energy - 1)};
}

/// A run, and each event's state just before its bonds broke.
struct WatchedRun {
  Fracture found;
  std::vector<State> states;
};

inline WatchedRun watched(const Model& model, const FractureOptions& options, const StaticOptions& solve) {
  WatchedRun run;
  FractureHooks hooks;
  hooks.probe = [&](std::size_t, const State& state) { run.states.push_back(state); };
  run.found = fracture(model, options, solve, hooks);
  return run;
}

}  // namespace bondstatic::test
