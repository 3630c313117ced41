#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bondstatic/error.hpp"
#include "bondstatic/fracture.hpp"
#include "support/strengths.hpp"

namespace bondstatic::test {
namespace {

StaticOptions on_threads(int threads, const std::string& solver = "auto") {
  StaticOptions options;
  options.solver = solver;
  options.threads = threads;
  options.yield_cores = false;
  return options;
}

/// A cube between a held floor and a roof that is pulled up and sheared; strengths scatter.
Model torn_cube(int edge, bool by_forces = false) {
  std::mt19937_64 random(11);
  Model model =
      random_packing(random, edge, block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.2}}));
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    const double z = model.particles[p].position.z();
    if (z < 0.5) fix_all(model, Index(p));
    if (z < double(edge) - 1.5) continue;
    if (by_forces)
      load(model, Index(p), vector6(0.3, 0, 1));
    else
      fix_all(model, Index(p), vector6(0.3, 0, 1));
  }
  model.blocks[0].strength =
      strength("edem-v2", {{"critical_normal_stress", 1e6}, {"critical_shear_stress", 2e6}});
  model.blocks[0].strength->scatter = BondStrength::Scatter::weibull;
  model.blocks[0].strength->spread = {5, 5};
  return model;
}

FractureOptions breaks(Index most, FractureControl control = FractureControl::event) {
  FractureOptions options;
  options.control = control;
  options.max_breaks = most;
  return options;
}

/// The model without the bonds that `fracture` had broken before `event`, its pattern scaled.
Model broken(Model model, const Fracture& fracture, std::size_t event) {
  std::vector<Bond> left;
  for (std::size_t k = 0; k < model.bonds.size(); ++k)
    if (fracture.break_event[k] < 0 || fracture.break_event[k] >= Index(event))
      left.push_back(model.bonds[k]);
  model.bonds = std::move(left);
  const double factor = fracture.events[event].factor;
  for (Support& support : model.supports) support.value *= factor;
  for (Load& load : model.loads) load.force *= factor;
  return model;
}

double largest(const std::vector<Vector6>& vectors) {
  double most = 0;
  for (const Vector6& v : vectors)
    if (!std::isnan(v[0])) most = std::max(most, v.cwiseAbs().maxCoeff());
  return most;
}

void expect_same_displacement(const State& found, const State& expected, double tolerance) {
  const double size = largest(expected.displacement);
  for (std::size_t p = 0; p < expected.displacement.size(); ++p) {
    ASSERT_EQ(std::isnan(found.displacement[p][0]), std::isnan(expected.displacement[p][0])) << p;
    if (std::isnan(expected.displacement[p][0])) continue;
    ASSERT_LT((found.displacement[p] - expected.displacement[p]).cwiseAbs().maxCoeff(), tolerance * size)
        << "particle " << p;
  }
}

class EveryState : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryState, EqualsAPlainSolveOfTheBrokenModel) {
  const Model model = torn_cube(5);
  std::vector<State> states;
  FractureHooks hooks;
  hooks.probe = [&](std::size_t, const State& state) { states.push_back(state); };
  const Fracture found = fracture(model, {}, on_threads(1, GetParam()), hooks);
  ASSERT_EQ(found.end, FractureEnd::separated);
  ASSERT_GT(found.events.size(), 50u);
  ASSERT_EQ(states.size(), found.events.size());
  StaticOptions plain = on_threads(1);
  plain.unsupported = Unsupported::drop;
  for (std::size_t event = 0; event < states.size(); event += GetParam() == "auto" ? 1 : 10) {
    const StaticSolution fresh = solve_statics(broken(model, found, event), plain);
    expect_same_displacement(states[event], fresh.cases[0], 1e-13);
    const FractureEvent& e = found.events[event];
    EXPECT_NEAR(e.load * e.displacement / (2 * fresh.cases[0].energy), 1, 1e-12) << event;
  }
  EXPECT_LT(found.report.energy_balance, 1e-12);
  EXPECT_LT(found.report.backward_error, 1e-15);
  // Iterative solvers are set up anew after every break.
  EXPECT_LE(found.report.factorisations, GetParam() == "multigrid" ? int(found.events.size()) + 1 : 40);
}

