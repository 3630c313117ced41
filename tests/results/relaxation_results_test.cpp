// Files and JSON of a run to rest, from values made by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "bondstatic/error.hpp"
#include "bondstatic/results.hpp"
#include "io/scratch_folder.hpp"
#include "results/given_up.hpp"
#include "results/hand_made.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::everything_in;
using test::read_text;
using test::ScratchFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

constexpr double infinity = std::numeric_limits<double>::infinity();

RelaxedCase hand_made_run(const std::string& name) {
  RelaxedCase run;
  run.state = test::hand_made_result(name);
  run.end = RunEnd::at_rest;
  run.steps = 1000;
  run.time = 2.5;
  run.seconds = 0.125;
  run.energies = {1e-20, 0.75, 0.5, 1.25, 0, 0};
  run.unrest = {1e-10, 2, 1e-9};
  run.plan.time_step = 0.0025;
  run.plan.lowest = {3, 4};
  run.plan.predicted_steps = 1200;
  run.history = {{"step", {0, 1000}}, {"time", {0, 2.5}}, {"a, b", {not_given, 0.03}}};
  return run;
}

struct Written {
  Model model = test::hand_made_model();
  RunInfo info{"a title", "case.toml", "title = \"a title\"\n", true, {"careful"}};
  Relaxation relaxation;
  std::vector<OutputValue> outputs{{"pull", 0.03, 0.02, 1e-9, "a book"},
                                   {"free", not_given, std::nullopt, 1e-9, ""}};

  explicit Written(std::vector<std::string> load_cases) {
    model.load_cases = std::move(load_cases);
    for (const std::string& name : model.load_cases) relaxation.cases.push_back(hand_made_run(name));
    relaxation.dropped = {{99}};
    relaxation.warnings = {"slow"};
    relaxation.planning_seconds = 0.5;
    relaxation.threads = 2;
  }

  void write(const fs::path& folder) const {
    write_relaxation(model, info, relaxation, outputs, folder.string());
  }
  nlohmann::json json() const {
    return nlohmann::json::parse(
        relaxation_json(model, info, relaxation, outputs, relaxation_files(model, relaxation)));
  }
};

TEST(RelaxationResults, HaveAHistoryWithEmptyFieldsForWhatIsNotKnown) {
  const ScratchFolder scratch;
  Written({""}).write(scratch / "out");
  EXPECT_EQ(read_text(scratch / "out/history.csv"), "step,time,\"a, b\"\n0,0,\n1000,2.5,0.03\n");
}

TEST(RelaxationResults, HaveTheTablesOfAStaticAnswer) {
  const ScratchFolder scratch;
  const Written run({"push", "pull"});
  run.write(scratch / "out");
  StaticSolution solution;
  for (const std::string& name : run.model.load_cases) solution.cases.push_back(test::hand_made_result(name));
  write_results(run.model, run.info, solution, run.outputs, (scratch / "static").string());
  for (const char* name : {"push/particles.csv", "push/bonds.csv", "push/model.vtu", "pull/particles.csv",
                           "pull/bonds.csv", "pull/model.vtu", "case.resolved.toml"})
    EXPECT_EQ(read_text(scratch / "out" / name), read_text(scratch / "static" / name)) << name;
  auto expected = everything_in(scratch / "static");
  expected.insert({"push/history.csv", "pull/history.csv"});
  EXPECT_EQ(everything_in(scratch / "out"), expected);
}

TEST(RelaxationResults, SummarySaysAll) {
  const auto summary = Written({""}).json();
  EXPECT_EQ(summary["title"], "a title");
  EXPECT_EQ(summary["units"], "SI");
  EXPECT_EQ(summary["counts"]["particles"], 4);
  EXPECT_EQ(summary["at_rest"], true);
  EXPECT_EQ(summary["threads"], 2);
  EXPECT_EQ(summary["planning_seconds"], 0.5);
  EXPECT_EQ(summary["dropped"], nlohmann::json::parse("[[99]]"));
  EXPECT_EQ(summary["warnings"], nlohmann::json::parse(R"(["careful", "slow"])"));
  EXPECT_EQ(summary["outputs"][0]["expected"], 0.02);
  EXPECT_EQ(summary["files"].back(), "summary.json");
  const auto& run = summary["load_cases"][0];
  EXPECT_EQ(run["largest_displacement"]["particle"], 30);
  EXPECT_EQ(run["end"], "at rest");
  EXPECT_EQ(run["steps"], 1000);
  EXPECT_EQ(run["time"], 2.5);
  EXPECT_EQ(run["seconds"], 0.125);
  EXPECT_EQ(run["fastest_particle"], 1e-10);
  EXPECT_EQ(run["unbalanced_force"], 1e-9);
  EXPECT_EQ(run["energies"]["dissipated"], 0.5);
  EXPECT_EQ(run["energies"]["work"], 1.25);
  EXPECT_EQ(run["energies"]["balance"], hand_made_run("").energies.balance());
  EXPECT_EQ(run["plan"]["time_step"], 0.0025);
  EXPECT_EQ(run["plan"]["lowest_frequencies"], nlohmann::json::parse("[3.0, 4.0]"));
  EXPECT_EQ(run["plan"]["predicted_steps"], 1200);
}

