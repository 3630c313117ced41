// Files and JSON of a run of fracture, from values made by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bondstatic/error.hpp"
#include "bondstatic/results.hpp"
#include "io/read_by_vtk.hpp"
#include "io/scratch_folder.hpp"
#include "results/fracture_plot.hpp"
#include "results/given_up.hpp"
#include "results/hand_made.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::everything_in;
using test::read_text;
using test::ScratchFolder;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;
using testing::UnorderedElementsAre;

/// Both bonds of the model break, the upper one first; with the other one goes all hold.
struct Written {
  Model model = test::hand_made_model();
  RunInfo info{"a title", "case.toml", "title = \"a title\"\n", true, {"careful"}};
  FractureOptions asked;
  Fracture fracture;
  FractureRecord record{{{"a, b", {0.03, not_given}}}, {}};
  std::vector<OutputValue> outputs{{"pull", 0.03, std::nullopt, 0, ""}};

  Written() {
    BondStrength strength;
    strength.criterion = "contact-bond";
    strength.parameters = {8, 8};
    model.blocks[0].strength = strength;
    model.blocks[0].law = "contact";
    model.blocks[0].parameters = {600, 600};
    Load load;
    load.particle = 2;
    load.force[2] = 2;
    model.loads.push_back(load);
    asked.control = FractureControl::load;
    FractureEvent first;
    first.factor = 3, first.load = 6, first.displacement = 0.03;
    first.factor_after = 3, first.load_after = 6, first.displacement_after = 0.04;
    first.runner_up = 0.5, first.released = 0.125, first.strain_energy = 0.25, first.work = 0.375;
    first.dissipated = 0.125, first.avalanche = 1;
    first.bonds = {{1, 0, 1}};
    FractureEvent second = first;
    second.factor = 2, second.load = 4, second.displacement = 0.02;
    for (double* value : {&second.factor_after, &second.load_after, &second.displacement_after,
                          &second.released, &second.strain_energy, &second.work, &second.dissipated})
      *value = not_given;
    second.runner_up = 0;
    second.bonds = {{0, 0, 1}};
    fracture.events = {first, second};
    fracture.break_event = {1, 0};
    fracture.separated = {{{20, 30}, 1}};
    fracture.end = FractureEnd::separated;
    fracture.reason = "nothing holds particle 20";
    static_cast<State&>(fracture.last) = test::hand_made_result("");
    for (BondResult& bond : fracture.last.bonds) bond = {};
    fracture.report.backward_error = 1e-16;
    fracture.report.energy_balance = 2e-15;
    fracture.report.factorisations = 2;
    fracture.report.seconds = 0.5;
    fracture.warnings = {"slow"};
  }

  void show(const fs::path& folder, const std::vector<Index>& break_event) {
    show_fracture(model, test::hand_made_result(""), break_event, record, folder.string());
  }
  void show_all(const fs::path& folder) {
    show(folder, {-1, -1});
    show(folder, {-1, 0});
  }
  void write(const fs::path& folder, const std::function<void()>& checkpoint = {}) const {
    write_fracture(model, info, asked, fracture, record, outputs, folder.string(), checkpoint);
  }
  nlohmann::json json() const {
    return nlohmann::json::parse(
        fracture_json(model, info, asked, fracture, outputs, fracture_files(record)));
  }
};