INSTANTIATE_TEST_SUITE_P(Solvers, EveryState, ::testing::Values("auto", "eigen", "multigrid"),
                         [](const auto& chosen) { return chosen.param; });

void expect_same_history(const Fracture& found, const Fracture& expected) {
  ASSERT_EQ(found.events.size(), expected.events.size());
  for (std::size_t e = 0; e < expected.events.size(); ++e) {
    const FractureEvent &l = found.events[e], &r = expected.events[e];
    ASSERT_EQ(l.factor, r.factor) << e;
    ASSERT_EQ(l.load, r.load) << e;
    ASSERT_EQ(l.displacement, r.displacement) << e;
    ASSERT_EQ(l.load_after, r.load_after) << e;
    ASSERT_EQ(l.runner_up, r.runner_up) << e;
    ASSERT_EQ(l.released, r.released) << e;
    ASSERT_EQ(l.work, r.work) << e;
    ASSERT_EQ(l.avalanche, r.avalanche) << e;
    ASSERT_EQ(l.bonds.size(), r.bonds.size()) << e;
    for (std::size_t i = 0; i < r.bonds.size(); ++i) {
      ASSERT_EQ(l.bonds[i].bond, r.bonds[i].bond) << e;
      ASSERT_EQ(l.bonds[i].mode, r.bonds[i].mode) << e;
      ASSERT_EQ(l.bonds[i].utilisation, r.bonds[i].utilisation) << e;
    }
  }
  EXPECT_EQ(found.break_event, expected.break_event);
  EXPECT_EQ(found.end, expected.end);
  ASSERT_EQ(found.last.displacement.size(), expected.last.displacement.size());
  for (std::size_t p = 0; p < expected.last.displacement.size(); ++p)
    ASSERT_TRUE((found.last.displacement[p].array() == expected.last.displacement[p].array()).all() ||
                std::isnan(expected.last.displacement[p][0]));
}

TEST(FractureRun, IsTheSameOnAnyNumberOfThreads) {
  const Model model = torn_cube(6);
  const Fracture one = fracture(model, breaks(60), on_threads(1));
  expect_same_history(fracture(model, breaks(60), on_threads(4)), one);
}

TEST(FractureRun, GoesOnFromACheckpointBitForBit) {
  const Model model = torn_cube(5);
  for (const FractureControl control : {FractureControl::event, FractureControl::displacement}) {
    const FractureOptions options = breaks(150, control);
    const Fracture whole = fracture(model, options, on_threads(1));
    for (const Index stop : {1, 17, 40}) {
      std::string kept;
      FractureHooks hooks;
      hooks.keep = [&](const std::string& content) { kept = content; };
      hooks.progress = [&](const FractureProgress& progress) { return progress.events < stop; };
      EXPECT_EQ(fracture(model, options, on_threads(1), hooks).end, FractureEnd::interrupted);
      FractureHooks again;
      again.resume = kept;
      expect_same_history(fracture(model, options, on_threads(1), again), whole);
    }
  }
}

TEST(FractureRun, RefusesACheckpointOfAnotherModel) {
  std::string kept;
  FractureHooks hooks;
  hooks.keep = [&](const std::string& content) { kept = content; };
  hooks.progress = [](const FractureProgress&) { return false; };
  fracture(torn_cube(4), breaks(9), on_threads(1), hooks);
  FractureHooks again;
  again.resume = kept;
  again.resume_name = "DIR/fracture.checkpoint";
  Model other = torn_cube(4);
  other.blocks[0].strength->parameters[0] *= 1.5;
  try {
    fracture(other, breaks(9), on_threads(1), again);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_NE(std::string(error.what()).find("DIR/fracture.checkpoint"), std::string::npos);
  }
}

