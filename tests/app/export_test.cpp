// The command as a process.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/run_program.hpp"

namespace bondstatic::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

/// A beam whose bonds act at mid-length, with two load cases.
std::string two_cases() {
  const std::string beam = cantilever();
  return beam.substr(0, beam.find("[[outputs]]")) + R"(
[[loads]]
case = "up"
at = { id = 11 }
force = [0, 2e5, 0]
[[loads]]
case = "side"
at = { id = 11 }
moment = [0, 1e4, 0]
)";
}

struct ExportRun {
  ScratchFolder folder;
  std::string out = (folder / "out").string();
  Ended ended;

  explicit ExportRun(const std::string& text, std::vector<std::string> arguments) {
    const std::string file = folder.write("case.toml", text);
    arguments.insert(arguments.begin(), {"export", file, "--out", out});
    ended = run_program(arguments);
  }
  std::set<std::string> files() const { return everything_in(out); }
};

TEST(ExportCommand, WritesADeckAndSaysHowToRunAndCompare) {
  const ExportRun run(cantilever(), {"--to", "lammps"});
  ASSERT_EQ(run.ended.code, 0) << run.ended.err;
  EXPECT_EQ(run.files(), (std::set<std::string>{"export.json", "in.lammps", "model.data"}));
  EXPECT_THAT(run.ended.out, HasSubstr("lmp -in in.lammps"));
  EXPECT_THAT(run.ended.out, HasSubstr("bondstatic compare"));
  EXPECT_THAT(run.ended.out, HasSubstr("no density"));
}

TEST(ExportCommand, ListsItsFilesAsJson) {
  const ExportRun run(cantilever(), {"--to", "lammps", "--relaxed", "--json"});
  ASSERT_EQ(run.ended.code, 0) << run.ended.err;
  const Json json = Json::parse(run.ended.out);
  EXPECT_EQ(json["format"], "lammps");
  EXPECT_EQ(json["relaxed"], true);
  std::set<std::string> listed;
  for (const auto& name : json["files"]) listed.insert(name.get<std::string>());
  EXPECT_EQ(listed, run.files());
  EXPECT_TRUE(listed.count("dump.static") && listed.count("relaxed_bonds.csv"));
}

TEST(ExportCommand, ReplacesAnEarlierExportAndNothingElse) {
  ScratchFolder folder;
  const std::string file = folder.write("case.toml", cantilever()), out = (folder / "out").string();
  ASSERT_EQ(run_program({"export", file, "--to", "lammps", "--relaxed", "--out", out}).code, 0);
  ASSERT_EQ(run_program({"export", file, "--to", "csv", "--out", out}).code, 0);
  EXPECT_EQ(everything_in(out),
            (std::set<std::string>{"bonds.csv", "case.toml", "export.json", "particles.csv"}));
  folder.write("out/model.vtu", "mine");
  const Ended refused = run_program({"export", file, "--to", "vtu", "--out", out});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("model.vtu"));
  EXPECT_EQ(read_text(folder / "out" / "model.vtu"), "mine");
  EXPECT_TRUE(everything_in(out).count("case.toml"));
}

TEST(ExportCommand, AnswersAnUnknownFormatWithThoseThatThereAre) {
  const ExportRun run(cantilever(), {"--to", "lamps"});
  EXPECT_EQ(run.ended.code, 2);
  EXPECT_THAT(run.ended.err, HasSubstr("did you mean lammps?"));
  EXPECT_THAT(run.ended.err, HasSubstr("liggghts"));
}

TEST(ExportCommand, AsksWhichOfSeveralLoadCases) {
  const ExportRun undecided(two_cases(), {"--to", "lammps"});
  EXPECT_EQ(undecided.ended.code, 2);
  EXPECT_THAT(undecided.ended.err, HasSubstr("--load-case NAME, one of: up, side"));
  const ExportRun unknown(two_cases(), {"--to", "lammps", "--load-case", "down"});
  EXPECT_EQ(unknown.ended.code, 2);
  const ExportRun side(two_cases(), {"--to", "lammps", "--load-case", "side"});
  ASSERT_EQ(side.ended.code, 0) << side.ended.err;
  const std::string deck = read_text(side.folder / "out" / "in.lammps");
  EXPECT_THAT(deck, HasSubstr("addforce 0 -100000 0"));
  EXPECT_THAT(deck, HasSubstr("addtorque/atom 0 10000 0"));
  EXPECT_THAT(side.ended.out, HasSubstr("dump.final --load-case 'side'"));
  EXPECT_EQ(ExportRun(two_cases(), {"--to", "csv"}).ended.code, 0);
}

