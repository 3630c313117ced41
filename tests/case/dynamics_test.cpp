// [dynamics] and [check], and the densities that a run through time needs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "case/same_model.hpp"
#include "case/sound_case.hpp"

namespace bondstatic::test {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The sound case with masses and, behind it, these lines.
std::string heavy_case(const std::string& lines = "") {
  return sound_case({{3, "radius = 0.2\ndensity = 7850"}, {19, lines}});
}

Case read_for_dynamics(const std::string& text, const std::vector<std::string>& overrides = {},
                       const Files& files = {}) {
  const ScratchFolder folder;
  for (const auto& [name, content] : files) folder.write(name, content);
  return read_case(folder.write("case.toml", text), overrides, "", Purpose::dynamics);
}

std::vector<Fault> faults_for_dynamics(const std::string& text, const Files& files = {}) {
  try {
    read_for_dynamics(text, {}, files);
  } catch (const InputError& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults)
      fault.place.file = std::filesystem::path(fault.place.file).filename().string();
    return faults;
  }
  return {};
}

RelaxOptions relax_of(const std::string& lines) {
  return read_for_dynamics(heavy_case("[dynamics]\n" + lines)).relax;
}

void expect_same_options(const RelaxOptions& left, const RelaxOptions& right) {
  EXPECT_EQ(left.kinematics, right.kinematics);
  EXPECT_EQ(left.ramp, right.ramp);
  EXPECT_EQ(left.max_steps, right.max_steps);
  const auto numbers = [](const RelaxOptions& o) {
    const BondDamping& b = o.bond_damping;
    return std::vector<double>{o.particle_damping, b.paper,          b.normal,         b.shear,
                               b.twisting,         b.bending,        o.time_step,      o.safety,
                               o.ramp_time,        o.velocity_limit, o.force_limit,    o.hold_time,
                               o.record_interval,  o.save_interval,  o.check_tolerance};
  };
  EXPECT_TRUE(same_vector(numbers(left), numbers(right)));
}

/// Every key away from its default.
const char* const all_keys = R"([dynamics]
kinematics = "small"
particle_damping = 0.25
bond_damping = { normal = 0.1, shear = 0.2, twisting = 0.3, bending = 1.5 }
time_step = 1e-6
ramp_time = 0.5
ramp = "smooth"
velocity_limit = 1e-7
force_limit = 1e-5
hold_time = 0.25
max_steps = 2000
record_interval = 0.01
save_interval = 0.125
[check]
tolerance = 1e-4)";

TEST(Dynamics, ReadsEveryKey) {
  const RelaxOptions o = read_for_dynamics(heavy_case(all_keys)).relax;
  EXPECT_EQ(o.kinematics, Kinematics::small);
  EXPECT_EQ(o.particle_damping, 0.25);
  EXPECT_EQ(o.bond_damping.paper, 0);
  EXPECT_EQ(o.bond_damping.normal, 0.1);
  EXPECT_EQ(o.bond_damping.shear, 0.2);
  EXPECT_EQ(o.bond_damping.twisting, 0.3);
  EXPECT_EQ(o.bond_damping.bending, 1.5);
  EXPECT_EQ(o.time_step, 1e-6);
  EXPECT_EQ(o.ramp_time, 0.5);
  EXPECT_EQ(o.ramp, Ramp::smooth);
  EXPECT_EQ(o.velocity_limit, 1e-7);
  EXPECT_EQ(o.force_limit, 1e-5);
  EXPECT_EQ(o.hold_time, 0.25);
  EXPECT_EQ(o.max_steps, 2000);
  EXPECT_EQ(o.record_interval, 0.01);
  EXPECT_EQ(o.save_interval, 0.125);
  EXPECT_EQ(o.check_tolerance, 1e-4);
}

TEST(Dynamics, DefaultsAreThoseOfTheOptions) {
  expect_same_options(read_for_dynamics(heavy_case()).relax, RelaxOptions{});
  expect_same_options(relax_of(""), RelaxOptions{});
  expect_same_options(relax_of("bond_damping = {}\n[check]"), RelaxOptions{});
}

