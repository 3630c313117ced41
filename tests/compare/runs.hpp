// Runs made up from static answers: of the same model, of a model that is another one, still moving.
#pragma once

#include <random>

#include "bondstatic/compare.hpp"
#include "bondstatic/statics.hpp"
#include "support/models.hpp"

namespace bondstatic::test {

inline constexpr double kn = 1e6, ks = 4e5, kt = 2e4, kb = 3e4;

/// 64 particles of unequal radii, lowest layer held, pushed at the top.
inline Model packing(const Values& stiffness = {{"kn", kn}, {"ks", ks}, {"kt", kt}, {"kb", kb}},
                     ContactPoint contact_point = {ContactPoint::Kind::beam, 0}) {
  std::mt19937_64 random(3);
  Model model = random_packing(random, 4, block("generic", stiffness, contact_point));
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    const double z = model.particles[p].position.z();
    model.particles[p].density = 2500;
    if (z < 0.5) fix_all(model, Index(p));
    if (z > 2.5) load(model, Index(p), vector6(0.4, 0.1, -1, 0.02, 0, 0.05));
  }
  return model;
}

inline StaticOptions direct() {
  StaticOptions options;
  options.solver = "cholmod";
  options.threads = 1;
  return options;
}

inline State static_state(const Model& model) {
  return solve_statics(model, direct()).cases.front();
}

/// A run that ended in this state.
inline RunState ended_in(const State& state) {
  RunState run;
  run.name = "run";
  run.displacement = state.displacement;
  run.has_rotations = true;
  return run;
}

inline Comparison compared(const Model& model, const RunState& run, double tolerance = 1e-3) {
  return compare(model, static_state(model), 0, run, direct(), {tolerance, true});
}

}  // namespace bondstatic::test
