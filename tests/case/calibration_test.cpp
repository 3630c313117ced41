// [calibration] of a case: what it reads as, and what is wrong with it, said at its place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "case/output_dimension.hpp"
#include "case/slip.hpp"
#include "case/sound_case.hpp"

namespace bondstatic::test {
namespace {

using testing::HasSubstr;
using Files = std::vector<std::pair<std::string, std::string>>;

/// Lines 19 to 26 of the sound case, some of them replaced.
std::string calibrated(const std::vector<std::pair<int, std::string>>& replaced = {},
                       const std::vector<std::pair<int, std::string>>& of_case = {}) {
  std::vector<std::string> lines{"[calibration]",               // 19
                                 "[[calibration.parameters]]",  // 20
                                 "key = \"bonds.0.young\"",     // 21
                                 "min = \"1 GPa\"",             // 22
                                 "max = 500e9",                 // 23
                                 "[[calibration.targets]]",     // 24
                                 "output = \"tip\"",            // 25
                                 "wanted = \"-8.5 mm\""};       // 26
  for (const auto& [line, text] : replaced) lines.at(std::size_t(line - 19)) = text;
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  auto whole = of_case;
  whole.emplace_back(19, all);
  return sound_case(whole);
}

TEST(CalibrationPlan, HasWhatIsGivenAndDefaults) {
  const Case c = read_case_text(calibrated());
  ASSERT_TRUE(c.calibration);
  const CalibrationPlan& plan = *c.calibration;
  ASSERT_EQ(plan.parameters.size(), 1u);
  EXPECT_EQ(plan.parameters[0].name, "bonds.0.young");
  EXPECT_EQ(plan.parameters[0].start, 200e9);
  EXPECT_EQ(plan.parameters[0].lower, 1e9);
  EXPECT_EQ(plan.parameters[0].upper, 500e9);
  EXPECT_TRUE(plan.parameters[0].logarithmic);
  ASSERT_EQ(plan.targets.size(), 1u);
  EXPECT_EQ(plan.targets[0].output, "tip");
  EXPECT_EQ(plan.targets[0].test, "");
  EXPECT_EQ(plan.targets[0].wanted, -8.5e-3);
  EXPECT_TRUE(std::isnan(plan.targets[0].tolerance));
  EXPECT_EQ(plan.targets[0].weight, 1);
  EXPECT_EQ(plan.options.loss, Loss::squares);
  EXPECT_EQ(plan.options.most_evaluations, 50);
  EXPECT_TRUE(c.warnings.empty());
  for (const char* part : {"loss = \"squares\"", "most_evaluations = 50", "scale = \"log\"",
                           "start = 200000000000.0", "weight = 1.0"})
    EXPECT_THAT(c.resolved, HasSubstr(part));
}

TEST(CalibrationPlan, IsNotThereWithoutItsTable) {
  EXPECT_FALSE(read_case_text(sound_case()).calibration);
}

TEST(CalibrationPlan, ScaleIsLinearWhereTheRangeHasZero) {
  const Case c =
      read_case_text(calibrated({{21, "key = \"poisson\""}, {22, "min = -0.5"}, {23, "max = 0.5"}}));
  EXPECT_FALSE(c.calibration->parameters[0].logarithmic);
  EXPECT_EQ(c.calibration->parameters[0].start, 0.3);
}

TEST(CalibrationPlan, TakesWhatOutputsAreTold) {
  // mm, downwards: the unit is turned into what is told, the sign is the told one's
  const Case c = read_case_text(calibrated({{26, "wanted = \"8.5 mm\"\ntolerance = \"20 um\""}},
                                           {{18, "at = { id = 11 }\nscale = -1e3"}}));
  EXPECT_NEAR(c.calibration->targets[0].wanted, 8.5, 1e-15);
  EXPECT_NEAR(c.calibration->targets[0].tolerance, 0.02, 1e-17);
  EXPECT_EQ(read_case_text(calibrated({{26, "wanted = 8.5"}}, {{18, "at = { id = 11 }\nscale = -1e3"}}))
                .calibration->targets[0]
                .wanted,
            8.5);
}

TEST(CalibrationPlan, KnowsTheUnitOfEveryQuantity) {
  for (const Quantity& quantity : output_quantities())
    EXPECT_TRUE(dimension_of_output(quantity.name)) << quantity.name;
  EXPECT_FALSE(dimension_of_output("nothing"));
  EXPECT_EQ(unit_scale(-1e3), 1e3);
  EXPECT_EQ(unit_scale(1e-9), 1e-9);
  EXPECT_EQ(unit_scale(2), std::nullopt);
  EXPECT_EQ(unit_scale(0), std::nullopt);
}

TEST(CalibrationPlan, ReadsAsTheSameFromTheResolvedCase) {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder / "other");
  folder.write("other/tension.toml", sound_case());
  const std::string text = calibrated(
      {{19, "[calibration]\ncases = [\"other/tension.toml\"]\nloss = \"cauchy\"\nmost_evaluations = 7"},
       {26,
        "wanted = -0.0085\ntolerance = 1e-5\ncase = "
        "\"other/../other/tension.toml\"\n[[calibration.targets]]\noutput = "
        "\"tip\"\ncase = \"case.toml\"\nwanted = -0.0081\ntolerance = 1e-5"}});
  const std::string elsewhere = (folder / "results").string();
  const Case first = read_case(folder.write("case.toml", text), {}, elsewhere);
  std::filesystem::create_directories(elsewhere);
  const Case again = read_case(folder.write("results/case.resolved.toml", first.resolved), {}, elsewhere);
  EXPECT_EQ(first.resolved, again.resolved);
  const CalibrationPlan &one = *first.calibration, &two = *again.calibration;
  EXPECT_EQ(std::filesystem::canonical(one.cases.at(0)), std::filesystem::canonical(two.cases.at(0)));
  EXPECT_EQ(one.targets[0].test, "other/tension.toml");
  EXPECT_EQ(two.targets[0].test, "../other/tension.toml");
  EXPECT_EQ(one.targets[1].test, "case.toml");
  EXPECT_EQ(two.targets[1].test, "case.resolved.toml");
  EXPECT_EQ(two.options.loss, Loss::cauchy);
  EXPECT_EQ(two.options.most_evaluations, 7);
  EXPECT_EQ(one.parameters[0].start, two.parameters[0].start);
}

class BadCalibration : public testing::TestWithParam<Slip> {};

TEST_P(BadCalibration, IsOneFaultWithPlaceAndCure) {
  const Slip& slip = GetParam();
  expect_told(slip, faults_of(calibrated({{slip.line, slip.replacement}}), {},
                              {{"other.toml", sound_case()}, {"bare.toml", "title = \"no outputs\""}}));
}

const std::vector<Slip> slips{
    {"UnknownKey", 19, "[calibration]\nlos = \"huber\"", 20, 1, "unknown key \"los\"", "loss"},
    {"LossWithoutTolerances", 19, "[calibration]\nloss = \"huber\"", 20, 8, "needs tolerances", "squares"},
    {"Loss", 19, "[calibration]\nloss = \"huger\"", 20, 8, "squares, huber, cauchy", "huber"},
    {"NoEvaluations", 19, "[calibration]\nmost_evaluations = 0", 20, 20, "at least 1", "write"},
    {"CasesAsText", 19, "[calibration]\ncases = \"other.toml\"", 20, 9, "must be a list", "[\"other.toml\"]"},
    {"CaseTwice", 19, "[calibration]\ncases = [\"other.toml\", \"./other.toml\"]", 20, 24, "a test already",
     "once"},
    {"CaseItself", 19, "[calibration]\ncases = [\"case.toml\"]", 20, 10, "a test already", "other cases"},
    {"CaseMissing", 19, "[calibration]\ncases = [\"nowhere.toml\"]", 20, 9, "nowhere.toml", ""},
    {"SeedsWithoutKey", 19, "[calibration]\nseeds = { values = [1] }", 20, 9, "needs key", "bonds.0.seed"},
    {"SeedsWithoutValues", 19, "[calibration]\nseeds = { key = \"particles.0.line.count\" }", 20, 9,
     "needs values", "[1, 2, 3]"},
    {"SeedTwice", 19, "[calibration]\nseeds = { key = \"particles.0.line.count\", values = [2, 2] }", 20, 56,
     "seed 2 is there twice", "once"},
    {"SeedOfNothing", 19, "[calibration]\nseeds = { key = \"bonds.0.seed\", values = [1] }", 20, 17,
     "the case has no bonds.0.seed", "seed"},
    {"SeedNotWhole", 19, "[calibration]\nseeds = { key = \"bonds.0.young\", values = [1] }", 20, 17,
     "no whole number", "seed"},
    {"NoKey", 21, "", 20, 1, "needs key", "bonds.0.young"},
    {"Misspelt", 21, "key = \"bonds.0.yuong\"", 21, 7, "timoshenko, takes no yuong; it takes: young, poisson",
     "did you mean \"young\"?"},
    {"MisspeltOfAll", 21, "key = \"yuong\"", 21, 7, "takes no yuong", "did you mean \"young\"?"},
    {"Strength", 21, "key = \"bonds.0.strength.cohesion\"", 21, 7,
     "strengths change nothing in a static answer", "young, poisson"},
    {"OfNoBlock", 21, "key = \"bonds.1.young\"", 21, 7, "no bonds.1", "from 0 to 0"},
    {"OfAllBonds", 21, "key = \"bonds.young\"", 21, 7, "names no parameter of a block", "bonds.0.young"},
    {"NotGiven", 21, "key = \"radius_factor\"", 21, 7, "gives radius, not radius_factor", "calibrate radius"},
    {"NoMin", 22, "", 20, 1, "needs min", "the case has 200000000000"},
    {"NoMax", 23, "", 20, 1, "needs max", "add max"},
    {"MinAboveMax", 22, "min = 600e9", 23, 7, "must be more than min", "range"},
    {"MinOfNothing", 22, "min = \"1 mm\"", 22, 7, "", "Pa"},
    {"MinNan", 22, "min = nan", 22, 7, "must be finite", "NUMBER"},
    {"MinNegative", 22, "min = -1e9", 22, 7, "outside of what young can be: more than 0", "inside"},
    {"MinZero", 22, "min = 0", 22, 7, "outside of what young can be", "inside"},
    {"StartOutside", 23, "max = 500e9\nstart = 600e9", 24, 9, "start = 600000000000 is outside", "inside"},
    {"ScaleUnknown", 23, "max = 500e9\nscale = \"lin\"", 24, 9, "log, linear", ""},
    {"Twice", 23, "max = 500e9\n[[calibration.parameters]]\nkey = \"young\"\nmin = 1\nmax = 1e12", 25, 7,
     "bonds.0.young is calibrated already, by \"bonds.0.young\"", "once"},
    {"Output", 25, "output = \"top\"", 25, 10, "no output \"top\"", "did you mean \"tip\"?"},
    {"NoOutput", 25, "", 24, 1, "needs output", "name of [[outputs]]"},
    {"NoWanted", 26, "", 24, 1, "needs wanted", "measured"},
    {"WantedNan", 26, "wanted = nan", 26, 10, "must be finite", "NUMBER"},
    {"WantedForce", 26, "wanted = \"3 kN\"", 26, 10, "", "m"},
    {"ToleranceZero", 26, "wanted = -1\ntolerance = 0", 27, 13, "must be positive", ""},
    {"WeightAndTolerance", 26, "wanted = -1\ntolerance = 0.1\nweight = 2", 28, 10, "exclude each other",
     "keep"},
    {"TargetTwice", 26, "wanted = -1\n[[calibration.targets]]\noutput = \"tip\"\nwanted = 2\n", 28, 10,
     "a target already", "one target"},
    {"OfNoTest", 26, "wanted = -1\ncase = \"thiss\"", 27, 8, "is no test; there are: this, case.toml",
     "did you mean \"this\"?"},
};
INSTANTIATE_TEST_SUITE_P(, BadCalibration, testing::ValuesIn(slips),
                         [](const auto& slip) { return slip.param.name; });

TEST(RefusedCalibration, WithoutTargetsOrParameters) {
  const auto faults = faults_of(sound_case({{19, "[calibration]\ntargets = []"}}));
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_THAT(faults[0].message, HasSubstr("no parameters"));
  EXPECT_THAT(faults[1].message, HasSubstr("no targets"));
  EXPECT_EQ(faults[1].place.line, 20);
}

TEST(RefusedCalibration, LogOfARangeWithZero) {
  const auto faults = faults_of(
      calibrated({{21, "key = \"bonds.0.poisson\""}, {22, "min = 0"}, {23, "max = 0.4\nscale = \"log\""}}));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_THAT(faults[0].message, HasSubstr("needs min > 0"));
  EXPECT_EQ(faults[0].place.line, 24);
}

TEST(RefusedCalibration, OfSeedsAndSwitches) {
  const std::pair<int, std::string> law{
      5, "law = \"edem-v2\"\nnormal_stiffness = 1e9\nshear_stiffness = 1e9\ntorque_feedback = true"};
  for (const char* name : {"seed", "torque_feedback"}) {
    const auto faults = faults_of(
        calibrated({{21, std::string("key = \"") + name + "\""}}, {law, {6, ""}, {7, ""}, {8, ""}}));
    ASSERT_EQ(faults.size(), 1u) << name;
    EXPECT_THAT(faults[0].message, HasSubstr("cannot be calibrated"));
    EXPECT_THAT(faults[0].cure, HasSubstr("normal_stiffness"));
  }
}

TEST(RefusedCalibration, MoreParametersThanTargets) {
  const auto faults = faults_of(
      calibrated({{23, "max = 500e9\n[[calibration.parameters]]\nkey = \"poisson\"\nmin = 0.1\nmax = 0.4"}}));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].place.line, 19);
  EXPECT_THAT(faults[0].message, HasSubstr("2 parameters are more than 1 target"));
}