TEST(Dynamics, UnitsMakeTheSameOptionsInSi) {
  const Case plain = read_for_dynamics(
      heavy_case("[dynamics]\ntime_step = 2e-6\nramp_time = 120\nhold_time = 0.005\nrecord_interval = 1800\n"
                 "save_interval = 60\nvelocity_limit = 1e-8\nparticle_damping = 0.25"));
  const Case units = read_for_dynamics(
      heavy_case("[dynamics]\ntime_step = \"2 us\"\nramp_time = \"2 min\"\nhold_time = \"5 ms\"\n"
                 "record_interval = \"0.5 h\"\nsave_interval = \"1 min\"\nvelocity_limit = \"10 "
                 "nm/s\"\nparticle_damping = \"25 %\""));
  expect_same_options(plain.relax, units.relax);
  EXPECT_FALSE(plain.si);
  EXPECT_TRUE(units.si);
}

TEST(Dynamics, BondDampingIsTheNumberOfThePaperOrItsParts) {
  const BondDamping paper = relax_of("bond_damping = 0.1").bond_damping;
  EXPECT_EQ(paper.paper, 0.1);
  EXPECT_EQ(paper.normal + paper.shear + paper.twisting + paper.bending, 0);
  const BondDamping shear = relax_of("bond_damping = { shear = 0.3 }").bond_damping;
  EXPECT_EQ(shear.shear, 0.3);
  EXPECT_EQ(shear.paper + shear.normal + shear.twisting + shear.bending, 0);
  EXPECT_FALSE(relax_of("bond_damping = 0").bond_damping.any());
}

TEST(Dynamics, BoundsThemselvesAreAllowed) {
  EXPECT_EQ(relax_of("particle_damping = 0").particle_damping, 0);
  EXPECT_EQ(relax_of("ramp_time = 0").ramp_time, 0);
  EXPECT_EQ(relax_of("safety = 2").safety, 2);
  EXPECT_EQ(relax_of("max_steps = 1").max_steps, 1);
  EXPECT_EQ(relax_of("max_steps = 1e6").max_steps, 1'000'000);
}

TEST(Dynamics, SafetyAboveOneIsAWarningWhereItIsRun) {
  const std::string risky = heavy_case("[dynamics]\nsafety = 1.5");
  const Case c = read_for_dynamics(risky);
  EXPECT_EQ(c.relax.safety, 1.5);
  ASSERT_EQ(c.warnings.size(), 1u);
  EXPECT_THAT(c.warnings[0], HasSubstr("case.toml:21:10: safety = 1.5"));
  EXPECT_THAT(read_for_dynamics(heavy_case(), {"dynamics.safety=1.5"}).warnings,
              ElementsAre(HasSubstr("--set dynamics.safety=1.5: safety = 1.5")));
  EXPECT_THAT(read_for_dynamics(heavy_case("[dynamics]\nsafety = 1")).warnings, IsEmpty());
  EXPECT_THAT(read_case_text(risky).warnings, IsEmpty());
}

TEST(Dynamics, SettingsReachIt) {
  const Case c = read_for_dynamics(heavy_case(), {"dynamics.kinematics=small", "check.tolerance=1e-3",
                                                  "dynamics.bond_damping.bending=0.2"});
  EXPECT_EQ(c.relax.kinematics, Kinematics::small);
  EXPECT_EQ(c.relax.check_tolerance, 1e-3);
  EXPECT_EQ(c.relax.bond_damping.bending, 0.2);
}

TEST(Dynamics, SolveReadsItToo) {
  const Case c = read_case_text(sound_case({{19, all_keys}}));
  EXPECT_THAT(c.warnings, IsEmpty());
  EXPECT_EQ(c.relax.max_steps, 2000);
  EXPECT_EQ(c.relax.check_tolerance, 1e-4);
}

TEST(Dynamics, KnowsNoPeriodicCell) {
  try {
    read_for_dynamics(heavy_case("[cell]\nsize = [100, 100, 100]"));
    ADD_FAILURE();
  } catch (const InputError& error) {
    ASSERT_FALSE(error.faults().empty());
    EXPECT_THAT(error.faults()[0].message, HasSubstr("knows no periodic cell"));
  }
}

TEST(ResolvedDynamics, ReadsAsTheSameOptionsBitForBit) {
  for (const std::string lines :
       {"", "[dynamics]\nsafety = 0.1\nbond_damping = 0.3", "[dynamics]\nramp_time = \"0.3 ms\"\n[check]",
        "[dynamics]\nbond_damping = { shear = \"7 %\" }\ntime_step = \"0.7 us\"", all_keys}) {
    const Case first = read_for_dynamics(heavy_case(lines));
    const Case again = read_for_dynamics(first.resolved);
    expect_same_options(first.relax, again.relax);
    expect_same(first.model, again.model);
    EXPECT_EQ(first.resolved, again.resolved);
  }
}

