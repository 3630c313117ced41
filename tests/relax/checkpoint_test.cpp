// A run that is stopped and goes on ends with the bits of one that was not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "bondstatic/error.hpp"
#include "relax/relax_models.hpp"

namespace bondstatic::test {
namespace {

using testing::HasSubstr;

bool full_run() {
  const char* full = std::getenv("BONDSTATIC_FULL");
  return full != nullptr && std::string(full) == "1";
}

Model two_cases(int edge = 3) {
  Model model = loaded_packing(edge, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
  model.load_cases = {"push", "pull"};
  load(model, Index(model.particles.size()) - 3, vector6(0, 0, -5e4), 1);
  return model;
}

StaticOptions on_threads(int threads) {
  StaticOptions options = one_thread();
  options.threads = threads;
  return options;
}

/// Stops at its `looks`-th look; 0: not at all.
struct Stopping {
  Index looks = 0;
  std::string kept;
  int keeps = 0;
  RelaxHooks hooks;

  explicit Stopping(Index at, std::string resume = "") : looks(at) {
    hooks.progress = [this](const RelaxProgress&) { return --looks != 0; };
    hooks.keep = [this](const std::string& checkpoint) {
      kept = checkpoint;
      ++keeps;
    };
    hooks.resume = std::move(resume);
    hooks.probe = [](const State& state) { return Probes{{"tip", state.displacement.back()[0]}}; };
    hooks.keep_every = 1e9;
  }
};

void expect_same(const Relaxation& found, const Relaxation& expected) {
  ASSERT_EQ(found.cases.size(), expected.cases.size());
  for (std::size_t c = 0; c < found.cases.size(); ++c)
    EXPECT_TRUE(same_bits(found.cases[c], expected.cases[c])) << "load case " << c;
}

class Resumed : public ::testing::TestWithParam<Kinematics> {
 protected:
  RelaxOptions options() const {
    RelaxOptions result;
    result.kinematics = GetParam();
    result.bond_damping.paper = 0.01;
    result.velocity_limit = 1e-7;
    return result;
  }
};

TEST_P(Resumed, HasTheSameBitsWhereverItWasStopped) {
  const Model model = two_cases();
  Stopping never(0);
  const Relaxation expected = relax(model, options(), one_thread(), never.hooks);
  ASSERT_TRUE(expected.at_rest());
  EXPECT_EQ(never.keeps, 1) << "between the load cases, and not at its end";
  const Index looks = -never.looks;
  ASSERT_GT(looks, 20);
  std::vector<Index> stops{1, 2, 5, looks / 2, looks - 1};
  if (full_run())
    for (Index at = 3; at < looks; ++at) stops.push_back(at);
  for (const Index at : stops) {
    SCOPED_TRACE("stopped at look " + std::to_string(at));
    Stopping stopped(at);
    const Relaxation part = relax(model, options(), one_thread(), stopped.hooks);
    // Stopped at the very look that finds a case at rest, the next one has not begun.
    EXPECT_TRUE(part.cases.back().end == RunEnd::interrupted || part.cases.size() == 1);
    Stopping rest(0, stopped.kept);
    expect_same(relax(model, options(), one_thread(), rest.hooks), expected);
  }
}

TEST_P(Resumed, HasTheSameBitsAfterManyStopsOnChangingThreads) {
  const Model model = two_cases();
  Stopping never(0);
  const Relaxation expected = relax(model, options(), one_thread(), never.hooks);
  std::string kept;
  int stops = 0;
  for (;; ++stops) {
    ASSERT_LT(stops, 1000);
    Stopping next(7, kept);
    const Relaxation part = relax(model, options(), on_threads(1 + stops % 4), next.hooks);
    if (part.at_rest() && part.cases.size() == expected.cases.size()) {
      expect_same(part, expected);
      break;
    }
    kept = next.kept;
  }
  EXPECT_GT(stops, 2);
}

INSTANTIATE_TEST_SUITE_P(Checkpoint, Resumed, ::testing::Values(Kinematics::small, Kinematics::finite));

TEST(Checkpoint, OfALargePackingGoesOnAtOtherNumbersOfThreads) {
  Model model = loaded_packing(8, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
  RelaxOptions options;
  options.max_steps = 90;
  options.ramp_time = options.hold_time = 0.02;  // no factorisation needed to know them
  Stopping never(0);
  const Relaxation expected = relax(model, options, one_thread(), never.hooks);
  for (const int threads : {2, 3, 4}) {
    Stopping stopped(2);
    relax(model, options, on_threads(threads), stopped.hooks);
    Stopping rest(0, stopped.kept);
    expect_same(relax(model, options, on_threads(5 - threads), rest.hooks), expected);
  }
}

TEST(Checkpoint, IsKeptEverySoOftenAndSound) {
  const Model model = two_cases();
  Stopping run(0);
  run.hooks.keep_every = 0;
  std::vector<std::string> all;
  run.hooks.keep = [&all](const std::string& checkpoint) { all.push_back(checkpoint); };
  const Relaxation expected = relax(model, small_kinematics(), one_thread(), run.hooks);
  EXPECT_GE(Index(all.size()), -run.looks);  // at every look, and between the load cases
  for (std::size_t i = 0; i < all.size(); i += 17) {
    Stopping rest(0, all[i]);
    expect_same(relax(model, small_kinematics(), one_thread(), rest.hooks), expected);
  }
}

TEST(Checkpoint, AtTheStepLimitGoesOnWhereTheLimitIsRaised) {
  const Model model = two_cases();
  RelaxOptions options = small_kinematics();
  Stopping never(0);
  const Relaxation expected = relax(model, options, one_thread(), never.hooks);
  options.max_steps = 100;
  Stopping short_run(0);
  const Relaxation part = relax(model, options, one_thread(), short_run.hooks);
  ASSERT_EQ(part.cases.size(), 2u);
  for (const RelaxedCase& c : part.cases) {
    EXPECT_EQ(c.end, RunEnd::step_limit);
    EXPECT_EQ(c.steps, 100);
  }
  options.max_steps = 1'000'000;
  Stopping rest(0, short_run.kept);
  const Relaxation found = relax(model, options, one_thread(), rest.hooks);
  EXPECT_TRUE(found.at_rest());
  for (std::size_t c = 0; c < 2; ++c) {  // looks fall elsewhere, and so the last step may
    const double tip = expected.cases[c].state.displacement.back()[0];
    EXPECT_NEAR(found.cases[c].state.displacement.back()[0] / tip, 1, 1e-6);
    EXPECT_GT(found.cases[c].steps, 100);
  }
}

std::string refusal(const Model& model, const RelaxOptions& options, const std::string& checkpoint) {
  RelaxHooks hooks;
  hooks.resume = checkpoint;
  hooks.resume_name = "run.state";
  try {
    relax(model, options, one_thread(), hooks);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_THAT(error.what(), HasSubstr("run.state: "));
    EXPECT_THAT(error.what(), HasSubstr("cure"));
    return error.what();
  }
  return "none";
}

struct Sound {
  Model model = two_cases();
  RelaxOptions options = small_kinematics();
  std::string checkpoint;

  Sound() {
    Stopping stopped(3);
    relax(model, options, one_thread(), stopped.hooks);
    checkpoint = stopped.kept;
  }
};

TEST(Checkpoint, OfAnotherModelIsRefused) {
  const Sound sound;
  EXPECT_EQ(refusal(sound.model, sound.options, sound.checkpoint), "none");
  const std::pair<const char*, std::function<void(Model&)>> changes[] = {
      {"position", [](Model& m) { m.particles[3].position[0] += 1e-12; }},
      {"radius", [](Model& m) { m.particles[3].radius *= 1 + 1e-12; }},
      {"density", [](Model& m) { m.particles[3].density += 1; }},
      {"law",
       [](Model& m) {
         m.blocks[0] = block("timoshenko", {{"young", 5e9}, {"poisson", 0.21}});
       }},
      {"bonds", [](Model& m) { m.bonds.pop_back(); }},
      {"loads", [](Model& m) { m.loads[0].force[1] += 1; }},
      {"supports", [](Model& m) { m.supports.back().value[0] *= 2; }},
      {"load cases", [](Model& m) { m.load_cases[1] = "drag"; }},
      {"contact point", [](Model& m) {
         m.blocks[0].contact_point = {ContactPoint::Kind::fraction, 0.4};
       }}};
  for (const auto& [what, change] : changes) {
    Model other = sound.model;
    change(other);
    EXPECT_THAT(refusal(other, sound.options, sound.checkpoint), HasSubstr("another model")) << what;
  }
}

TEST(Checkpoint, OfAContactPointThatStretchMovesOtherwiseIsRefused) {
  // Where the gap's centre lies at first, at 0.375 of the branch, a fraction stays and the centre of the gap
  // does not.
  const auto pair = [](ContactPoint point) {
    Model model;
    model.blocks.push_back(block("parallel", {{"young", 1e7}, {"poisson", 0.2}, {"radius", 0.2}}, point));
    add_particle(model, Vector3::Zero(), 0.25);
    add_particle(model, Vector3(1, 0, 0), 0.5);
    for (Particle& particle : model.particles) particle.density = 2000;
    add_bond(model, 0, 1);
    fix_all(model, 0);
    load(model, 1, vector6(0, -10, 0));
    return model;
  };
  Stopping first(3);
  relax(pair({ContactPoint::Kind::gap}), {}, one_thread(), first.hooks);
  ASSERT_FALSE(first.kept.empty());
  RelaxHooks hooks = first.hooks;
  hooks.progress = nullptr;
  hooks.resume = first.kept;
  EXPECT_TRUE(relax(pair({ContactPoint::Kind::gap}), {}, one_thread(), hooks).at_rest());
  EXPECT_THROW(relax(pair({ContactPoint::Kind::fraction, 0.375}), {}, one_thread(), hooks), Error);
}

TEST(Relaxation, StoppedWhenItsFirstLoadCaseCameToRestIsNotAtRest) {
  const Relaxation whole = relax(two_cases(), small_kinematics(), one_thread());
  ASSERT_TRUE(whole.at_rest());
  ASSERT_FALSE(whole.interrupted);
  const Index end = whole.cases[0].steps;
  RelaxHooks hooks;
  hooks.progress = [&](const RelaxProgress& progress) { return progress.step < end; };
  const Relaxation part = relax(two_cases(), small_kinematics(), one_thread(), hooks);
  ASSERT_EQ(part.cases.size(), 1u);
  EXPECT_EQ(part.cases[0].end, RunEnd::at_rest);
  EXPECT_TRUE(part.interrupted);
  EXPECT_FALSE(part.at_rest());
}

TEST(Checkpoint, OfOtherOptionsIsRefusedAndOfMoreStepsIsNot) {
  const Sound sound;
  const std::pair<const char*, std::function<void(RelaxOptions&)>> changes[] = {
      {"kinematics", [](RelaxOptions& o) { o.kinematics = Kinematics::finite; }},
      {"particle_damping", [](RelaxOptions& o) { o.particle_damping = 0.6; }},
      {"bond_damping", [](RelaxOptions& o) { o.bond_damping.shear = 0.1; }},
      {"safety", [](RelaxOptions& o) { o.safety = 0.7; }},
      {"time_step", [](RelaxOptions& o) { o.time_step = 1e-6; }},
      {"ramp", [](RelaxOptions& o) { o.ramp = Ramp::smooth; }},
      {"ramp_time", [](RelaxOptions& o) { o.ramp_time = 1; }},
      {"hold_time", [](RelaxOptions& o) { o.hold_time = 1; }},
      {"velocity_limit", [](RelaxOptions& o) { o.velocity_limit = 1e-8; }},
      {"force_limit", [](RelaxOptions& o) { o.force_limit = 1e-7; }},
      {"record_interval", [](RelaxOptions& o) { o.record_interval = 1e-3; }},
      {"save_interval", [](RelaxOptions& o) { o.save_interval = 1e-3; }},
      {"load_factor", [](RelaxOptions& o) { o.load_factor = 0.5; }}};
  for (const auto& [what, change] : changes) {
    RelaxOptions other = sound.options;
    change(other);
    EXPECT_THAT(refusal(sound.model, other, sound.checkpoint), HasSubstr("other options")) << what;
  }
  RelaxOptions more = sound.options;
  more.max_steps *= 2;
  more.check_tolerance = 1e-3;
  EXPECT_EQ(refusal(sound.model, more, sound.checkpoint), "none");
}

TEST(Checkpoint, ThatIsDamagedIsRefused) {
  const Sound sound;
  const std::string& good = sound.checkpoint;
  for (const std::size_t size : {std::size_t(5), std::size_t(30), good.size() / 2, good.size() - 1})
    EXPECT_NE(refusal(sound.model, sound.options, good.substr(0, size)), "none") << size;
  EXPECT_THAT(refusal(sound.model, sound.options, good.substr(0, good.size() - 1)), HasSubstr("damaged"));
  EXPECT_THAT(refusal(sound.model, sound.options, good + "x"), HasSubstr("damaged"));
  EXPECT_THAT(refusal(sound.model, sound.options, "something else"), HasSubstr("is no checkpoint"));
  for (std::size_t at = 0; at < good.size(); at += 997) {
    std::string flipped = good;
    flipped[at] = char(flipped[at] ^ 0x01);
    EXPECT_NE(refusal(sound.model, sound.options, flipped), "none") << at;
  }
}

TEST(Progress, TellsOfTheLoadCaseAndTheTimeLeft) {
  std::vector<RelaxProgress> heard;
  std::vector<bool> phases;
  RelaxHooks hooks;
  hooks.progress = [&heard](const RelaxProgress& progress) {
    heard.push_back(progress);
    return true;
  };
  hooks.phase = [&phases](bool planning) { phases.push_back(planning); };
  const Relaxation found = relax(two_cases(), small_kinematics(), one_thread(), hooks);
  EXPECT_EQ(phases, (std::vector<bool>{true, false, true, false}));
  EXPECT_EQ(heard.front().load_case, "push");
  EXPECT_EQ(heard.back().load_case, "pull");
  EXPECT_EQ(heard.back().step, found.cases[1].steps);
  EXPECT_EQ(heard.back().time, found.cases[1].time);
  EXPECT_EQ(heard.back().unrest.fastest, found.cases[1].unrest.fastest);
  for (const RelaxProgress& progress : heard) EXPECT_GE(progress.seconds_left, 0);
  EXPECT_GT(heard.front().seconds_left, 0);
  EXPECT_EQ(heard.back().seconds_left, 0);
}

}  // namespace
}  // namespace bondstatic::test