/// Beside the timoshenko block of 200 GPa.
const std::string second_block =
    "radius = 0.2\nexisting = \"add\"\n[[bonds]]\nlaw = \"parallel\"\nyoung = 100e9\nkappa = 2\n"
    "radius = 0.2\nexisting = \"add\"";

TEST(CalibrationPlan, OneKeyIsOfAllBlocksThatGiveIt) {
  // kappa of the one block that gives it, not of the other
  const Case kappa = read_case_text(
      calibrated({{21, "key = \"kappa\""}, {22, "min = 1"}, {23, "max = 9"}}, {{8, second_block}}));
  EXPECT_EQ(kappa.calibration->parameters[0].start, 2);
  EXPECT_TRUE(kappa.warnings.empty());
  const Case young = read_case_text(calibrated({{21, "key = \"young\""}}, {{8, second_block}}));
  EXPECT_EQ(young.calibration->parameters[0].start, 200e9);
  ASSERT_EQ(young.warnings.size(), 1u);
  EXPECT_THAT(young.warnings[0],
              HasSubstr("starts from 200000000000, not from bonds.1.young = 100000000000"));
  const auto faults = faults_of(calibrated({{21, "key = \"bonds.1.poisson\""}}, {{8, second_block}}));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_THAT(faults[0].message, HasSubstr("bonds.1 gives kappa, not poisson"));
}