/// Particles in another order, their ids and bonds kept.
Model renumbered(const Model& model) {
  std::vector<Index> order(model.particles.size());
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(5);
  std::shuffle(order.begin(), order.end(), random);
  Model other = model;
  std::vector<Index> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    other.particles[i] = model.particles[std::size_t(order[i])];
    place[std::size_t(order[i])] = Index(i);
  }
  for (Bond& bond : other.bonds) {
    bond.a = place[std::size_t(bond.a)];
    bond.b = place[std::size_t(bond.b)];
  }
  for (Support& support : other.supports) support.particle = place[std::size_t(support.particle)];
  for (Load& load : other.loads) load.particle = place[std::size_t(load.particle)];
  return other;
}

TEST(FractureRun, IsTheSameUnderRenumberingOfParticles) {
  const Model model = torn_cube(5);
  const Fracture one = fracture(model, breaks(100), on_threads(1));
  const Fracture other = fracture(renumbered(model), breaks(100), on_threads(1));
  EXPECT_EQ(other.break_event, one.break_event);
  for (std::size_t e = 0; e < one.events.size(); ++e)
    ASSERT_NEAR(other.events[e].load / one.events[e].load, 1, 1e-13) << e;
}

/// Rayleigh: taking something away makes nothing stiffer.
TEST(FractureRun, ComplianceNeverFallsAndEnergyNeverRises) {
  for (const bool by_forces : {false, true}) {
    FractureOptions options = breaks(150);
    const Fracture events = fracture(torn_cube(5, by_forces), options, on_threads(1));
    double compliance = 0;
    for (const FractureEvent& e : events.events) {
      ASSERT_GE(e.displacement / e.load, compliance * (1 - 1e-14));
      compliance = e.displacement / e.load;
      if (!(e.load_after > 1e-9 * e.load)) continue;  // separated
      ASSERT_GE(e.displacement_after / e.load_after, compliance * (1 - 1e-14));
      ASSERT_GE(e.released, 0);
    }
    options.control = FractureControl::displacement;
    const Fracture steady = fracture(torn_cube(5, by_forces), options, on_threads(1));
    double displacement = 0;
    for (const FractureEvent& e : steady.events) {
      ASSERT_GE(e.displacement, displacement * (1 - 1e-14));
      displacement = e.displacement;
      if (std::isnan(e.load_after)) continue;
      ASSERT_NEAR(e.displacement_after / displacement, 1, 1e-14);
      ASSERT_LE(e.strain_energy, 0.5 * e.load * e.displacement * (1 + 1e-13));
    }
    EXPECT_LT(steady.report.energy_balance, 1e-12);
  }
}

TEST(FractureRun, NamesWhatSeparatesAndGoesOn) {
  // Three particles stand on the middle of a bar that is pulled, on two weak bonds like a tent's.
  Model model = chain(block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.2}}),
                      Vector3::Zero(), Vector3(10, 0, 0), 10, 0.5);
  model.blocks.push_back(model.blocks[0]);
  for (int i = 1; i <= 3; ++i) add_particle(model, Vector3(5.5, double(i), 0), 0.5);
  add_bond(model, 5, 11, 1);
  add_bond(model, 11, 12, 0);
  add_bond(model, 12, 13, 0);
  add_bond(model, 6, 11, 1);
  model.blocks[0].strength =
      strength("edem-v2", {{"critical_normal_stress", 1e6}, {"critical_shear_stress", 1e6}});
  model.blocks[1].strength =
      strength("edem-v2", {{"critical_normal_stress", 1e2}, {"critical_shear_stress", 1e2}});
  load(model, 10, vector6(1, 0, 0));
  const Fracture found = fracture(model, breaks(2), on_threads(1));
  EXPECT_EQ(found.end, FractureEnd::breaks);
  ASSERT_EQ(found.separated.size(), 1u);
  EXPECT_EQ(found.separated[0].particles, (std::vector<Index>{12, 13, 14}));
  EXPECT_EQ(found.separated[0].event, 0u);
  ASSERT_EQ(found.events.size(), 1u);
  EXPECT_EQ(found.events[0].bonds.size(), 2u);
  EXPECT_TRUE(std::isnan(found.last.displacement[12][0]));
  EXPECT_FALSE(std::isnan(found.last.displacement[10][0]));
}

