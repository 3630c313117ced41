// `bondstatic import` as users run it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/run_program.hpp"

namespace bondstatic::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

const std::string lammps_case = BONDSTATIC_SOURCE_DIR "/cases/lammps-bpm";

/// Three spheres in a row, two bonds, in the style bpm/sphere.
std::string small_data() {
  return "three spheres\n\n3 atoms\n2 bonds\n2 atom types\n1 bond types\n\n"
         "-1 6 xlo xhi\n-2 2 ylo yhi\n-2 2 zlo zhi\n\nAtoms # bpm/sphere\n\n"
         "1 1 1 2 2500 0 0 0\n2 1 1 2 2500 2 0 0\n3 1 2 2 2500 4 0 0\n\nBonds\n\n1 1 1 2\n2 1 2 3\n";
}

std::string small_script(const std::string& more = "") {
  return "units si\natom_style bpm/sphere\nboundary f f f\nread_data three.data\n"
         "bond_style bpm/rotational break no smooth no\nbond_coeff 1 1e6 4e5 5 8 1 1 1 1 0 0 0 0\n"
         "group low id 1\ngroup top type 2\nfix 1 low freeze\nfix 2 top addforce 0 0.25 0\n" +
         more;
}

/// The answer of a case as summary.json, without what differs from run to run.
nlohmann::json solved(const std::string& case_file, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"solve", case_file, "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Ended ended = run_program(arguments);
  EXPECT_EQ(ended.code, 0) << ended.err;
  return nlohmann::json::parse(ended.out, nullptr, false);
}

TEST(Import, OfTheLammpsRunAnswersAsTheCaseOfTheSameModelDoes) {
  const ScratchFolder scratch;
  const std::string out = (scratch / "d").string();
  const Ended ended =
      run_program({"import", lammps_case + "/packing.data", lammps_case + "/in.lammps", "--out", out});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(everything_in(out), UnorderedElementsAre("case.toml", "particles.csv", "bonds.csv"));
  for (const char* said : {"2068 particles, 6271 bonds", "SI units", "taken", "assumed", "left out",
                           "written", "1 body connected by bonds", "6.06 a particle"})
    EXPECT_THAT(ended.out, HasSubstr(said));
  const std::string imported = (scratch / "imported").string(), direct = (scratch / "direct").string();
  // Of one solver the bits are the same, whatever the machine has to spare.
  solved(out + "/case.toml", {"--out", imported, "--solver", "cholmod"});
  solved(lammps_case + "/case.toml", {"--out", direct, "--solver", "cholmod"});
  for (const char* table : {"particles.csv", "bonds.csv"})
    EXPECT_EQ(read_text(imported + "/" + table), read_text(direct + "/" + table)) << table;
}

TEST(Import, WithAScriptAloneReadsTheFileThatItNames) {
  const ScratchFolder scratch;
  scratch.write("three.data", small_data());
  const Ended ended =
      run_program({"import", scratch.write("in.three", small_script()), "--out", (scratch / "d").string()});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const std::string text = read_text(scratch / "d/case.toml");
  for (const char* line : {"name = \"top\"", "at = { group = [\"type 2\"] }", "at = { id = [1] }",
                           "fix = \"all\"", "force = [0.0, 0.25, 0.0]", "law = \"generic\""})
    EXPECT_THAT(text, HasSubstr(line));
  EXPECT_THAT(text, Not(HasSubstr("FILL IN")));
  EXPECT_EQ(read_text(scratch / "d/bonds.csv").substr(0, 33), "id,a,b,kn,ks,kt,kb,damping_bendin");
  // A cantilever of two bonds: u = F (1/ks + 1/ks) + F (1^2 + 3^2) / kb at mid-length contact points.
  const Ended solve =
      run_program({"solve", (scratch / "d/case.toml").string(), "--out", (scratch / "r").string()});
  ASSERT_EQ(solve.code, 0) << solve.err;
  const std::string table = read_text(scratch / "r/particles.csv");
  const std::string last = table.substr(table.find("\n3,") + 1);
  std::vector<double> numbers;
  std::istringstream fields(last);
  for (std::string field; std::getline(fields, field, ',');) numbers.push_back(std::stod(field));
  const double deflection = 0.25 * (2 / 4e5 + (1 + 9) / 8.);
  EXPECT_NEAR(numbers.at(6), deflection, 1e-15 * deflection);
}