// Sweeps vary what is calibrated, too.
TEST(CalibrationPlan, StartsFromTheBoundWhereTheCaseIsOutside) {
  const Case c = read_case_text(calibrated({{23, "max = 100e9"}}));
  EXPECT_EQ(c.calibration->parameters[0].start, 100e9);
  ASSERT_EQ(c.warnings.size(), 1u);
  EXPECT_THAT(c.warnings[0], HasSubstr(":20:1: a calibration starts from 100000000000, not from"));
}

TEST(RefusedCalibration, OfAParameterThatEachBondHasOfItsOwn) {
  const auto faults = faults_of(calibrated({}, {{8, "radius = 0.2\nfile = \"bonds.csv\""}}), {},
                                {{"bonds.csv", "a,b,young\n1,2,1e9\n2,3,2e9\n"}});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_THAT(faults[0].message, HasSubstr("each bond of bonds.0 has a young of its own"));
}

TEST(RefusedCalibration, TolerancesOfSomeTargets) {
  const auto faults = faults_of(
      calibrated({{26, "wanted = -1\n[[calibration.targets]]\noutput = \"side\"\nwanted = 0\ntolerance = 1"}},
                 {{18, "at = { id = 11 }\n[[outputs]]\nname = \"side\"\nof = \"uz\"\nat = { id = 11 }"}}));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].message, "\"side\" has a tolerance, but \"tip\" has none");
}

