#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bondstatic/error.hpp"
#include "bondstatic/results.hpp"
#include "io/scratch_folder.hpp"
#include "results/hand_made.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::everything_in;
using test::read_text;
using test::ScratchFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using testing::UnorderedElementsAre;

struct Written {
  Model model = test::hand_made_model();
  RunInfo info{"a title", "case.toml", "title = \"a title\"\n", true, {"careful"}};
  StaticSolution solution;
  std::vector<OutputValue> outputs;

  explicit Written(std::vector<std::string> load_cases) {
    model.load_cases = std::move(load_cases);
    for (const std::string& name : model.load_cases) solution.cases.push_back(test::hand_made_result(name));
    solution.report.solver = "by hand";
    solution.report.dropped = {{99}};
    solution.report.phases = {{"solve", 0.5}};
    outputs.push_back({"pull", 0.03, 0.02, 1e-9, "a book"});
    outputs.push_back({"free", not_given, std::nullopt, 1e-9, ""});
  }

  void write(const fs::path& folder) const { write_results(model, info, solution, outputs, folder.string()); }
};

TEST(Results, OneLoadCaseLiesInTheFolderItself) {
  const ScratchFolder scratch;
  Written({""}).write(scratch / "out");
  EXPECT_THAT(
      everything_in(scratch / "out"),
      UnorderedElementsAre("summary.json", "particles.csv", "bonds.csv", "model.vtu", "case.resolved.toml"));
  EXPECT_EQ(read_text(scratch / "out/case.resolved.toml"), "title = \"a title\"\n");
}

TEST(Results, TablesHaveThePromisedColumnsAndEmptyFieldsForWhatWasLeftOut) {
  const ScratchFolder scratch;
  Written({""}).write(scratch / "out");
  EXPECT_EQ(read_text(scratch / "out/particles.csv"),
            "id,x,y,z,radius,ux,uy,uz,rx,ry,rz,reaction_fx,reaction_fy,reaction_fz,reaction_mx,reaction_my,"
            "reaction_mz\n"
            "10,0,0,0,1,0,0,0,0,0,0,0,0,-6,0,1,0\n"
            "20,0,0,2,1.5,0,0,0.01,0,0,0,0,0,0,0,0,0\n"
            "30,0,0,4,1,0.04,0,0.03,0,0.3,0.4,0,0,0,0,0,0\n"
            "99,50,0,6,1,,,,,,,,,,,,\n");
  EXPECT_EQ(
      read_text(scratch / "out/bonds.csv"),
      "id,a,b,fx,fy,fz,mx,my,mz,normal_force,shear_force,twisting_moment,bending_moment,sigma,tau,energy\n"
      "1,10,20,0,0,-6,0,0,0,6,0,0,0,0.1,,0.25\n"
      "2,20,30,0,0,0,0,0,0,5,0,0,0,,,0.5\n");
}

TEST(Results, SummarySaysAll) {
  const Written run({""});
  const auto summary = nlohmann::json::parse(
      summary_json(run.model, run.info, run.solution, run.outputs, result_files(run.model)));
  EXPECT_EQ(summary["title"], "a title");
  EXPECT_EQ(summary["units"], "SI");
  EXPECT_EQ(summary["counts"]["particles"], 4);
  EXPECT_EQ(summary["counts"]["bonds_by_law"]["generic"], 2);
  EXPECT_EQ(summary["counts"]["supported_particles"], 1);
  EXPECT_EQ(summary["solver"]["name"], "by hand");
  EXPECT_EQ(summary["dropped"], nlohmann::json::parse("[[99]]"));
  EXPECT_EQ(summary["warnings"], nlohmann::json::parse("[\"careful\"]"));
  EXPECT_EQ(summary["load_cases"][0]["largest_displacement"]["particle"], 30);
  EXPECT_DOUBLE_EQ(summary["load_cases"][0]["largest_displacement"]["magnitude"].get<double>(), 0.05);
  EXPECT_EQ(summary["load_cases"][0]["energy"], 0.75);
  EXPECT_EQ(summary["outputs"][0]["value"], 0.03);
  EXPECT_EQ(summary["outputs"][0]["expected"], 0.02);
  EXPECT_DOUBLE_EQ(summary["outputs"][0]["relative_error"].get<double>(), 0.5);
  EXPECT_EQ(summary["outputs"][0]["source"], "a book");
  EXPECT_TRUE(summary["outputs"][1]["value"].is_null());
  EXPECT_FALSE(summary["outputs"][1].contains("expected"));
  EXPECT_EQ(summary["phases"][0]["name"], "solve");
  for (const char* key :
       {"backward_error", "forward_error", "force_balance", "moment_balance", "energy_balance"})
    EXPECT_TRUE(summary["accuracy"][key].is_number()) << key;
  EXPECT_EQ(summary["files"].back(), "summary.json");
}