TEST(ResolvedDynamics, HasDefaultsButNotWhatTheRunWorksOut) {
  const std::string resolved = read_for_dynamics(heavy_case()).resolved;
  for (const char* line :
       {"[dynamics]\n", "kinematics = \"finite\"\n", "particle_damping = 0.7\n", "bond_damping = 0.0\n",
        "safety = 0.8\n", "ramp = \"linear\"\n", "velocity_limit = 1e-09\n", "force_limit = 1e-08\n",
        "max_steps = 1000000000\n", "[check]\ntolerance = 1e-06\n"})
    EXPECT_THAT(resolved, HasSubstr(line));
  for (const char* key : {"time_step", "ramp_time", "hold_time", "record_interval", "save_interval"})
    EXPECT_THAT(resolved, Not(HasSubstr(key)));
  const std::string given =
      read_for_dynamics(heavy_case("[dynamics]\ntime_step = 1e-6\nbond_damping = { normal = 1 }")).resolved;
  EXPECT_THAT(given, Not(HasSubstr("safety")));
  EXPECT_THAT(given, HasSubstr("{ normal = 1, shear = 0.0, twisting = 0.0, bending = 0.0 }"));
}

TEST(ResolvedDynamics, IsNotMadeForSolve) {
  const std::string resolved = read_case_text(sound_case()).resolved;
  EXPECT_THAT(resolved, Not(HasSubstr("[dynamics]")));
  EXPECT_THAT(resolved, Not(HasSubstr("[check]")));
}

struct Slip {
  std::string name;
  std::string lines;  ///< from line 20 of the case on
  int line;
  int column;
  std::string message;  ///< part of it
  std::string cure;     ///< part of it
};

void PrintTo(const Slip& slip, std::ostream* out) {
  *out << slip.name;
}

void expect_one_fault(const std::vector<Fault>& faults, const Slip& slip) {
  ASSERT_EQ(faults.size(), 1u) << (faults.empty() ? "read without a fault" : InputError(faults).what());
  EXPECT_EQ(faults[0].place.file, "case.toml");
  EXPECT_EQ(faults[0].place.line, slip.line);
  EXPECT_EQ(faults[0].place.column, slip.column);
  EXPECT_THAT(faults[0].message, HasSubstr(slip.message));
  EXPECT_THAT(faults[0].cure, HasSubstr(slip.cure));
  EXPECT_FALSE(faults[0].cure.empty());
}

class BadDynamics : public testing::TestWithParam<Slip> {};

TEST_P(BadDynamics, IsOneFaultWithPlaceAndCure) {
  expect_one_fault(faults_for_dynamics(heavy_case(GetParam().lines)), GetParam());
}

TEST_P(BadDynamics, IsTheSameFaultForSolve) {
  expect_one_fault(faults_of(heavy_case(GetParam().lines)), GetParam());
}

/// One key of [dynamics], which then stands in line 21.
Slip key(const std::string& name, const std::string& line, int column, const std::string& message,
         const std::string& cure) {
  return {name, "[dynamics]\n" + line, 21, column, message, cure};
}