std::vector<std::string> lines_of(const fs::path& file) {
  std::istringstream stream(read_text(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(FractureResults, HistoryHasARowABrokenBond) {
  const ScratchFolder scratch;
  Written run;
  run.fracture.events[0].bonds.push_back({0, 0, 1 - 1e-12});
  run.write(scratch / "out");
  EXPECT_THAT(
      lines_of(scratch / "out/fracture.csv"),
      ElementsAre(
          "step,factor,load,displacement,bond,a,b,mode,utilisation,runner_up,released,strain_energy,work,"
          "dissipated,factor_after,load_after,displacement_after,avalanche,\"a, b\"",
          "1,3,6,0.03,2,20,30,tension,1,0.5,0.125,0.25,0.375,0.125,3,6,0.04,1,0.03",
          "1,3,6,0.03,1,10,20,tension,0.999999999999,0.5,0.125,0.25,0.375,0.125,3,6,0.04,1,0.03",
          "2,2,4,0.02,1,10,20,tension,1,0,,,,,,,,1,"));
}

TEST(FractureResults, BondsTellWhenTheyBrokeAndHowNearTheyAreToIt) {
  const ScratchFolder scratch;
  Written run;
  run.write(scratch / "out");
  auto rows = lines_of(scratch / "out/bonds.csv");
  EXPECT_THAT(rows[0], testing::EndsWith(",energy,break_step,utilisation"));
  EXPECT_THAT(rows[1], testing::EndsWith(",0,2,"));
  EXPECT_THAT(rows[2], testing::EndsWith(",0,1,"));
  // Pulled by 6 of the 8 that it bears.
  run.fracture.break_event = {-1, 0};
  run.fracture.last = test::hand_made_result("");
  run.fracture.last.bonds[1] = {};
  run.write(scratch / "out");
  rows = lines_of(scratch / "out/bonds.csv");
  EXPECT_THAT(rows[1], testing::EndsWith(",0.25,0,0.75"));
  EXPECT_THAT(rows[2], testing::EndsWith(",0,1,"));
}

TEST(FractureResults, StatesAreASeriesThatVtkReads) {
  const ScratchFolder scratch;
  Written run;
  run.show_all(scratch / "out");
  EXPECT_THAT(
      everything_in(scratch / "out"),
      UnorderedElementsAre("fracture.unfinished", "fracture.unfinished/fracture.pvd",
                           "fracture.unfinished/fracture_0000.vtu", "fracture.unfinished/fracture_0001.vtu"));
  const std::string series = read_text(scratch / "out/fracture.unfinished/fracture.pvd");
  EXPECT_THAT(series, HasSubstr("timestep=\"0\" part=\"0\" file=\"fracture_0000.vtu\""));
  EXPECT_THAT(series, HasSubstr("timestep=\"1\" part=\"0\" file=\"fracture_0001.vtu\""));
  run.write(scratch / "out");
  EXPECT_FALSE(fs::exists(scratch / "out/fracture.unfinished"));
  EXPECT_EQ(read_text(scratch / "out/fracture.pvd"), series);
  const auto found = test::read_by_vtk((scratch / "out/fracture_0001.vtu").string(), scratch);
  EXPECT_TRUE(found.contains("array cell break_step")) << testing::PrintToString(found);
  EXPECT_TRUE(found.contains("array cell utilisation"));
}

TEST(FractureResults, StatesShownAgainAreThereOnce) {
  const ScratchFolder scratch;
  Written run;
  run.show_all(scratch / "out");
  const std::string first = read_text(scratch / "out/fracture.unfinished/fracture_0000.vtu");
  run.show_all(scratch / "out");
  EXPECT_THAT(run.record.states, ElementsAre(0, 1));
  EXPECT_EQ(read_text(scratch / "out/fracture.unfinished/fracture_0000.vtu"), first);
  EXPECT_THAT(everything_in(scratch / "out"), SizeIs(4));
}

TEST(FractureResults, AreListedInTheSummary) {
  const ScratchFolder scratch;
  Written run;
  run.show_all(scratch / "out");
  run.write(scratch / "out");
  const auto there = everything_in(scratch / "out");
  EXPECT_THAT(there, UnorderedElementsAre("summary.json", "case.resolved.toml", "particles.csv", "bonds.csv",
                                          "model.vtu", "fracture.csv", "fracture.svg", "fracture.pvd",
                                          "fracture_0000.vtu", "fracture_0001.vtu"));
  EXPECT_EQ(run.json()["files"].get<std::set<std::string>>(), there);
  EXPECT_EQ(run.json()["files"].back(), "summary.json");
}

TEST(FractureResults, SummarySaysAll) {
  const auto summary = Written().json();
  EXPECT_EQ(summary["title"], "a title");
  EXPECT_EQ(summary["units"], "SI");
  EXPECT_EQ(summary["control"], "load");
  EXPECT_TRUE(summary["preload"].is_null());
  EXPECT_EQ(summary["end"], "separated");
  EXPECT_EQ(summary["reason"], "nothing holds particle 20");
  EXPECT_EQ(summary["events"], 2);
  EXPECT_EQ(summary["breaks"], 2);
  EXPECT_EQ(summary["avalanches"], 1);
  EXPECT_EQ(summary["breaks_by_mode"]["tension"], 2);
  EXPECT_EQ(summary["first_break"]["bonds"][0]["bond"], 2);
  EXPECT_EQ(summary["first_break"]["bonds"][0]["a"], 20);
  EXPECT_EQ(summary["first_break"]["load"], 6.0);
  EXPECT_EQ(summary["peak"]["step"], 1);
  EXPECT_EQ(summary["peak"]["displacement"], 0.03);
  EXPECT_EQ(summary["energies"]["dissipated"], 0.125);
  EXPECT_EQ(summary["energies"]["balance"], 2e-15);
  EXPECT_EQ(summary["accuracy"]["backward_error"], 1e-16);
  EXPECT_EQ(summary["separated"][0]["after_step"], 2);
  EXPECT_EQ(summary["separated"][0]["particles"], nlohmann::json::parse("[20, 30]"));
  EXPECT_TRUE(summary["last"]["load"].is_null());
  EXPECT_EQ(summary["last"]["largest_displacement"]["particle"], 30);
  EXPECT_EQ(summary["solver"]["factorisations"], 2);
  EXPECT_EQ(summary["seconds"], 0.5);
  EXPECT_EQ(summary["outputs"][0]["value"], 0.03);
  EXPECT_EQ(summary["warnings"], nlohmann::json::parse(R"(["careful", "slow"])"));
}

TEST(FractureResults, WhereNothingBrokeSayThat) {
  const ScratchFolder scratch;
  Written run;
  run.fracture.events.clear();
  run.fracture.separated.clear();
  run.fracture.break_event = {-1, -1};
  run.fracture.end = FractureEnd::unbreakable;
  const auto summary = run.json();
  EXPECT_EQ(summary["breaks"], 0);
  EXPECT_TRUE(summary["first_break"].is_null());
  EXPECT_TRUE(summary["peak"].is_null());
  run.write(scratch / "out");
  EXPECT_THAT(lines_of(scratch / "out/fracture.csv"), SizeIs(1));
  EXPECT_THAT(read_text(scratch / "out/fracture.svg"), HasSubstr("no bond broke"));
}

TEST(FractureResults, CurveRunsThroughBothSidesOfEachEvent) {
  const Written run;
  const Plot plot = fracture_plot(run.model, run.info, run.asked, run.fracture);
  ASSERT_THAT(plot.curve, SizeIs(5));
  const Eigen::Vector2d points[] = {{0, 0}, {0.03, 6}, {0.04, 6}, {0.02, 4}};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(plot.curve[i], points[i]);
  EXPECT_FALSE(plot.curve[4].allFinite());
  ASSERT_THAT(plot.dots, SizeIs(2));
  EXPECT_GT(plot.dots[0].radius, plot.dots[1].radius);
  ASSERT_THAT(plot.marks, SizeIs(1));  // the first break is at the largest load, too
  EXPECT_THAT(plot.marks[0].text, HasSubstr("first break: bond 2"));
  EXPECT_EQ(plot.x.unit, "m");
}

TEST(FractureResults, PatternOfMomentsOrStrainsIsCalledSo) {
  Written run;
  const auto plot = [&] { return fracture_plot(run.model, run.info, run.asked, run.fracture); };
  run.model.loads[0].force = Vector6::Unit(4);
  EXPECT_EQ(plot().y.name, "moment");
  EXPECT_EQ(plot().x.unit, "rad");
  run.model.loads.clear();
  run.model.supports[0].value[1] = 1e-3;
  EXPECT_EQ(plot().x.name, "displacement");
  run.model.strains.push_back({Matrix3::Identity(), every_case});
  EXPECT_EQ(plot().x.name, "strain");
  run.info.si = false;
  EXPECT_EQ(plot().y.unit, "");
}

TEST(FractureResults, OfAnInterruptedRunLeaveWhatItNeedsToGoOn) {
  const ScratchFolder scratch;
  Written run;
  run.show_all(scratch / "out");
  scratch.write("out/fracture.checkpoint", "half way");
  run.fracture.end = FractureEnd::interrupted;
  run.write(scratch / "out");
  EXPECT_EQ(run.json()["end"], "interrupted");
  EXPECT_THAT(everything_in(scratch / "out"), SizeIs(10 + 5));
  check_fracture_folder((scratch / "out").string(), run.record);
  run.fracture.end = FractureEnd::separated;
  run.write(scratch / "out");
  EXPECT_THAT(everything_in(scratch / "out"), SizeIs(10));
  EXPECT_THAT(everything_in(scratch / "out"), Not(Contains("fracture.checkpoint")));
}

TEST(FractureResults, GivenUpHalfWayLeaveTheFolderAsItWas) {
  const ScratchFolder scratch;
  Written run;
  run.show_all(scratch / "out");
  scratch.write("out/fracture.checkpoint", "half way");
  test::expect_all_or_nothing(
      scratch, 11, [&](const fs::path& folder, const auto& checkpoint) { run.write(folder, checkpoint); });
  EXPECT_EQ(read_text(scratch / "out/fracture.checkpoint"), "half way");
}

TEST(FractureResults, OfAnEarlierRunAreReplaced) {
  const ScratchFolder scratch;
  Written run;
  run.show_all(scratch / "out");
  run.write(scratch / "out");
  scratch.write("out/notes.txt", "mine");
  Written next;
  check_fracture_folder((scratch / "out").string());
  next.show(scratch / "out", {-1, -1});
  next.write(scratch / "out");
  EXPECT_THAT(everything_in(scratch / "out"), Not(Contains("fracture_0001.vtu")));
  EXPECT_EQ(read_text(scratch / "out/notes.txt"), "mine");
}

TEST(FractureResults, DoNotReplaceFilesOfTheUser) {
  const ScratchFolder scratch;
  scratch.write("fracture_0001.vtu", "mine");
  EXPECT_THROW(check_fracture_folder(scratch.path().string()), Error);
  Written run;
  run.show_all(scratch.path());
  EXPECT_THROW(run.write(scratch.path()), Error);
  EXPECT_EQ(read_text(scratch / "fracture_0001.vtu"), "mine");
}

TEST(FractureResults, StatesOfARunThatNobodyGoesOnWithAreRemoved) {
  const ScratchFolder scratch;
  Written run;
  run.show_all(scratch / "out");
  scratch.write("out/fracture.unfinished/notes.txt", "mine");
  check_fracture_folder((scratch / "out").string());
  EXPECT_THAT(everything_in(scratch / "out"),
              UnorderedElementsAre("fracture.unfinished", "fracture.unfinished/notes.txt"));
}

TEST(FractureResults, StatesThatAreMissingAreNoticed) {
  const ScratchFolder scratch;
  Written run;
  run.show_all(scratch / "out");
  check_fracture_folder((scratch / "out").string(), run.record);
  fs::remove(scratch / "out/fracture.unfinished/fracture_0001.vtu");
  try {
    check_fracture_folder((scratch / "out").string(), run.record);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_THAT(error.what(), HasSubstr("fracture_0001.vtu: not there"));
    EXPECT_THAT(error.what(), HasSubstr("cure: "));
  }
}

}  // namespace
}  // namespace bondstatic