TEST(Import, ADataFileIsOneUnderAnyName) {
  const ScratchFolder scratch;
  scratch.write("three.lmp", small_data());
  scratch.write("in.three", small_script());
  const Ended ended = run_program({"import", (scratch / "three.lmp").string(),
                                   (scratch / "in.three").string(), "--out", (scratch / "d").string()});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("3 particles, 2 bonds"));
}

TEST(Import, OfBondsWithoutStiffnessAsksForItInTheCase) {
  const ScratchFolder scratch;
  const std::string data = scratch.write("three.data", small_data()), out = (scratch / "d").string();
  const Ended ended = run_program({"import", data, "--out", out});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("the stiffness of the bonds (kn, ks, kt, kb)"));
  EXPECT_THAT(read_text(scratch / "d/case.toml"), HasSubstr("# FILL IN"));
  const Ended solve = run_program({"solve", out + "/case.toml"});
  EXPECT_EQ(solve.code, 2);
  for (const char* name : {"kn", "ks", "kt", "kb"}) EXPECT_THAT(solve.err, HasSubstr(name));
  const Ended filled = run_program({"solve", out + "/case.toml", "--set", "bonds.0.kn=1e6", "--set",
                                    "bonds.0.ks=1e6", "--set", "bonds.0.kt=1", "--set", "bonds.0.kb=1",
                                    "--set", "supports=[{ at = { id = 1 }, fix = \"all\" }]"});
  EXPECT_EQ(filled.code, 0) << filled.err;
}

