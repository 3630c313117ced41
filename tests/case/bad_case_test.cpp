// One slip in a sound case: one fault, at its place, that says what is wrong and how to cure it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/run_program.hpp"
#include "case/slip.hpp"
#include "case/sound_case.hpp"

namespace bondstatic::test {
namespace {

class BadCase : public testing::TestWithParam<Slip> {};

TEST_P(BadCase, IsOneFaultWithPlaceAndCure) {
  const Slip& slip = GetParam();
  expect_told(slip, faults_of(sound_case({{slip.line, slip.replacement}})));
}

TEST_P(BadCase, EndsTheProgramWith2AndLeavesNothing) {
  const ScratchFolder folder;
  const std::string file = folder.write("case.toml", sound_case({{GetParam().line, GetParam().replacement}}));
  const Ended ended = run_program({"solve", file, "--out", (folder / "out").string()});
  EXPECT_EQ(ended.code, int(ExitCode::invalid_input)) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_THAT(ended.err, testing::HasSubstr(":" + std::to_string(GetParam().fault_line) + ":" +
                                            std::to_string(GetParam().fault_column) + ": "));
  EXPECT_THAT(ended.err, testing::HasSubstr("cure: "));
  EXPECT_THAT(everything_in(folder.path()), testing::ElementsAre("case.toml"));
}

const std::vector<Slip> slips{
    // TOML
    {"NoToml", 3, "radius = ", 3, 10, "", "TOML"},
    {"KeyTwice", 3, "radius = 0.2\nradius = 0.3", 4, 10, "", "TOML"},
    {"OpenText", 5, "law = \"timoshenko", 5, 18, "", "TOML"},
    {"NotUtf8", 19, "title = \"\xff\"", 19, 9, "", "TOML"},
    {"DeepLists", 3, "radius = " + std::string(100, '['), 3, 42, "deeper than 32", "flatter"},
    {"DeepTables", 19,
     "[a" +
         [] {
           std::string s;
           for (int i = 0; i < 40; ++i) s += ".a";
           return s;
         }() +
         "]",
     19, 67, "deeper than 32", "flatter"},
    {"DeepKeys", 19,
     "a = { \"a\"" +
         [] {
           std::string s;
           for (int i = 0; i < 40; ++i) s += " . \"a\"";
           return s;
         }() +
         " = 1 }",
     19, 203, "deeper than 32", "flatter"},
    {"TypographicQuotes", 5, "law = “timoshenko”", 5, 7, "beyond ASCII", "quotes"},
    {"NoBreakSpace", 3, "radius = 0.2\u00a0", 3, 13, "beyond ASCII", "no-break spaces"},
    {"AccentInKey", 3, "radius = 0.2\n\"é\" = 1", 4, 2, "beyond ASCII", "accents"},
    {"AccentInChainedKey", 3, "radius = 0.2\na . \"é\" = 1", 4, 6, "beyond ASCII", "accents"},
    {"AccentInHeader", 19, "[\"é\"]", 19, 3, "beyond ASCII", "accents"},
    {"AccentBehindBackslash", 1, "title = \"\"\"a\\\n  é\"\"\"\n[[particles]]", 2, 3, "beyond ASCII",
     "accents"},
    // names
    {"UnknownBlock", 19, "[[bond]]", 19, 3, "unknown key \"bond\"", "\"bonds\""},
    {"UnknownKey", 3, "radius = 0.2\nradios = 0.2", 4, 1, "unknown key \"radios\" in [[particles]]",
     "\"radius\""},
    {"UnknownKeyInside", 10, "at = { id = 1, grup = \"a\" }", 10, 16, "unknown key \"grup\" in at",
     "\"group\""},
    {"UnknownKeyFarOff", 3, "radius = 0.2\nzzzzzzzz = 1", 4, 1, "unknown key \"zzzzzzzz\"", "known here"},
    {"SingleBrackets", 15, "[outputs]", 15, 1, "not a list of tables", "[[outputs]]"},
    {"MemberOfLastBlock", 19, "groups = [1, 2]", 19, 1, "unknown key \"groups\" in [[outputs]]",
     "known here"},
    // particles
    {"RadiusNegative", 3, "radius = -0.2", 3, 10, "radius = -0.2 must be positive", "radius = NUMBER"},
    {"RadiusZero", 3, "radius = 0", 3, 10, "radius = 0 must be positive", "radius"},
    {"RadiusNan", 3, "radius = nan", 3, 10, "must be finite", "radius"},
    {"RadiusInfinite", 3, "radius = inf", 3, 10, "must be finite", "radius"},
    {"RadiusTruth", 3, "radius = true", 3, 10, "radius = true must be a number", "radius"},
    {"RadiusDate", 3, "radius = 2024-01-01", 3, 10, "must be a number", "radius"},
    {"RadiusUnit", 3, "radius = \"2 kg\"", 3, 10, "\"kg\" is not of this dimension; a length is wanted",
     "\"NUMBER m\""},
    {"RadiusUnknownUnit", 3, "radius = \"2 furlong\"", 3, 10, "unknown unit \"furlong\"", "\"NUMBER m\""},
    {"RadiusNoNumber", 3, "radius = \"thick\"", 3, 10, "no number found", "radius"},
    {"RadiusMissing", 3, "", 1, 1, "[[particles]] needs radius", "add radius"},
    {"NoGenerator", 2, "", 1, 1, "needs one of: line, arc, helix, lattice, file", "add line"},
    {"TwoGenerators", 2, "line = { from = [0, 0, 0], to = [4, 0, 0], count = 11 }\nfile = \"a.csv\"", 3, 8,
     "line, file: they exclude each other", "keep one"},
    {"LineIsNumber", 2, "line = 3", 2, 8, "line = 3 must be a table", "{"},
    {"LineWithoutCount", 2, "line = { from = [0, 0, 0], to = [4, 0, 0] }", 2, 8, "line needs count",
     "add count"},
    {"LineCountOne", 2, "line = { from = [0, 0, 0], to = [4, 0, 0], count = 1 }", 2, 52, "at least 2",
     "count"},
    {"LineCountBroken", 2, "line = { from = [0, 0, 0], to = [4, 0, 0], count = 2.5 }", 2, 52, "whole number",
     "count"},
    {"LineCountHuge", 2, "line = { from = [0, 0, 0], to = [4, 0, 0], count = 1000000000000 }", 2, 52,
     "at most 200000000", "lower"},
    {"LineOfOnePoint", 2, "line = { from = [1, 0, 0], to = [1, 0, 0], count = 3 }", 2, 33, "in one point",
     "length"},
    {"LineToAndStep", 2, "line = { from = [0, 0, 0], to = [4, 0, 0], step = [1, 0, 0], count = 11 }", 2, 51,
     "exclude each other", "keep one"},
    {"VectorOfTwo", 2, "line = { from = [0, 0], to = [4, 0, 0], count = 11 }", 2, 17, "list of three numbers",
     "[X, Y, Z]"},
    {"VectorOfText", 2, "line = { from = [0, 0, \"a\"], to = [4, 0, 0], count = 11 }", 2, 24, "from[2]",
     "from[2]"},
    {"LatticeKind", 2, "lattice = { kind = \"bbc\", count = [2, 2, 3], spacing = 0.4 }", 2, 20,
     "kind = \"bbc\" must be one of: simple-cubic, bcc, fcc", "\"bcc\""},
    {"LatticeOverflow", 2,
     "lattice = { kind = \"fcc\", count = [9000000000, 9000000000, 9000000000], spacing = 1 }", 2, 35,
     "particles, at most", "lower"},
    {"LatticeCountZero", 2, "lattice = { kind = \"fcc\", count = [2, 0, 3], spacing = 0.4 }", 2, 39,
     "count[1] = 0", "count"},
    {"ArcStartAlongAxis", 2, "arc = { radius = 1, start = [0, 0, 2], turns = 1, count = 11 }", 2, 29,
     "along the axis", "across"},
    {"ArcOverItself", 2, "arc = { radius = 1, turns = 2, count = 11 }", 2, 29, "runs over itself", "helix"},
    {"HelixWithoutPitch", 2, "helix = { radius = 1, turns = 2, count = 11 }", 2, 9, "helix needs pitch",
     "pitch"},
    {"RemovalOfAll", 3, "radius = 0.2\nremoval = 1", 4, 11, "removal = 1 must be below 1", "part"},
    {"RemovalLeavesNone", 3, "radius = 0.2\nremoval = 0.999", 4, 11, "leaves no particle", "lower"},
    {"JitterTwice", 3, "radius = 0.2\njitter = 0.1\njitter_length = 0.1", 5, 17, "exclude each other",
     "keep one"},
    {"DensityNegative", 3, "radius = 0.2\ndensity = -1", 4, 11, "density = -1 must be positive", "kg/m3"},
    {"FileMissing", 2, "file = \"none.csv\"", 2, 8, "does not exist", "relative"},
    {"FileIsFolder", 2, "file = \".\"", 2, 8, "is a folder", "text file"},
    {"FileIsDevice", 2, "file = \"/dev/zero\"", 2, 8, "is a device", "text file"},
    {"FileIsNumber", 2, "file = 3", 2, 8, "file = 3 must be a text", "quotes"},
    {"FileNameEmpty", 2, "file = \"\"", 2, 8, "is a folder", "text file"},
    {"FileNameNul", 2, "file = \"a\\u0000b\"", 2, 8, "no file name", "path"},
    // groups
    {"GroupUnknown", 10, "at = { group = \"top\" }", 10, 16, "there is no group \"top\"", "[[groups]]"},
    {"GroupTwice", 19, "[[groups]]\nname = \"a\"\nat = { id = 1 }\n[[groups]]\nname = \"a\"\nat = { id = 2 }",
     23, 8, "there is a group \"a\" already", "another name"},
    {"GroupNearName", 3,
     "radius = 0.2\ngroup = \"bottom\"\n[[groups]]\nname = \"b\"\nat = { group = \"botom\" }", 7, 16,
     "there is no group \"botom\"", "\"bottom\""},
    // bonds
    {"LawMissing", 5, "", 4, 1, "[[bonds]] needs law", "timoshenko"},
    {"LawUnknown", 5, "law = \"timoschenko\"", 5, 7, "law = \"timoschenko\" is unknown", "\"timoshenko\""},
    {"YoungNegative", 6, "young = -5", 6, 9, "young = -5: must be positive", "Pa"},
    {"YoungMissing", 6, "", 4, 1, "young missing", "bondstatic laws timoshenko"},
    {"YoungDimension", 6, "young = \"5 m\"", 6, 9, "a stress is wanted", "\"NUMBER Pa\""},
    {"PoissonAbove", 7, "poisson = 0.51", 7, 11, "poisson = 0.51: must be greater than -1 and at most 0.5",
     "bondstatic laws"},
    {"PoissonMinusOne", 7, "poisson = -1", 7, 11, "poisson = -1", "bondstatic laws"},
    {"RadiusAndFactor", 8, "radius = 0.2\nradius_factor = 1", 8, 10, "exclude each other", "bondstatic laws"},
    {"ParameterOfOtherLaw", 8, "radius = 0.2\nkappa = 2", 9, 1, "unknown key \"kappa\" in [[bonds]]",
     "known here"},
    {"GapAndFactor", 8, "radius = 0.2\ngap = 0\ncontact_radius_factor = 1.1", 10, 25, "exclude each other",
     "keep one"},
    {"FactorZero", 8, "radius = 0.2\ncontact_radius_factor = 0", 9, 25, "must be positive",
     "contact_radius_factor"},
    {"NoBondForms", 8, "radius = 0.2\ncontact_radius_factor = 0.9", 4, 1, "forms no bond", "raise gap"},
    {"BetweenThree", 8, "radius = 0.2\nbetween = [\"a\", \"b\", \"c\"]", 9, 11, "names 3 groups", "between"},
    {"BetweenUnknown", 8, "radius = 0.2\nbetween = [\"a\"]", 9, 11, "there is no group \"a\"", "group"},
    {"ContactPointOutside", 8, "radius = 0.2\ncontact_point = 1.5", 9, 17, "between 0 and 1", "0.5"},
    {"ContactPointName", 8, "radius = 0.2\ncontact_point = \"baem\"", 9, 17,
     "one of: gap, beam, contact-radii", "\"beam\""},
    {"ContactRadiiWithoutFactor", 8, "radius = 0.2\ncontact_point = \"contact-radii\"", 4, 1,
     "needs contact_radius_factor", "add contact_radius_factor"},
    {"ExistingName", 8, "radius = 0.2\nexisting = \"ad\"", 9, 12, "one of: error, add, skip", "\"add\""},
    // supports
    {"SelectorMissing", 10, "", 9, 1, "[[supports]] needs at", "add at"},
    {"SelectorEmpty", 10, "at = {}", 10, 6, "at is empty", "id, group, box"},
    {"SelectorText", 10, "at = \"all\"", 10, 6, "at = \"all\" must be a table", "{"},
    {"SelectsNothing", 10, "at = { sphere = { centre = [9, 9, 9], radius = 1 } }", 10, 6,
     "selects no particle", "check"},
    {"IdUnknown", 10, "at = { id = 12 }", 10, 13, "there is no particle 12", "11 particles"},
    {"IdNegative", 10, "at = { id = -1 }", 10, 13, "at least 0", "id"},
    {"IdInListUnknown", 10, "at = { id = [1, 99] }", 10, 17, "there is no particle 99", "check the id"},
    {"BoxUpsideDown", 10, "at = { box = { min = [1, 0, 0], max = [0, 1, 1] } }", 10, 39, "max is below min",
     "swap"},
    {"BoxNan", 10, "at = { box = { min = [nan, 0, 0] } }", 10, 23, "must be finite", "min[0]"},
    {"NormalZero", 10, "at = { plane = { point = [1, 0, 0], normal = [0, 0, 0] } }", 10, 46, "zero vector",
     "[0, 0, 1]"},
    {"LowestAxis", 10, "at = { lowest = { axis = \"w\", within = 1 } }", 10, 26, "\"x\", \"y\", \"z\"",
     "axis"},
    {"LowestWithout", 10, "at = { lowest = { axis = \"z\" } }", 10, 17, "needs within", "within"},
    {"AllFalse", 10, "at = { all = false }", 10, 14, "selects nothing", "leave it out"},
    {"FixNothing", 11, "", 9, 1, "[[supports]] needs fix", "\"all\""},
    {"FixUnknown", 11, "fix = [\"x\", \"u\"]", 11, 7, "\"u\" is no degree of freedom", "rz"},
    {"FixEmpty", 11, "fix = []", 11, 7, "fix is empty", "remove"},
    {"ValueUnit", 11, "values = { x = \"1 N\" }", 11, 16, "a length is wanted", "m"},
    {"ValueUnknown", 11, "values = { q = 1 }", 11, 12, "unknown key \"q\" in values", "known here"},
    {"Contradiction", 19, "[[supports]]\nat = { id = 1 }\nvalues = { y = 1e-3 }", 19, 1,
     "particle 1: y is prescribed 0.001", "once"},
    // loads
    {"LoadOfNothing", 14, "", 12, 1, "[[loads]] needs force", "gravity"},
    {"ForceTwice", 14, "force = [0, 0, 1]\ntotal_force = [0, 0, 1]", 15, 15, "exclude each other",
     "keep one"},
    {"ForceDimension", 14, "force = [0, 0, \"1 kN m\"]", 14, 16, "a force is wanted", "N"},
    {"GravityWithoutDensity", 19, "[[loads]]\ngravity = [0, 0, -9.81]", 20, 11, "no particle has a density",
     "density"},
    {"GravityOnLight", 19, "[[loads]]\nat = { id = 3 }\ngravity = [0, 0, -9.81]", 21, 11,
     "particle 3, which has no density", "density"},
    {"CaseNoFolder", 14, "force = [0, 0, 1]\ncase = \"a/b\"", 15, 8, "cannot name a folder", "letters"},
    {"SolverUnknown", 19, "[solve]\nsolver = \"eigne\"", 20, 10, "one of: auto, ", "\"eigen\""},
    // outputs
    {"OutputNameless", 16, "", 15, 1, "[[outputs]] needs name", "name"},
    {"OutputTwice", 19, "[[outputs]]\nname = \"tip\"\nof = \"energy\"", 20, 8,
     "there is an output \"tip\" already", "own"},
    {"QuantityUnknown", 17, "of = \"uw\"", 17, 6, "of = \"uw\" is no quantity; there are:", ""},
    {"QuantityMissing", 17, "", 15, 1, "[[outputs]] needs of", "uy"},
    {"ManyForOneValue", 18, "at = { all = true }", 18, 6, "one value, but at selects 11", "reduce"},
    {"ReduceName", 18, "at = { all = true }\nreduce = \"avg\"", 19, 10, "one of: value, sum, mean, max",
     "reduce"},
    {"CaseOfOutput", 18, "at = { id = 11 }\ncase = \"b\"", 19, 8, "there is no load case \"b\"", "remove"},
    {"ExpectedText", 18, "at = { id = 11 }\nexpected = \"-8 mm\"", 19, 12, "expected", "NUMBER"},
    {"ToleranceZero", 18, "at = { id = 11 }\ntolerance = 0", 19, 13, "must be positive", "tolerance"},
    {"WholeModelAt", 17, "of = \"work\"", 18, 6, "quantity of the whole model", "remove at"},
    {"BondUnknown", 19, "[[outputs]]\nname = \"s\"\nof = \"sigma\"\nat = { bond = 11 }", 22, 15,
     "there is no bond 11", "10 bonds"},
    {"BondByParticle", 19, "[[outputs]]\nname = \"s\"\nof = \"sigma\"\nat = { id = 1 }", 22, 8,
     "unknown key \"id\" in at of a bond quantity", "bond"},
    {"PlatenMissing", 17, "of = \"apparent_young\"", 15, 1, "[[outputs]] needs base", "add base"},
    {"MiddleEmpty", 17, "of = \"apparent_poisson\"\nbase = { id = 10 }\naxis = \"x\"", 15, 1,
     "no centre lies in the middle third", "add middle"},
    {"MiddleOfYoung", 17, "of = \"apparent_young\"\nbase = { id = 1 }\nmiddle = { all = true }", 19, 1,
     "unknown key \"middle\"", ""},
    // solve
    {"ToleranceOfSolve", 19, "[solve]\ntolerance = -1", 20, 13, "must be positive", "tolerance"},
    {"Unsupported", 19, "[solve]\nunsupported = \"dorp\"", 20, 15, "one of: error, drop", "\"drop\""},
    {"Memory", 19, "[solve]\nmemory_limit = \"8 apples\"", 20, 16, "no amount of memory", "8 GB"},
    {"Threads", 19, "[solve]\nthreads = -1", 20, 11, "at least 0", "threads"},
    {"ThreadsMany", 19, "[solve]\nthreads = 100000", 20, 11, "at most 4096", "threads = 0"},
    {"SolveIsList", 19, "[[solve]]\nthreads = 1", 19, 1, "must be a table", "{"},
    {"TitleIsNumber", 1, "title = 3\n[[particles]]", 1, 9, "title = 3 must be a text", "quotes"},
};

INSTANTIATE_TEST_SUITE_P(Slips, BadCase, testing::ValuesIn(slips),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace bondstatic::test