TEST(RefusedCalibration, OfOutputsThatMeanDifferentThings) {
  const auto faults = faults_of(calibrated({{19, "[calibration]\ncases = [\"other.toml\"]"}}), {},
                                {{"other.toml", sound_case({{17, "of = \"uz\""}})}});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_THAT(faults[0].message, HasSubstr("not the same in case.toml and other.toml"));
}

CalibrationProblem problem_of(const std::string& text, const Files& files = {}) {
  const ScratchFolder folder;
  for (const auto& [name, content] : files) folder.write(name, content);
  return read_calibration(folder.write("case.toml", text));
}

TEST(CalibrationProblem, HasATestForEachSeedAndCase) {
  const CalibrationProblem problem = problem_of(
      calibrated({{19,
                   "[calibration]\ncases = [\"tip.toml\"]\nseeds = { key = \"particles.0.line.count\", "
                   "values = [11, 21] }"},
                  {26, "wanted = -0.0085"}},
                 {{3, "radius = 0.2\n"}, {5, "gap = 0.001\nlaw = \"timoshenko\""}, {13, "at = { id = 11 }"}}),
      {{"tip.toml", sound_case()}});
  ASSERT_EQ(problem.tests.size(), 3u);
  EXPECT_EQ(problem.tests[0].name, "case.toml, particles.0.line.count=11");
  EXPECT_EQ(problem.tests[1].name, "case.toml, particles.0.line.count=21");
  EXPECT_EQ(problem.tests[2].name, "tip.toml");
  EXPECT_EQ(problem.tests[1].model.particles.size(), 21u);
  ASSERT_EQ(problem.targets.size(), 3u);
  for (std::size_t t = 0; t < 3; ++t) {
    EXPECT_EQ(problem.targets[t].test, problem.tests[t].name);
    ASSERT_EQ(problem.tests[t].parameters.size(), 1u);
    ASSERT_EQ(problem.tests[t].parameters[0].size(), 1u);
    EXPECT_EQ(problem.tests[t].parameters[0][0].block, 0);
    EXPECT_EQ(problem.tests[t].parameters[0][0].parameter, 0u);
  }
}

