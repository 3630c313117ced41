// LAMMPS input scripts: commands, constants, groups, and what they do to a packing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "formats/lammps/apply_script.hpp"
#include "io/scratch_folder.hpp"

namespace bondstatic {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Reading {
  std::optional<LammpsScript> script;
  std::vector<Fault> faults;
};

Reading read(const std::string& text) {
  const test::ScratchFolder folder;
  Reading reading;
  reading.script = read_lammps_script(folder.write("in.test", text), {"command line", 0, 0}, reading.faults);
  EXPECT_EQ(reading.script.has_value(), reading.faults.empty());
  return reading;
}

LammpsScript sound(const std::string& text) {
  const Reading reading = read(text);
  for (const Fault& fault : reading.faults) ADD_FAILURE() << to_string(fault);
  return reading.script.value_or(LammpsScript{});
}

/// Six particles, ids 1 to 6, types 1 1 2 2 3 3, one after the other along x at distances 1, 2, 3, 4, 5;
/// bonds of type 1 and 2 in turn.
ForeignModel row_of_six() {
  ForeignModel model;
  model.group_names = {"type 1", "type 2", "type 3"};
  for (Index i = 0; i < 6; ++i) {
    model.particles.push_back({i + 1, Vector3(double(i * (i + 1)) / 2, 0, 0), 0.5, 2000});
    model.group.push_back(int(i / 2));
    if (i > 0) model.bonds.push_back({i, i, i + 1, (i - 1) % 2 + 1});
  }
  model.box = Cell{Vector3(-1, -1, -1), Vector3(20, 3, 3).asDiagonal(), {false, false, false}};
  return model;
}

struct Applied {
  ForeignModel model = row_of_six();
  std::optional<ForeignSetup> setup;
  std::vector<Fault> faults;
};

Applied apply(const std::string& text) {
  Applied applied;
  applied.setup = apply_script(sound("boundary f f f\n" + text), applied.model, applied.faults);
  EXPECT_EQ(applied.setup.has_value(), applied.faults.empty());
  return applied;
}

std::vector<Index> members(const ForeignSetup& setup, const std::string& name) {
  for (const ForeignGroup& group : setup.groups)
    if (group.name == name) return group.members;
  return {-1};
}

TEST(LammpsFormula, IsACalculationWithConstants) {
  const ScriptVariables variables{{"E", "2e9"}, {"word", "steel"}};
  const auto value = [&](const char* text) { return constant_formula(text, variables).value_or(not_given); };
  EXPECT_EQ(value("1+2*3"), 7);
  EXPECT_EQ(value("(1+2)*3 - -4"), 13);
  EXPECT_EQ(value("v_E/4"), 5e8);
  EXPECT_EQ(value("2^3*2"), 16);
  EXPECT_EQ(value("2^-1"), 0.5);
  EXPECT_EQ(value("sqrt(16)+ln(exp(1))"), 5);
  EXPECT_EQ(value("PI*0.5^2"), M_PI * 0.25);
  EXPECT_EQ(value("10/4/5"), 0.5);
}

TEST(LammpsFormula, RefusesWhatIsNoConstantOrCanBeReadInTwoWays) {
  const ScriptVariables variables{{"word", "steel"}};
  for (const char* text : {"", "1+", "v_none", "v_word", "step*2", "c_1", "-2^2", "2^3^2", "1/0", "1e400",
                           "sqrt(-1)", "(1", "1)", "2 3", "random(0,1,5)", "nan", "inf"})
    EXPECT_FALSE(constant_formula(text, variables)) << text;
  EXPECT_FALSE(constant_formula(std::string(100'000, '('), variables));
}

TEST(LammpsScript, JoinsLinesDropsCommentsAndFollowsConstants) {
  const LammpsScript script = sound(
      "units si # comment\n"
      "atom_style hybrid &\n   sphere bond\n"
      "variable k equal 2*3.5e5\r\n"
      "variable kt index 0.25 0.5\n"
      "variable kt index 7\n"
      "variable name string 'my data'\n"
      "# bond_style harmonic &\n and this line with it\n"
      "bond_style bpm/rotational smooth no break no normalize yes\n"
      "bond_coeff * ${k} $(v_k/2) ${kt} 1 \"2\" 3 4 5 6 7 8 9\n"
      "print \"\"\"\nbond_coeff 1 not a command\n\"\"\"\n"
      "read_data \"${name}/x.data\" extra/bond/per/atom 3\n");
  EXPECT_EQ(script.units, "si");
  EXPECT_EQ(script.atom_style, "hybrid sphere bond");
  EXPECT_TRUE(script.normalize);
  ASSERT_EQ(script.bond_coefficients.size(), 1u);
  EXPECT_THAT(script.bond_coefficients[0].numbers, ElementsAre(7e5, 3.5e5, 0.25, 1, 2, 3, 4, 5, 6, 7, 8, 9));
  // $ in quotes stays as it is, as LAMMPS has it.
  EXPECT_THAT(script.data_file, HasSubstr("/${name}/x.data"));
}

TEST(LammpsScript, TakesTheFixesOfTheLastRun) {
  const LammpsScript script = sound(
      "fix 1 all nve\nfix 2 all addforce 1 0 0\nrun 10\nunfix 2\nfix 3 all addforce 0 1 0\nrun 10\nunfix "
      "3\n");
  ASSERT_EQ(script.fixes.size(), 2u);
  EXPECT_EQ(script.fixes[1].id(), "3");
}

TEST(LammpsScript, FollowsAVariableOnlyWhereItsValueIsCertain) {
  // LAMMPS evaluates b when it is used: 6 here, not the 4 of the line that defines it.
  const std::string chain =
      "variable a equal 2\nvariable b equal v_a*2\nvariable c equal 1+v_b\nvariable ab equal 1\n";
  EXPECT_EQ(sound(chain).variables.at("c"), "5");
  EXPECT_EQ(sound(chain + "variable a equal 2\n").variables.at("c"), "5");
  const LammpsScript changed = sound(chain + "variable a equal 3\n");
  EXPECT_EQ(changed.variables.at("a"), "3");
  EXPECT_EQ(changed.variables.at("ab"), "1");
  EXPECT_FALSE(changed.variables.contains("b"));
  EXPECT_FALSE(changed.variables.contains("c"));
  // Fixes hold what the last run had, and so their variables.
  EXPECT_EQ(sound("variable a equal 2\nrun 5\nvariable a equal 3\n").variables.at("a"), "2");
  // A format rounds, by how much LAMMPS knows.
  EXPECT_FALSE(read("variable a equal 1/3\nbond_style bpm/rotational\n"
                    "bond_coeff 1 $(v_a:%.2f) 2 3 4 5 6 7 8 9 10 11 12\n")
                   .script);
}

TEST(LammpsScript, AFileBeforeTheLastReadDataIsTold) {
  const LammpsScript script = sound("read_data a.data\nread_data b.data add append\n");
  EXPECT_THAT(script.data_file, HasSubstr("b.data"));
  EXPECT_THAT(script.notes.left_out, Contains(HasSubstr("read_data a.data (line 1)")));
}

TEST(LammpsScript, ManyLinesOfOneCommandTakeTimeInProportion) {
  std::string goes_on = "fix 1 all nve", quoted = "print \"\"\"";
  for (int i = 0; i < 100'000; ++i) {
    goes_on += " &\n 1";
    quoted += "x\n";
  }
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(sound(goes_on).fixes.at(0).command.arguments(), 100'003u);
  sound(quoted + "\"\"\"\n");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
}

TEST(LammpsScript, SaysWhatItDoesNotRead) {
  const LammpsScript script =
      sound("displace_atoms all move 1 0 0\nfrobnicate 1\nfrobnicate 2\npair_style gran/hooke 1 2\nrun 5\n");
  std::string all;
  for (const std::string& note : script.notes.left_out) all += note + "\n";
  EXPECT_THAT(all, HasSubstr("displace_atoms (line 1) is not executed"));
  EXPECT_THAT(all, HasSubstr("frobnicate (line 2, 3)"));
  EXPECT_THAT(all, HasSubstr("gran/hooke"));
  all.clear();
  for (const std::string& note : script.notes.assumed) all += note + "\n";
  EXPECT_THAT(all, HasSubstr("no boundary command"));
  EXPECT_THAT(all, HasSubstr("no units command"));
}

TEST(LammpsScript, KnowsScriptsByTheirNames) {
  for (const char* name : {"in.lammps", "/a/in.x", "x.in", "x.lammps", "x.lmp"})
    EXPECT_TRUE(is_lammps_script_name(name)) << name;
  for (const char* name : {"packing.data", "in/packing.data", "x.input", "dump.final", "x.csv"})
    EXPECT_FALSE(is_lammps_script_name(name)) << name;
}

struct Malformed {
  const char* name;
  const char* text;
  int line, column;
  const char* message;
  const char* cure;
};

class MalformedScript : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedScript, IsToldWithLineAndCure) {
  const Malformed& row = GetParam();
  const Reading reading = read(row.text);
  ASSERT_FALSE(reading.faults.empty());
  const Fault& fault = reading.faults.front();
  EXPECT_THAT(fault.place.file, HasSubstr("in.test"));
  EXPECT_EQ(fault.place.line, row.line);
  EXPECT_EQ(fault.place.column, row.column);
  EXPECT_THAT(fault.message, HasSubstr(row.message));
  EXPECT_THAT(fault.cure, HasSubstr(row.cure));
}

const Malformed malformed[] = {
    {"UnknownUnits", "units sii\n", 1, 7, "units sii are unknown", "did you mean si?"},
    {"NoUnits", "\nunits\n", 2, 1, "units with 0 arguments", "units si"},
    {"BoundaryLetters", "boundary p x p\n", 1, 12, "\"x\" is none", "p is periodic"},
    {"HalfPeriodic", "boundary pf f f\n", 1, 10, "\"pf\" is none", "p is periodic"},
    {"OpenQuote", "units si\nprint \"abc\nunits si\n", 2, 1, "quote \" is not closed", "close it"},
    {"OpenTripleQuote", "print \"\"\"abc\nunits si\n", 1, 1, "is not closed", "check the quotes"},
    {"CoefficientsMissing", "bond_style bpm/rotational\nbond_coeff 1 2 3\n", 2, 1, "with 2 numbers",
     "twelve"},
    {"CoefficientsWithoutType", "bond_style bpm/rotational\nbond_coeff\n", 2, 1, "with 0 numbers", "twelve"},
    {"CoefficientsBeforeStyle", "bond_coeff 1 2 3\n", 1, 1, "before bond_style", "bond_style bpm/rotational"},
    {"NotANumber", "bond_style bpm/rotational\nbond_coeff 1 1 2 x 4 5 6 7 8 9 10 11 12\n", 2, 18,
     "\"x\" is no finite number", "finite"},
    {"TooLarge", "bond_style bpm/rotational\nbond_coeff 1 1e400 2 3 4 5 6 7 8 9 10 11 12\n", 2, 14,
     "is no finite number", "finite"},
    {"NotAConstant", "bond_style bpm/rotational\nbond_coeff 1 ${kn} 2 3 4 5 6 7 8 9 10 11 12\n", 2, 14,
     "\"${kn}\" is no constant", "write its number"},
    {"NegativeStiffness", "bond_style bpm/rotational\nbond_coeff 1 1 -2 3 4 5 6 7 8 9 10 11 12\n", 2, 16,
     "stiffness -2 is negative", "not negative"},
    {"BondType", "bond_style bpm/rotational\nbond_coeff 0 1 2 3 4 5 6 7 8 9 10 11 12\n", 2, 12,
     "\"0\" is no bond type", "*"},
    {"YesOrNo", "bond_style bpm/rotational smooth maybe\n", 1, 34, "smooth needs yes or no", "smooth yes"},
    {"GroupWithoutStyle", "group top\n", 1, 1, "says too little", "group NAME type 1 2"},
    {"GroupWithLabel", "group top type 1 OW\n", 1, 18, "\"OW\" is no type", "labels are not read"},
    {"GroupSequence", "group top id 1:9:0\n", 1, 14, "\"1:9:0\" is no id", "A:B"},
    {"GroupComparison", "group top id <>  1\n", 1, 14, "compares with no whole number", "<="},
    {"FixWithoutStyle", "fix 1 all\n", 1, 1, "fix with 2 arguments", "fix ID GROUP STYLE"},
    {"Unfix", "unfix\n", 1, 1, "unfix with 0", "unfix ID"},
};

INSTANTIATE_TEST_SUITE_P(All, MalformedScript, testing::ValuesIn(malformed),
                         [](const auto& row) { return row.param.name; });

TEST(MalformedScript, BinaryAndMissingFilesAreFaults) {
  EXPECT_EQ(read(std::string("units si\nfix \0 1\n", 15)).faults.size(), 1u);
  std::vector<Fault> faults;
  EXPECT_FALSE(read_lammps_script("/nowhere/in.x", {"command line", 0, 0}, faults));
  EXPECT_EQ(faults.size(), 1u);
}

TEST(LammpsScript, AnyPieceOfASoundScriptIsReadOrRefused) {
  const std::string text =
      "units si\natom_style bpm/sphere\nboundary f f f\nbond_style bpm/rotational break no smooth no\n"
      "variable F equal \"2*(3+1)\"\nbond_coeff 1 1e6 4e5 5e-2 8e-2 1 1 1 1 &\n 0.3 0.3 3e-8 3e-8\n"
      "group a type 1:3:2\ngroup b subtract all a\nfix 1 b nve/bpm/sphere\nfix 2 a freeze\n"
      "fix 3 b addforce v_F 0 $(-v_F)\nrun 100\n";
  for (std::size_t length = 0; length <= text.size(); ++length) {
    for (const char* end : {"", "\"", "&", "${", "$(", "'''"}) {
      const Reading reading = read(text.substr(0, length) + end);
      if (!reading.script) continue;
      ForeignModel model = row_of_six();
      std::vector<Fault> faults;
      const bool applied = apply_script(*reading.script, model, faults).has_value();
      EXPECT_EQ(applied, faults.empty());
    }
  }
}

TEST(LammpsGroups, AreWhatLammpsMakesOfThem) {
  const Applied applied = apply(
      "group types type 1 3\ngroup ids id 1:5:2\ngroup ids id 6\ngroup below id < 3\ngroup not type != 2\n"
      "group between id <> 2 4\ngroup rest subtract all types\ngroup both intersect types ids\n"
      "group either union below between\n"
      "fix 1 types addforce 1 0 0\nfix 2 ids addforce 1 0 0\nfix 3 below addforce 1 0 0\n"
      "fix 4 not addforce 1 0 0\nfix 5 between addforce 1 0 0\nfix 6 rest addforce 1 0 0\n"
      "fix 7 both addforce 1 0 0\nfix 8 either addforce 1 0 0\n");
  ASSERT_TRUE(applied.setup);
  const ForeignSetup& setup = *applied.setup;
  EXPECT_THAT(members(setup, "types"), ElementsAre(0, 1, 4, 5));
  EXPECT_THAT(members(setup, "ids"), ElementsAre(0, 2, 4, 5));
  EXPECT_THAT(members(setup, "below"), ElementsAre(0, 1));
  EXPECT_THAT(members(setup, "not"), ElementsAre(0, 1, 4, 5));
  EXPECT_THAT(members(setup, "between"), ElementsAre(1, 2, 3));
  EXPECT_THAT(members(setup, "rest"), ElementsAre(2, 3));
  EXPECT_THAT(members(setup, "both"), ElementsAre(0, 4, 5));
  EXPECT_THAT(members(setup, "either"), ElementsAre(0, 1, 2, 3));
}

TEST(LammpsFixes, HoldAndLoad) {
  const Applied applied = apply(
      "variable F equal 3\ngroup low type 1\ngroup high type 3\n"
      "fix 1 low freeze\nfix 2 high setforce 0 NULL 0\nfix 3 high addforce v_F 0 -2\n"
      "fix 4 all gravity 9.5 vector 0 0 -2\nfix 5 all nve/bpm/sphere\nfix 6 all damping/cundall 0.3 0.3\n");
  ASSERT_TRUE(applied.setup);
  const ForeignSetup& setup = *applied.setup;
  ASSERT_EQ(setup.supports.size(), 2u);
  EXPECT_EQ(setup.supports[0].group, "low");
  EXPECT_THAT(setup.supports[0].fixed, ElementsAre(true, true, true, true, true, true));
  EXPECT_THAT(setup.supports[1].fixed, ElementsAre(true, false, true, false, false, false));
  ASSERT_EQ(setup.loads.size(), 2u);
  EXPECT_EQ(setup.loads[0].value, Vector3(3, 0, -2));
  EXPECT_FALSE(setup.loads[0].gravity);
  EXPECT_EQ(setup.loads[1].group, "all");
  EXPECT_EQ(setup.loads[1].value, Vector3(0, 0, -9.5));
  EXPECT_TRUE(setup.loads[1].gravity);
}

TEST(LammpsFixes, WhatNothingIntegratesIsHeldUnlessOtherFixesMoveIt) {
  const std::string script = "group low type 1\ngroup rest subtract all low\nfix 1 rest nve/sphere\n";
  const Applied held = apply(script);
  ASSERT_TRUE(held.setup);
  ASSERT_EQ(held.setup->supports.size(), 1u);
  EXPECT_THAT(members(*held.setup, "not integrated"), ElementsAre(0, 1));
  const Applied frozen = apply(script + "fix 2 low freeze\n");
  ASSERT_TRUE(frozen.setup);
  ASSERT_EQ(frozen.setup->supports.size(), 1u);
  EXPECT_EQ(frozen.setup->supports[0].group, "low");
  const Applied moved = apply(script + "fix 2 low move linear 0 0 1\n");
  ASSERT_TRUE(moved.setup);
  EXPECT_THAT(moved.setup->supports, IsEmpty());
}

TEST(LammpsFixes, ThatTurnNoParticleAreTold) {
  for (const char* style : {"nve", "nve/sphere"})
    EXPECT_THAT(
        apply(std::string("bond_style bpm/rotational\nfix 1 all ") + style + "\n").model.notes.assumed,
        Contains(HasSubstr("free to turn")))
        << style;
  EXPECT_THAT(apply("bond_style bpm/rotational\nfix 1 all nve/bpm/sphere\n").model.notes.assumed,
              testing::Not(Contains(HasSubstr("free to turn"))));
}

TEST(LammpsFixes, OfAnUnknownGroupAreFaultsOfARegionAreLeftOut) {
  const Applied unknown = apply("fix 1 top addforce 1 0 0\n");
  ASSERT_EQ(unknown.faults.size(), 1u);
  EXPECT_EQ(unknown.faults[0].place.line, 2);
  EXPECT_THAT(unknown.faults[0].message, HasSubstr("no group top"));
  const Applied region = apply("group top region box\ngroup more union all top\nfix 1 more addforce 1 0 0\n");
  ASSERT_TRUE(region.setup);
  EXPECT_THAT(region.setup->loads, IsEmpty());
  EXPECT_THAT(region.model.notes.left_out.front(), HasSubstr("group cannot be told"));
  EXPECT_THAT(apply("fix 1 all addforce 1 0\n").faults.front().message, HasSubstr("says too little"));
  EXPECT_THAT(apply("fix 1 all addforce 1 0 v_x\n").faults.front().message, HasSubstr("no constant"));
  EXPECT_THAT(apply("group a union b c\n").faults.front().message, HasSubstr("made of b, which is no group"));
}

constexpr const char* coefficients =
    "bond_coeff * 6 3 2 1 10 20 30 40 5 6 7 8\nbond_coeff 2 12 9 4 3 1 1 1 1 0 0 0 0\n";

TEST(LammpsStiffness, GoesToTheBondsByTheirTypesTheLastOneHolds) {
  const Applied applied = apply(std::string("bond_style bpm/rotational smooth no break no\n") + coefficients);
  ASSERT_TRUE(applied.setup);
  const auto& columns = applied.model.bond_columns;
  EXPECT_THAT(columns.at("kn"), ElementsAre(6, 12, 6, 12, 6));
  EXPECT_THAT(columns.at("ks"), ElementsAre(3, 9, 3, 9, 3));
  EXPECT_THAT(columns.at("kt"), ElementsAre(2, 4, 2, 4, 2));
  EXPECT_THAT(columns.at("kb"), ElementsAre(1, 3, 1, 3, 1));
  // In the order of the source: twisting before bending.
  EXPECT_EQ(applied.model.kept_columns.at("strength_twisting")[0], 30);
  EXPECT_EQ(applied.model.kept_columns.at("strength_bending")[0], 40);
  EXPECT_EQ(applied.model.kept_columns.at("damping_twisting")[0], 8);
}

TEST(LammpsStiffness, OfManyTypesTakesTimeInProportion) {
  constexpr Index bonds = 50'000;
  std::string text = "boundary f f f\nbond_style bpm/rotational\nbond_coeff *7 1 1 1 1 1 1 1 1 1 1 1 1\n";
  for (Index type = 5; type <= bonds; ++type)
    text +=
        "bond_coeff " + std::to_string(type) + " " + std::to_string(2 * type) + " 1 1 1 1 1 1 1 1 1 1 1\n";
  text += "bond_coeff 6*8 3 1 1 1 1 1 1 1 1 1 1 1\n";
  const LammpsScript script = sound(text);
  ForeignModel model = row_of_six();
  model.bonds.clear();
  for (Index k = 0; k < bonds; ++k) model.bonds.push_back({k, 1, 2, k + 1});
  std::vector<Fault> faults;
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(apply_script(script, model, faults));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(1));
  const std::vector<double>& kn = model.bond_columns.at("kn");
  EXPECT_EQ(std::vector(kn.begin(), kn.begin() + 9), (std::vector<double>{1, 1, 1, 1, 10, 3, 3, 3, 18}));
  EXPECT_EQ(kn.back(), 2.0 * bonds);
}

TEST(LammpsStiffness, NormalizedIsDividedByTheLength) {
  const Applied applied = apply(std::string("bond_style bpm/rotational normalize yes\n") + coefficients);
  ASSERT_TRUE(applied.setup);
  const auto& columns = applied.model.bond_columns;
  EXPECT_THAT(columns.at("kn"), ElementsAre(6, 12 / 2., 6 / 3., 12 / 4., 6 / 5.));
  EXPECT_THAT(columns.at("ks"), ElementsAre(3, 9 / 2., 3 / 3., 9 / 4., 3 / 5.));
  EXPECT_THAT(columns.at("kt"), ElementsAre(2, 4, 2, 4, 2));
}

TEST(LammpsBoundary, MakesTheBoxOfTheDataFileACell) {
  ForeignModel model = row_of_six();
  std::vector<Fault> faults;
  ASSERT_TRUE(apply_script(sound("boundary p f p\n"), model, faults));
  ASSERT_TRUE(model.cell);
  EXPECT_THAT(model.cell->periodic, ElementsAre(true, false, true));
  EXPECT_EQ(model.cell->edges.col(0), Vector3(20, 0, 0));
  ForeignModel without = row_of_six();
  without.box.reset();
  EXPECT_FALSE(apply_script(sound("boundary p f p\n"), without, faults));
  EXPECT_EQ(faults.size(), 1u);
}

}  // namespace
}  // namespace bondstatic