const std::vector<Slip> slips{
    {"TableIsList", "[[dynamics]]", 20, 1, "[dynamics] = a list of 1 must be a table", "{"},
    {"TableNameNear", "[dynamic]", 20, 2, "unknown key \"dynamic\"", "\"dynamics\""},
    key("KeyUnknown", "particle_dampin = 0.7", 1, "unknown key \"particle_dampin\" in [dynamics]",
        "\"particle_damping\""),
    key("KeyFarOff", "zzzzzzzz = 1", 1, "unknown key \"zzzzzzzz\"", "known here"),
    key("KinematicsName", "kinematics = \"smal\"", 14, "kinematics = \"smal\" must be one of: finite, small",
        "\"small\""),
    key("KinematicsType", "kinematics = 1", 14, "kinematics = 1 must be a text", "quotes"),
    key("ParticleDampingOne", "particle_damping = 1", 20, "particle_damping = 1 must be below 1", "0.7"),
    key("ParticleDampingNegative", "particle_damping = -0.1", 20, "must not be negative", "particle_damping"),
    key("ParticleDampingNan", "particle_damping = nan", 20, "must be finite", "particle_damping"),
    key("ParticleDampingUnit", "particle_damping = \"0.7 s\"", 20,
        "\"s\" is not of this dimension but a time; a pure number is wanted", "particle_damping = NUMBER"),
    key("BondDampingTruth", "bond_damping = true", 16, "bond_damping = true must be a number or a table",
        "{ normal"),
    key("BondDampingList", "bond_damping = [0.1]", 16, "a list of 1 must be a number or a table", "{ normal"),
    key("BondDampingText", "bond_damping = \"high\"", 16, "no number found", "bond_damping = NUMBER"),
    key("BondDampingNegative", "bond_damping = -0.1", 16, "must not be negative", "bond_damping"),
    key("BondDampingInfinite", "bond_damping = inf", 16, "must be finite", "bond_damping"),
    key("BondDampingMember", "bond_damping = { normal = 0.1, bendng = 0.1 }", 32,
        "unknown key \"bendng\" in bond_damping", "\"bending\""),
    key("BondDampingMemberPaper", "bond_damping = { paper = 0.1 }", 18,
        "unknown key \"paper\" in bond_damping", "known here: normal, shear, twisting, bending"),
    key("BondDampingMemberNegative", "bond_damping = { shear = -1 }", 26, "shear = -1 must not be negative",
        "shear = NUMBER"),
    key("BondDampingMemberNan", "bond_damping = { twisting = nan }", 29, "twisting = nan must be finite",
        "twisting"),
    key("TimeStepZero", "time_step = 0", 13, "time_step = 0 must be positive", "\"NUMBER s\""),
    key("TimeStepNegative", "time_step = \"-1 us\"", 13, "must be positive", "\"NUMBER s\""),
    key("TimeStepInfinite", "time_step = inf", 13, "must be finite", "time_step"),
    key("TimeStepNan", "time_step = nan", 13, "must be finite", "time_step"),
    key("TimeStepDimension", "time_step = \"1 m\"", 13,
        "\"m\" is not of this dimension but a length; a time is wanted, in ns, us, ms, s, min, h",
        "\"NUMBER s\""),
    key("TimeStepUnknownUnit", "time_step = \"1 usec\"", 13, "unknown unit \"usec\"; a time is wanted",
        "\"NUMBER s\""),
    key("TimeStepNoUnit", "time_step = \"1\"", 13, "the number has no unit", "\"NUMBER s\""),
    key("TimeStepType", "time_step = [1]", 13, "time_step = a list of 1 must be a number", "time_step"),
    {"TimeStepAndSafety", "[dynamics]\ntime_step = 1e-6\nsafety = 0.5", 22, 10,
     "[dynamics] has time_step, safety: they exclude each other", "keep one"},
    key("SafetyZero", "safety = 0", 10, "safety = 0 must be positive", "safety"),
    key("SafetyLarge", "safety = 2.1", 10, "safety = 2.1 must be at most 2", "safety = 0.8"),
    key("SafetyInfinite", "safety = inf", 10, "must be finite", "safety"),
    key("RampTimeNegative", "ramp_time = -1", 13, "ramp_time = -1 must not be negative", "\"NUMBER s\""),
    key("RampTimeNan", "ramp_time = nan", 13, "must be finite", "ramp_time"),
    key("RampTimeDimension", "ramp_time = \"1 m/s\"", 13, "but a velocity; a time is wanted", "\"NUMBER s\""),
    key("RampName", "ramp = \"lineal\"", 8, "ramp = \"lineal\" must be one of: linear, smooth", "\"linear\""),
    key("VelocityLimitZero", "velocity_limit = 0", 18, "must be positive", "\"NUMBER m/s\""),
    key("VelocityLimitDimension", "velocity_limit = \"1 mm\"", 18, "a velocity is wanted, in nm/s, um/s",
        "\"NUMBER m/s\""),
    key("VelocityLimitInfinite", "velocity_limit = inf", 18, "must be finite", "velocity_limit"),
    key("ForceLimitZero", "force_limit = 0", 15, "must be positive", "force_limit"),
    key("ForceLimitDimension", "force_limit = \"1 N\"", 15, "but a force; a pure number is wanted",
        "force_limit = NUMBER"),
    key("HoldTimeZero", "hold_time = 0", 13, "must be positive", "\"NUMBER s\""),
    key("HoldTimeType", "hold_time = false", 13, "hold_time = false must be a number", "hold_time"),
    key("MaxStepsZero", "max_steps = 0", 13, "must be a whole number, at least 1", "max_steps = 1"),
    key("MaxStepsBroken", "max_steps = 1.5", 13, "must be a whole number", "max_steps = 1"),
    key("MaxStepsNan", "max_steps = nan", 13, "must be a whole number", "max_steps = 1"),
    key("RecordIntervalZero", "record_interval = 0", 19, "must be positive", "\"NUMBER s\""),
    key("RecordIntervalInfinite", "record_interval = inf", 19, "must be finite", "record_interval"),
    key("SaveIntervalZero", "save_interval = 0", 17, "must be positive", "\"NUMBER s\""),
    key("SaveIntervalDimension", "save_interval = \"1 mm\"", 17, "a time is wanted", "\"NUMBER s\""),
    key("SaveIntervalType", "save_interval = true", 17, "save_interval = true must be a number",
        "save_interval"),
    key("SaveIntervalInfinite", "save_interval = inf", 17, "must be finite", "save_interval"),
    {"CheckIsList", "[[check]]", 20, 1, "[check] = a list of 1 must be a table", "{"},
    {"CheckKey", "[check]\ntolerence = 1e-6", 21, 1, "unknown key \"tolerence\" in [check]", "\"tolerance\""},
    {"CheckToleranceZero", "[check]\ntolerance = 0", 21, 13, "tolerance = 0 must be positive", "tolerance"},
    {"CheckToleranceNan", "[check]\ntolerance = nan", 21, 13, "must be finite", "tolerance"},
    {"CheckToleranceType", "[check]\ntolerance = true", 21, 13, "must be a number", "tolerance"},
};