TEST(CalibrationProblem, TargetsAreOfTheTestThatTheyName) {
  const auto text = [](const char* which) {
    return calibrated({{19, "[calibration]\ncases = [\"tip.toml\"]"},
                       {26, std::string("wanted = -0.0085\ncase = ") + which}});
  };
  for (const auto& [which, name] : {std::pair{"\"this\"", "case.toml"}, {"\"tip.toml\"", "tip.toml"}}) {
    const CalibrationProblem problem = problem_of(text(which), {{"tip.toml", sound_case()}});
    ASSERT_EQ(problem.targets.size(), 1u);
    EXPECT_EQ(problem.targets[0].test, name);
    ASSERT_EQ(problem.warnings.size(), 1u);
    EXPECT_THAT(problem.warnings[0], HasSubstr("has no target, and is not solved"));
  }
}

TEST(CalibrationProblem, SaysWhichTestDoesNotFollowAParameter) {
  const std::string two =
      calibrated({{19, "[calibration]\ncases = [\"tip.toml\"]"},
                  {23,
                   "max = 500e9\n[[calibration.parameters]]\nkey = \"bonds.0.poisson\"\nmin = 0.1\n"
                   "max = 0.4"}});
  const CalibrationProblem problem = problem_of(
      two, {{"tip.toml", sound_case({{5, "law = \"euler-bernoulli\""}, {7, ""}, {8, "poisson = 0.3"}})}});
  EXPECT_TRUE(problem.warnings.empty());
  const CalibrationProblem lacking =
      problem_of(two, {{"tip.toml", sound_case({{5, "law = \"parallel\""}, {7, "kappa = 2"}})}});
  ASSERT_EQ(lacking.warnings.size(), 1u);
  EXPECT_EQ(lacking.warnings[0],
            "tip.toml does not follow bonds.0.poisson: bonds.0 gives kappa, not poisson");
  EXPECT_TRUE(lacking.tests[1].parameters[1].empty());
  const std::string generic =
      sound_case({{5, "law = \"generic\""}, {6, "kn = 1\nks = 1"}, {7, "kt = 1"}, {8, "kb = 1"}});
  EXPECT_THROW(problem_of(two, {{"tip.toml", generic}}), InputError);
}

TEST(CalibrationProblem, SaysWhichBondsHaveTheirOwnValue) {
  const CalibrationProblem problem = problem_of(calibrated({}, {{8, "radius = 0.2\nfile = \"bonds.csv\""}}),
                                                {{"bonds.csv", "a,b,young\n1,2,1e9\n2,3,\n3,4,2e9\n"}});
  ASSERT_EQ(problem.warnings.size(), 1u);
  EXPECT_THAT(
      problem.warnings[0],
      HasSubstr("2 of 3 bonds of bonds.0 have a young of their own, and do not follow bonds.0.young"));
}

TEST(CalibrationProblem, NeedsTheTable) {
  try {
    problem_of(sound_case());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("case.toml:1:1: the case has no [calibration]"));
  }
}

TEST(CalibratedCase, HasTheValuesInPlaceOfTheParameters) {
  const ScratchFolder folder;
  const std::string file = folder.write("case.toml", calibrated());
  const CalibrationProblem problem = read_calibration(file);
  const double value = 123456789012.34567;
  const Case again = read_case(
      folder.write("calibrated.toml", calibrated_case(problem, {}, folder.path().string(), {value})));
  EXPECT_EQ(again.model.blocks[0].parameters[0], value);
  EXPECT_EQ(again.calibration->parameters[0].start, value);
}

}  // namespace
}  // namespace bondstatic::test