TEST(RelaxationResults, WhatIsNotKnownOrNeverHappensIsNull) {
  Written run({""});
  run.relaxation.cases[0].plan.predicted_steps = infinity;
  run.relaxation.cases[0].plan.best_particle_damping = not_given;
  run.relaxation.cases[0].plan.lowest.clear();
  run.relaxation.cases[0].energies.kinetic = -infinity;
  const auto summary = run.json();
  const auto& plan = summary["load_cases"][0]["plan"];
  EXPECT_TRUE(plan["predicted_steps"].is_null());
  EXPECT_TRUE(plan["best_particle_damping"].is_null());
  EXPECT_TRUE(plan["lowest_frequencies"].empty());
  EXPECT_TRUE(summary["load_cases"][0]["energies"]["kinetic"].is_null());
  EXPECT_TRUE(summary["outputs"][1]["value"].is_null());
}

TEST(RelaxationResults, AreAtRestOnlyWhereEveryLoadCaseIs) {
  Written run({"push", "pull"});
  EXPECT_EQ(run.json()["at_rest"], true);
  run.relaxation.cases[1].end = RunEnd::step_limit;
  EXPECT_EQ(run.json()["at_rest"], false);
  EXPECT_EQ(run.json()["load_cases"][0]["end"], "at rest");
  EXPECT_EQ(run.json()["load_cases"][1]["end"], "step limit");
  run.relaxation.cases[1].end = RunEnd::interrupted;
  EXPECT_EQ(run.json()["load_cases"][1]["end"], "interrupted");
}

TEST(RelaxationResults, KeepTheCheckpointUntilAtRest) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "out");
  scratch.write("out/relax.checkpoint", "half way");
  Written run({""});
  run.relaxation.cases[0].end = RunEnd::step_limit;
  run.write(scratch / "out");
  EXPECT_EQ(read_text(scratch / "out/relax.checkpoint"), "half way");
  EXPECT_THAT(run.json()["files"], testing::Not(testing::Contains("relax.checkpoint")));
  run.relaxation.cases[0].end = RunEnd::at_rest;
  run.write(scratch / "out");
  EXPECT_THAT(everything_in(scratch / "out"),
              UnorderedElementsAre("summary.json", "particles.csv", "bonds.csv", "model.vtu", "history.csv",
                                   "case.resolved.toml"));
}

TEST(RelaxationResults, GivenUpHalfWayLeaveTheFolderAsItWas) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "out");
  scratch.write("out/relax.checkpoint", "half way");
  const Written run({"push", "pull"});
  test::expect_all_or_nothing(scratch, 9, [&](const fs::path& folder, const auto& checkpoint) {
    write_relaxation(run.model, run.info, run.relaxation, run.outputs, folder.string(), checkpoint);
  });
  EXPECT_THAT(everything_in(scratch / "out"), ElementsAre("relax.checkpoint"));
  EXPECT_EQ(read_text(scratch / "out/relax.checkpoint"), "half way");
}

TEST(RelaxationResults, DoNotReplaceFilesOfTheUser) {
  const ScratchFolder scratch;
  scratch.write("history.csv", "mine");
  const Written run({""});
  EXPECT_THROW(check_relaxation_folder(run.model, {}, scratch.path().string()), Error);
  EXPECT_THROW(run.write(scratch.path()), Error);
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("history.csv"));
  EXPECT_EQ(read_text(scratch / "history.csv"), "mine");
}

}  // namespace
}  // namespace bondstatic