TEST(Import, JsonTellsTheSame) {
  const ScratchFolder scratch;
  const std::string data = scratch.write("three.data", small_data());
  const Ended ended = run_program({"import", data, "--out", (scratch / "d").string(), "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out);
  EXPECT_EQ(json["particles"], 3);
  EXPECT_EQ(json["bonds"], 2);
  EXPECT_EQ(json["largest_radius"], 1);
  EXPECT_EQ(json["bodies"], 1);
  EXPECT_EQ(json["highest"][0], 4);
  EXPECT_DOUBLE_EQ(json["coordination"], 4. / 3);
  EXPECT_EQ(json["written"].size(), 3u);
  EXPECT_EQ(json["to_be_filled_in"].size(), 3u);
  EXPECT_TRUE(json["cell"].is_null());
}

TEST(Import, WritesACellWhereTheScriptSaysThatTheBoxRepeats) {
  const ScratchFolder scratch;
  scratch.write("three.data", small_data());
  const Ended ended = run_program({"import", scratch.write("in.three", small_script() + "boundary p p f\n"),
                                   "--out", (scratch / "d").string(), "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(nlohmann::json::parse(ended.out)["cell"],
            nlohmann::json::parse(R"({"edges": [[7, 0, 0], [0, 4, 0], [0, 0, 4]], "origin": [-1, -2, -2],
                                      "periodic": ["x", "y"]})"));
  EXPECT_THAT(read_text(scratch / "d/case.toml"),
              HasSubstr("[cell]\nedges = [[7.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]]\n"
                        "origin = [-1.0, -2.0, -2.0]\nperiodic = [\"x\", \"y\"]\n"));
}

TEST(Import, ReplacesAnEarlierImportButNothingElse) {
  const ScratchFolder scratch;
  scratch.write("three.data", small_data());
  const std::string script = scratch.write("in.three", small_script()), out = (scratch / "d").string();
  ASSERT_EQ(run_program({"import", script, "--out", out}).code, 0);
  ASSERT_EQ(run_program({"import", script, "--out", out}).code, 0);
  const std::string text = read_text(out + "/case.toml");
  std::ofstream(out + "/case.toml") << text << "# mine\n";
  const Ended edited = run_program({"import", script, "--out", out});
  EXPECT_EQ(edited.code, 2);
  EXPECT_THAT(edited.err, HasSubstr("was changed after its import"));
  EXPECT_EQ(read_text(out + "/case.toml"), text + "# mine\n");

  std::filesystem::create_directory(scratch / "other");
  scratch.write("other/bonds.csv", "mine\n");
  const Ended other = run_program({"import", script, "--out", (scratch / "other").string()});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(everything_in(scratch / "other"), UnorderedElementsAre("bonds.csv"));
}

struct Faulty {
  const char* name;
  const char* file;
  std::string text;
  const char* said;
};

class FaultyImport : public testing::TestWithParam<Faulty> {};

TEST_P(FaultyImport, EndsWithFileLineAndCureAndLeavesNothing) {
  const Faulty& row = GetParam();
  const ScratchFolder scratch;
  scratch.write("three.data", small_data());
  const std::string file = scratch.write(row.file, row.text);
  const Ended ended = run_program({"import", file, "--out", (scratch / "d").string()});
  EXPECT_EQ(ended.code, 2) << ended.out;
  EXPECT_THAT(ended.err, HasSubstr(row.said));
  EXPECT_THAT(ended.err, HasSubstr("cure:"));
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_FALSE(std::filesystem::exists(scratch / "d"));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

const Faulty faulty[] = {
    {"UnknownParticle", "x.data", replaced(small_data(), "2 1 2 3", "2 1 2 4"), "x.data:21:"},
    {"SelfBond", "x.data", replaced(small_data(), "2 1 2 3", "2 1 3 3"), "x.data:21:"},
    {"ParticleTwice", "x.data", replaced(small_data(), "\n3 1 2", "\n2 1 2"), "x.data:16:"},
    {"NegativeDiameter", "x.data", replaced(small_data(), "3 1 2 2 ", "3 1 2 -2 "), "x.data:16:"},
    {"NotFinite", "x.data", replaced(small_data(), "2500 4 0", "2500 nan 0"), "x.data:16:"},
    {"ScriptAtFault", "in.x", replaced(small_script(), "1e6 4e5", "1e6 ${ks}"), "in.x:6:"},
    {"NoSuchGroup", "in.x", replaced(small_script(), "fix 2 top", "fix 2 tip"),
     "in.x:10:7: there is no group tip"},
    {"NoDataFile", "in.x", replaced(small_script(), "three.data", "four.data"), "four.data"},
    {"NoPacking", "in.x", "units si\n", "the script reads no data file"},
    {"NothingInIt", "empty.csv", "", "empty.csv"},
};

INSTANTIATE_TEST_SUITE_P(All, FaultyImport, testing::ValuesIn(faulty),
                         [](const auto& row) { return row.param.name; });

TEST(Import, JoinsParticlesAndBondsOfSeveralFiles) {
  const ScratchFolder scratch;
  const std::string low = scratch.write("low.csv", "id,x,y,z,radius\n1,0,0,0,1\n2,2,0,0,1\n");
  const std::string high = scratch.write("high.csv", "id,x,y,z,radius\n7,4,0,0,1\n");
  const std::string bonds = scratch.write(
      "pairs.csv",
      "a,b,kn,ks,kt,kb,contact_point\n1,2,1e6,1e6,1,1,0.25\n2,7,2e6,1e6,1,1,0.5\n2,7,2e6,1e6,1,1,0.5\n");
  const std::string out = (scratch / "d").string();
  const Ended ended = run_program({"import", bonds, low, high, "--out", out});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("3 particles, 3 bonds"));
  EXPECT_THAT(ended.out, HasSubstr("bonded already"));
  EXPECT_EQ(
      read_text(out + "/bonds.csv"),
      "id,a,b,kn,ks,kt,kb,contact_point\n1,1,2,1000000,1000000,1,1,0.25\n2,2,7,2000000,1000000,1,1,0.5\n"
      "3,2,7,2000000,1000000,1,1,0.5\n");
  const auto answer =
      solved(out + "/case.toml", {"--set", "supports=[{ at = { id = 1 }, fix = \"all\" }]", "--set",
                                  "loads=[{ at = { id = 7 }, force = [1, 0, 0] }]", "--set",
                                  "outputs=[{ name = \"u\", of = \"ux\", at = { id = 7 } }]"});
  EXPECT_NEAR(answer["outputs"][0]["value"], 1e-6 + 0.25e-6, 1e-21);

  const Ended clash = run_program({"import", low, low, "--out", (scratch / "e").string()});
  EXPECT_EQ(clash.code, 2);
  EXPECT_THAT(clash.err, HasSubstr("particle id 1 is there twice"));
  const Ended alone = run_program({"import", bonds, "--out", (scratch / "e").string()});
  EXPECT_EQ(alone.code, 2);
}

}  // namespace
}  // namespace bondstatic::test