INSTANTIATE_TEST_SUITE_P(Slips, BadDynamics, testing::ValuesIn(slips),
                         [](const auto& test) { return test.param.name; });

TEST(Dynamics, AllFaultsAreReportedAtOnce) {
  EXPECT_EQ(faults_for_dynamics(sound_case({{10, "at = { id = 99 }"},
                                            {19, "[dynamics]\nramp_time = -1\nramp = 2\n[check]\nx = 1"}}))
                .size(),
            5u);
}

const char* const packing = "[[particles]]\nfile = \"p.csv\"\n";
const char* const row =
    "[[particles]]\nline = { from = [0, 9, 0], step = [1, 0, 0], count = 2 }\nradius = 0.1\n";
const Files light{{"p.csv", "x,y,z,radius\n0,0,0,0.1\n"}};
const Files heavy{{"p.csv", "x,y,z,radius,rho\n0,0,0,0.1,2650\n"}};

void expect_light(const std::vector<Fault>& faults, const std::vector<int>& lines, const std::string& cure) {
  ASSERT_EQ(faults.size(), lines.size()) << (faults.empty() ? "" : InputError(faults).what());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(faults[i].place.file, "case.toml");
    EXPECT_EQ(faults[i].place.line, lines[i]);
    EXPECT_EQ(faults[i].place.column, 1);
    EXPECT_THAT(faults[i].message, HasSubstr("particles without density"));
    EXPECT_THAT(faults[i].cure, HasSubstr(cure));
  }
}

TEST(DensityForDynamics, IsNeededByABlock) {
  expect_light(faults_for_dynamics(sound_case()), {1}, "add density = 2650, say (kg/m3 in SI), to the block");
  EXPECT_THAT(faults_for_dynamics(sound_case())[0].cure, Not(HasSubstr("column")));
}

TEST(DensityForDynamics, IsNeededByAFile) {
  expect_light(faults_for_dynamics(packing, light), {1}, "or a column density to its file");
  EXPECT_THAT(faults_for_dynamics(packing, heavy), IsEmpty());
  EXPECT_THAT(faults_for_dynamics(std::string(packing) + "density = 1", light), IsEmpty());
}

TEST(DensityForDynamics, IsNeededByEveryBlock) {
  const std::string two = std::string(row) + packing;
  expect_light(faults_for_dynamics(two, light), {1, 4}, "density = 2650");
  expect_light(faults_for_dynamics(two, heavy), {1}, "density = 2650");
  expect_light(faults_for_dynamics(row + ("density = 1\n" + std::string(packing)), light), {5}, "column");
}

TEST(DensityForDynamics, IsOneFaultWhereItIsWrong) {
  const std::vector<Fault> faults = faults_for_dynamics(std::string(row) + "density = -1");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_THAT(faults[0].message, HasSubstr("density = -1 must be positive"));
  EXPECT_EQ(faults_for_dynamics(packing).size(), 1u);  // no such file
}

TEST(DensityForDynamics, IsNotNeededForStatics) {
  EXPECT_THAT(faults_of(sound_case()), IsEmpty());
  EXPECT_THAT(faults_of(packing, {}, light), IsEmpty());
}

}  // namespace
}  // namespace bondstatic::test
