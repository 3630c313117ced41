// Which states a run keeps on its way, and that they are its own.
#include "relax/saved_states.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "relax/relax_models.hpp"

namespace bondstatic::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<double> times(const std::vector<SavedState>& states) {
  std::vector<double> result;
  for (const SavedState& state : states) result.push_back(state.time);
  return result;
}

/// Of looks at 0, 1, 2 ...
SavedStates saved(double interval, Index looks) {
  SavedStates states(interval, 1);
  for (Index look = 0; look <= looks; ++look)
    if (states.wants(double(look))) states.add({look, double(look)});
  return states;
}

TEST(SavedStates, StandAtTheFirstLookAtOrAfterEachMultiple) {
  EXPECT_THAT(times(saved(3, 10).all()), ElementsAre(0, 3, 6, 9));
  EXPECT_THAT(times(saved(2.5, 10).all()), ElementsAre(0, 3, 5, 8, 10));
  EXPECT_THAT(times(saved(0.3, 3).all()), ElementsAre(0, 1, 2, 3)) << "no look stands between";
  EXPECT_THAT(times(saved(100, 10).all()), ElementsAre(0));
  EXPECT_THAT(saved(not_given, 10).all(), IsEmpty());
  // Steps times a time step may fall short of the multiple by rounding.
  SavedStates rounded(0.3, 0.1);
  EXPECT_TRUE(rounded.wants(0));
  rounded.add({0, 0});
  EXPECT_TRUE(rounded.wants(std::nextafter(0.3, 0)));
}

TEST(SavedStates, TheEndIsAmongThemUntilTheRunGoesOn) {
  SavedStates states = saved(3, 7);
  states.end_at({7, 7});
  EXPECT_THAT(times(states.all()), ElementsAre(0, 3, 6, 7));
  states.forget_end();
  EXPECT_THAT(times(states.all()), ElementsAre(0, 3, 6));
}

TEST(SavedStates, OfALongRunAreThoseOfALongerInterval) {
  for (const double interval : {1.0, 1.7, 0.25}) {
    SCOPED_TRACE(interval);
    SavedStates states(interval, 1);
    std::size_t written = 0;
    constexpr Index looks = 40000;
    for (Index look = 0; look <= looks; ++look) {
      if (!states.wants(double(look))) continue;
      states.add({look, double(look)});
      ++written;
      ASSERT_LE(states.all().size(), most_saved_states);
    }
    EXPECT_GE(states.all().size(), most_saved_states / 2);
    EXPECT_LT(written, 512 + 256 * 8);
    EXPECT_EQ(times(states.all()), times(saved(states.interval(), looks).all()));
    EXPECT_EQ(std::log2(states.interval() / std::max(interval, 1.0)),
              std::round(std::log2(states.interval() / std::max(interval, 1.0))));
  }
}

/// A state as it was shown.
struct Shown {
  State state;
  std::vector<Vector6> velocity;
  std::vector<SavedState> saved;
};

RelaxHooks showing(std::vector<Shown>& shown) {
  RelaxHooks hooks;
  hooks.show = [&shown](const State& state, const std::vector<Vector6>& velocity,
                        const std::vector<SavedState>& saved) {
    shown.push_back({state, velocity, saved});
  };
  return hooks;
}

bool same_shown(const Shown& a, const Shown& b) {
  return a.state.name == b.state.name && same_bytes(a.state.displacement, b.state.displacement) &&
         same_bytes(a.state.reaction, b.state.reaction) &&
         same_bytes(numbers(a.state.bonds), numbers(b.state.bonds)) && same_bytes(a.velocity, b.velocity) &&
         times(a.saved) == times(b.saved);
}

/// Two and a half times the distance between two looks.
RelaxOptions saving(const Model& model, Kinematics kinematics = Kinematics::finite) {
  RelaxOptions options;
  options.kinematics = kinematics;
  options.velocity_limit = 1e-5;
  RelaxOptions begin = options;
  begin.max_steps = 100'000;
  StaticOptions solve = one_thread();
  solve.unsupported = Unsupported::drop;
  options.save_interval = 2.5 * column(relax(model, begin, solve).cases.at(0), "time").at(1);
  return options;
}

/// Of the looks that the history tells of, the first one at or after each multiple of the interval, and the
/// last.
std::vector<double> expected_times(const RelaxedCase& found, double interval) {
  std::vector<double> expected;
  double due = 0;
  const std::vector<double>& looks = column(found, "time");
  for (const double time : looks) {
    if (time < due * (1 - 1e-12) && time != looks.back()) continue;
    expected.push_back(time);
    while (due <= time * (1 + 1e-12)) due += interval;
  }
  return expected;
}