TEST(ExportCommand, TakesOverrides) {
  const ExportRun pushed(cantilever(), {"--to", "csv", "--set", "loads.0.force=[0,0.125,0]"});
  ASSERT_EQ(pushed.ended.code, 0) << pushed.ended.err;
  EXPECT_THAT(read_text(pushed.folder / "out" / "case.toml"), HasSubstr("force = [0.0, 0.125, 0.0]"));
}

TEST(ExportCommand, TellsOfAnotherModelOnTheTerminal) {
  const ExportRun run(cantilever(), {"--to", "lammps", "--set", "bonds.0.contact_point=0.3"});
  ASSERT_EQ(run.ended.code, 0) << run.ended.err;
  EXPECT_THAT(run.ended.out, HasSubstr("The exported model is another one:"));
  EXPECT_THAT(run.ended.out, HasSubstr("10 of 10 bonds act at another contact point"));
  EXPECT_THAT(run.ended.out, HasSubstr("dump.final --set 'bonds.0.contact_point=0.3'"));
}

TEST(ExportCommand, AMechanismEndsAsInASolve) {
  const ExportRun run(cantilever(), {"--to", "lammps", "--set", "supports.0.fix=[\"x\"]"});
  EXPECT_EQ(run.ended.code, 3);
  EXPECT_FALSE(std::filesystem::exists(run.out));
}

TEST(ExportCommand, TheRelaxedTableIsAStateThatCompareCanRead) {
  const ExportRun run(cantilever(), {"--to", "csv", "--relaxed"});
  ASSERT_EQ(run.ended.code, 0) << run.ended.err;
  const std::string table = read_text(run.folder / "out" / "relaxed_particles.csv");
  EXPECT_THAT(table.substr(0, table.find('\n')), HasSubstr(",x,y,z,qw,qx,qy,qz"));
  const Ended compared =
      run_program({"compare", (run.folder / "case.toml").string(), run.out + "/relaxed_particles.csv"});
  EXPECT_EQ(compared.code, 0) << compared.out << compared.err;
}

/// Largest displacement that `solve` finds.
double largest_displacement(const std::string& file) {
  const Ended ended = run_program({"solve", file, "--json"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  return Json::parse(ended.out)["load_cases"][0]["largest_displacement"]["magnitude"];
}

TEST(ExportCommand, TheDeckImportedAgainIsTheSameModel) {
  const ExportRun run(cantilever(), {"--to", "lammps"});
  ASSERT_EQ(run.ended.code, 0) << run.ended.err;
  const std::string back = (run.folder / "back").string();
  const Ended import = run_program({"import", run.out + "/in.lammps", "--out", back});
  ASSERT_EQ(import.code, 0) << import.err;
  EXPECT_NEAR(
      largest_displacement(back + "/case.toml") / largest_displacement((run.folder / "case.toml").string()),
      1, 1e-14);
}

std::string read_by_vtk(const std::string& file) {
  const std::string script = BONDSTATIC_SOURCE_DIR "/tests/io/read_vtu.py";
  const Ended read = Program({"-B", script, file}, "/usr/bin/python3").end();
  EXPECT_EQ(read.code, 0) << read.err;
  return read.out;
}

TEST(ExportCommand, VtuDrawsABondAcrossAPeriodicFaceBesideIt) {
  const ExportRun run(R"(
[cell]
size = [4, 4, 4]
[[particles]]
line = { from = [0.5, 2, 2], to = [3.5, 2, 2], count = 2 }
radius = 0.5
[[bonds]]
law = "generic"
contact_radius_factor = 1.1
kn = 1
ks = 1
kt = 1
kb = 1
)",
                      {"--to", "vtu", "--load-case", "xx"});
  ASSERT_EQ(run.ended.code, 0) << run.ended.err;
  const std::string read = read_by_vtk(run.out + "/model.vtu");
  EXPECT_THAT(read, HasSubstr("points 3\n"));
  EXPECT_THAT(read, HasSubstr("cell 0 3 0 2\n"));
  EXPECT_THAT(read, HasSubstr("vtkGhostType 1 0 0 1\n"));
}

TEST(ExportCommand, VtuHasSupportsLoadsAndStiffness) {
  const ExportRun run(cantilever(), {"--to", "vtu"});
  ASSERT_EQ(run.ended.code, 0) << run.ended.err;
  const std::string read = read_by_vtk(run.out + "/model.vtu");
  for (const char* name : {"held_rotation", "load_force", "prescribed_translation", "kb", "contact_point"})
    EXPECT_THAT(read, HasSubstr(name));
}

}  // namespace
}  // namespace bondstatic::test