TEST(FractureRun, EndsWhereItIsAskedTo) {
  const Model model = torn_cube(4);
  const Fracture all = fracture(model, breaks(30), on_threads(1));
  FractureOptions options;
  options.max_factor = all.events[10].factor * 0.999;
  for (std::size_t e = 0; e < 10; ++e) ASSERT_NE(all.events[e].factor, all.events[10].factor);
  const Fracture by_factor = fracture(model, options, on_threads(1));
  EXPECT_EQ(by_factor.end, FractureEnd::factor);
  EXPECT_NEAR(largest(by_factor.last.displacement) / options.max_factor, 1, 1e-15);
  options = {};
  options.control = FractureControl::displacement;
  options.max_displacement = 0.5 * (all.events[3].displacement + all.events[4].displacement);
  const Fracture by_displacement = fracture(model, options, on_threads(1));
  ASSERT_EQ(by_displacement.end, FractureEnd::displacement);
  for (const FractureEvent& e : by_displacement.events) EXPECT_LE(e.displacement, options.max_displacement);
  options = {};
  options.load_drop = 0.3;
  const Fracture by_drop = fracture(model, options, on_threads(1));
  ASSERT_EQ(by_drop.end, FractureEnd::load_drop);
  double peak = 0;
  for (const FractureEvent& e : by_drop.events) {
    peak = std::max(peak, e.load);
    EXPECT_GT(e.load, 0.7 * peak);
  }
}

TEST(FractureRun, NamesItsStatesAfterThePattern) {
  Model model = torn_cube(4, true);
  model.load_cases = {"other", "pull"};
  for (Load& load : model.loads) load.load_case = 1;
  FractureOptions options = breaks(2);
  options.pattern = 1;
  FractureHooks hooks;
  int shown = 0;
  hooks.show = [&](std::size_t, const State& state, const std::vector<Index>&) {
    EXPECT_EQ(state.name, "pull");
    ++shown;
  };
  EXPECT_EQ(fracture(model, options, on_threads(1), hooks).last.name, "pull");
  EXPECT_EQ(shown, 2);
}

TEST(FractureRun, RefusesWhatItCannotRun) {
  const auto message = [](const Model& model, const FractureOptions& options = {}) {
    try {
      fracture(model, options, on_threads(1));
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::invalid_input);
      return std::string(error.what());
    }
    return std::string("none");
  };
  Model unbreakable = torn_cube(4);
  unbreakable.blocks[0].strength.reset();
  EXPECT_NE(message(unbreakable).find("no bond has a strength"), std::string::npos);
  Model idle = torn_cube(4);
  for (Support& support : idle.supports) support.value.setZero();
  EXPECT_NE(message(idle).find("has no load, prescribed motion or strain"), std::string::npos);
  Model both = torn_cube(4);
  load(both, 40, vector6(1, 0, 0));
  EXPECT_NE(message(both).find("more than one"), std::string::npos);
  Model two = torn_cube(4);
  two.load_cases = {"one", "two"};
  two.supports.back().load_case = 0;
  FractureOptions options;
  options.pattern = 1;
  options.preload = 0;
  EXPECT_NE(message(two, options).find("different degrees of freedom of particle"), std::string::npos);
}

}  // namespace
}  // namespace bondstatic::test