Model two_cases() {
  Model model = loaded_packing(3, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
  model.load_cases = {"push", "pull"};
  load(model, Index(model.particles.size()) - 3, vector6(0, 0, -5e4), 1);
  return model;
}

class StatesOfARun : public ::testing::TestWithParam<Kinematics> {};

TEST_P(StatesOfARun, AreThoseOfARunThatIsAdvancedByHand) {
  const Model model = loaded_cantilever();
  const RelaxOptions options = saving(model, GetParam());
  std::vector<Shown> shown;
  const RelaxedCase found = relaxed(model, options, showing(shown));
  ASSERT_GT(shown.size(), 5u);
  ASSERT_EQ(times(found.saved), times(shown.back().saved));
  EXPECT_EQ(times(found.saved), expected_times(found, options.save_interval));

  const DynamicOptions dynamic{options.kinematics,
                               options.particle_damping,
                               options.bond_damping,
                               found.plan.time_step,
                               options.ramp,
                               found.plan.ramp_time,
                               1,
                               1};
  ExplicitRun run(model, bond_properties(model), 0, std::vector<bool>(model.particles.size()), dynamic);
  for (const Shown& one : shown) {
    const SavedState& at = one.saved.back();
    run.advance(at.step - run.step());
    EXPECT_EQ(run.time(), at.time);
    const State expected = run.state();
    EXPECT_TRUE(same_bytes(one.state.displacement, expected.displacement)) << at.step;
    EXPECT_TRUE(same_bytes(one.state.reaction, expected.reaction)) << at.step;
    EXPECT_TRUE(same_bytes(numbers(one.state.bonds), numbers(expected.bonds))) << at.step;
    for (std::size_t p = 0; p < one.velocity.size(); ++p)
      EXPECT_EQ(one.velocity[p], run.velocity(Index(p))) << at.step;
  }
  EXPECT_EQ(shown.front().saved.back().step, 0);
  EXPECT_EQ(shown.back().saved.back().step, found.steps);
  EXPECT_TRUE(same_bytes(shown.back().state.displacement, found.state.displacement));
}

TEST_P(StatesOfARun, DoNotChangeItsAnswer) {
  const Model model = loaded_cantilever();
  RelaxOptions options = saving(model, GetParam());
  std::vector<Shown> shown;
  const RelaxedCase with = relaxed(model, options, showing(shown)), unheard = relaxed(model, options);
  options.save_interval = not_given;
  std::vector<Shown> none;
  const RelaxedCase without = relaxed(model, options, showing(none));
  EXPECT_TRUE(same_bits(with, without));
  EXPECT_TRUE(same_bits(unheard, without));
  EXPECT_THAT(none, IsEmpty());
  EXPECT_THAT(without.saved, IsEmpty());
  EXPECT_THAT(unheard.saved, IsEmpty());
}

TEST_P(StatesOfARun, AreTheSameWhereverItWasStopped) {
  const Model model = two_cases();
  const RelaxOptions options = saving(model, GetParam());
  std::vector<Shown> all;
  RelaxHooks hooks = showing(all);
  Index looks = 0;
  hooks.progress = [&](const RelaxProgress&) { return ++looks > 0; };
  const Relaxation whole = relax(model, options, one_thread(), hooks);
  for (const Index stop : {Index(1), looks / 4, looks / 2, looks - 2}) {
    SCOPED_TRACE(stop);
    std::vector<Shown> shown;
    std::string kept;
    hooks = showing(shown);
    Index look = 0;
    hooks.progress = [&](const RelaxProgress&) { return ++look < stop; };
    hooks.keep = [&](const std::string& checkpoint) { kept = checkpoint; };
    hooks.keep_every = 1e9;
    relax(model, options, one_thread(), hooks);
    const std::size_t before = shown.size();
    hooks.progress = nullptr;
    hooks.resume = kept;
    std::vector<std::vector<SavedState>> resumed;
    hooks.resumed = [&](const std::vector<std::vector<SavedState>>& saved) { resumed = saved; };
    const Relaxation found = relax(model, options, one_thread(), hooks);
    ASSERT_FALSE(resumed.empty());
    EXPECT_EQ(times(resumed.back()), times(shown[before - 1].saved));
    ASSERT_EQ(shown.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_TRUE(same_shown(shown[i], all[i])) << i;
    for (std::size_t c = 0; c < 2; ++c)
      EXPECT_EQ(times(found.cases[c].saved), times(whole.cases[c].saved)) << c;
  }
}

INSTANTIATE_TEST_SUITE_P(SavedStates, StatesOfARun, ::testing::Values(Kinematics::small, Kinematics::finite));

TEST(SavedStates, OfARunAtItsLimitOfStepsHaveItsEndAndLoseItWhereItGoesOn) {
  const Model model = loaded_cantilever();
  RelaxOptions options = saving(model);
  const RelaxedCase whole = relaxed(model, options, [] {
    RelaxHooks hooks;
    hooks.show = [](const State&, const std::vector<Vector6>&, const std::vector<SavedState>&) {};
    return hooks;
  }());
  std::vector<Shown> shown;
  RelaxHooks hooks = showing(shown);
  std::string kept;
  hooks.keep = [&](const std::string& checkpoint) { kept = checkpoint; };
  options.max_steps = whole.steps / 2 + 1;
  const RelaxedCase part = relaxed(model, options, hooks);
  ASSERT_EQ(part.end, RunEnd::step_limit);
  EXPECT_EQ(part.saved.back().step, options.max_steps);
  ASSERT_GT(part.saved.size(), 2u);
  hooks.resume = kept;
  std::vector<std::vector<SavedState>> resumed;
  hooks.resumed = [&](const std::vector<std::vector<SavedState>>& saved) { resumed = saved; };
  EXPECT_EQ(times(relaxed(model, options, hooks).saved), times(part.saved)) << "with the same limit";
  EXPECT_EQ(times(resumed.at(0)), times(part.saved));
  options.max_steps = RelaxOptions{}.max_steps;
  EXPECT_EQ(times(relaxed(model, options, hooks).saved), times(whole.saved));
  EXPECT_EQ(resumed.at(0).back().step, part.saved[part.saved.size() - 2].step);
}

TEST(SavedStates, OfALongRunAreTheSameAfterAStop) {
  const Model model = loaded_cantilever(1);
  RelaxOptions options;
  options.particle_damping = 0;
  options.record_interval = options.save_interval = 1e-9;  // every step
  options.max_steps = 3000;
  std::vector<SavedState> last;
  RelaxHooks hooks;
  hooks.show = [&](const State&, const std::vector<Vector6>&, const std::vector<SavedState>& saved) {
    last = saved;
  };
  const RelaxedCase whole = relaxed(model, options, hooks);
  ASSERT_EQ(whole.saved.size(), 3000 / 8 + 1);
  for (const Index stop : {600, 2000, 2900}) {
    std::string kept;
    hooks.keep = [&](const std::string& checkpoint) { kept = checkpoint; };
    hooks.progress = [&](const RelaxProgress& progress) { return progress.step != stop; };
    hooks.resume = "";
    relaxed(model, options, hooks);
    hooks.resume = kept;
    EXPECT_EQ(times(relaxed(model, options, hooks).saved), times(whole.saved)) << stop;
    EXPECT_EQ(times(last), times(whole.saved)) << stop;
  }
}

TEST(SavedStates, MoreThanAreKeptAreWarnedOf) {
  const Model model = loaded_cantilever();
  RelaxOptions options = saving(model);
  std::vector<Shown> shown;
  const auto warnings = [&] { return relax(model, options, one_thread(), showing(shown)).warnings; };
  EXPECT_THAT(warnings(), IsEmpty());
  options.save_interval = 1e-9;
  EXPECT_THAT(warnings(), ElementsAre(HasSubstr("save_interval = 1e-09 asks for more states than are kept")));
}

TEST(SavedStates, HaveNoVelocityOfWhatWasLeftOut) {
  Model model = loaded_cantilever(2);
  add_particle(model, Vector3(50, 0, 0), 0.2);
  model.particles.back().density = 2000;
  StaticOptions drop = one_thread();
  drop.unsupported = Unsupported::drop;
  std::vector<Shown> shown;
  relax(model, saving(model), drop, showing(shown));
  ASSERT_GT(shown.size(), 1u);
  EXPECT_TRUE(shown[1].velocity.back().array().isNaN().all());
  EXPECT_GT(shown[1].velocity[2].norm(), 0);
}

}  // namespace
}  // namespace bondstatic::test