TEST(Results, TitleThatIsNoUtf8StillMakesJson) {
  Written run({""});
  run.info.title = "caf\xe9";
  EXPECT_TRUE(nlohmann::json::accept(summary_json(run.model, run.info, run.solution, {}, {})));
}

TEST(Results, SeveralLoadCasesHaveAFolderEach) {
  const ScratchFolder scratch;
  const Written run({"push", "../shear"});
  run.write(scratch / "out");
  EXPECT_THAT(everything_in(scratch.path()),
              UnorderedElementsAre("out", "out/summary.json", "out/case.resolved.toml", "out/push",
                                   "out/push/particles.csv", "out/push/bonds.csv", "out/push/model.vtu",
                                   "out/%2E.%2Fshear", "out/%2E.%2Fshear/particles.csv",
                                   "out/%2E.%2Fshear/bonds.csv", "out/%2E.%2Fshear/model.vtu"));
}

TEST(Results, RemoveWhatAnEarlierRunWroteAndThisOneDoesNot) {
  const ScratchFolder scratch;
  Written({"push", "pull"}).write(scratch / "out");
  scratch.write("out/notes.txt", "mine");
  scratch.write("out/pull/picture.svg", "mine");
  Written({"pull", "twist"}).write(scratch / "out");
  EXPECT_FALSE(fs::exists(scratch / "out/push"));
  Written({""}).write(scratch / "out");
  EXPECT_THAT(everything_in(scratch / "out"),
              UnorderedElementsAre("summary.json", "particles.csv", "bonds.csv", "model.vtu",
                                   "case.resolved.toml", "notes.txt", "pull", "pull/picture.svg"));
}

TEST(Results, RemoveNothingOutsideOfTheirFolderWhateverASummarySays) {
  const ScratchFolder scratch;
  scratch.write("precious", "mine");
  fs::create_directory(scratch / "out");
  scratch.write("out/summary.json", R"({"bondstatic": "0", "files": ["../precious", ")" +
                                        (scratch / "precious").string() + R"(", "summary.json", 7]})");
  Written({""}).write(scratch / "out");
  EXPECT_EQ(read_text(scratch / "precious"), "mine");
}

TEST(Results, DoNotReplaceFilesOfTheUser) {
  const ScratchFolder scratch;
  scratch.write("bonds.csv", "id,a,b\n");
  const Written run({""});
  EXPECT_THROW(check_result_folder(run.model, scratch.path().string()), Error);
  EXPECT_THROW(run.write(scratch.path()), Error);
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("bonds.csv"));
  EXPECT_EQ(read_text(scratch / "bonds.csv"), "id,a,b\n");
}

TEST(Results, VtuNamesAllColumns) {
  const ScratchFolder scratch;
  Written({""}).write(scratch / "out");
  const std::string vtu = read_text(scratch / "out/model.vtu");
  for (const char* name : {"id",
                           "radius",
                           "displacement",
                           "rotation",
                           "reaction_force",
                           "reaction_moment",
                           "fixed",
                           "applied_force",
                           "applied_moment",
                           "a",
                           "b",
                           "fx",
                           "mz",
                           "normal_force",
                           "shear_force",
                           "twisting_moment",
                           "bending_moment",
                           "sigma",
                           "tau",
                           "energy"})
    EXPECT_THAT(vtu, HasSubstr("Name=\"" + std::string(name) + "\""));
}

}  // namespace
}  // namespace bondstatic
