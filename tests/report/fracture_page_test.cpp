#include <gmock/gmock.h>

#include <cmath>

#include "app/fracture_cases.hpp"
#include "report/found_pages.hpp"

namespace bondstatic::test {

namespace {

using testing::Contains;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pointwise;

TEST(PageOfFracture, DrawsThePathAsItHappens) {
  const ScratchFolder given, folder;
  run_into(folder, {"fracture", given.write("case.toml", fibre_bundle()), "--set",
                    "bonds.0.strength.range={ critical_tensile_force = 9.5 }"});
  const nlohmann::json json = json_in(folder / "summary.json");
  const auto csv = CsvColumns::read((folder / "fracture.csv").string());
  const auto load = csv->numbers("load"), after = csv->numbers("load_after"),
             displacement = csv->numbers("displacement"),
             displacement_after = csv->numbers("displacement_after");
  const FoundRun found = only_run(folder);
  const PageRun& run = found.page;
  EXPECT_EQ(run.kind, "fracture");
  EXPECT_THAT(run.notes, IsEmpty());
  EXPECT_EQ(run.resolved_case, read_text(folder / "case.resolved.toml"));

  const PagePlot& plot = titled(run.plots, "Load over displacement");
  const PageSeries& path = named(plot, "as it happens");
  ASSERT_EQ(path.x.size(), 17u) << "from zero, then before and after each of eight breaks";
  EXPECT_EQ(path.y[0], 0);
  for (std::size_t e = 0; e < 8; ++e) {
    EXPECT_EQ(path.x[2 * e + 1], displacement[e]);
    EXPECT_EQ(path.y[2 * e + 1], load[e]);
    EXPECT_EQ(path.x[2 * e + 2], displacement_after[e]);
    EXPECT_EQ(path.y[2 * e + 2], after[e]);
  }
  const auto peak = std::size_t(json["peak"]["step"]) - 1;
  ASSERT_EQ(plot.marks.size(), 2u);
  EXPECT_EQ(plot.marks[0].label, "first break: bond " +
                                     std::to_string(json["first_break"]["bonds"][0]["bond"].get<int>()) +
                                     " (" + std::to_string(csv->whole_numbers("a")[0]) + " to " +
                                     std::to_string(csv->whole_numbers("b")[0]) + "), tension");
  EXPECT_EQ(plot.marks[1].y, load[peak]);
  EXPECT_THAT(plot.marks[1].label, HasSubstr("peak, after " + std::to_string(peak) + " event"));
  for (const char* name : {"work", "dissipated"})
    EXPECT_EQ(named(titled(run.plots, "Energies after each event"), name).y, csv->numbers(name));
  EXPECT_EQ(named(titled(run.plots, "Energies after each event"), "strain").y, csv->numbers("strain_energy"));
  EXPECT_EQ(named(titled(run.plots, "Energy that each event releases"), "released").y,
            csv->numbers("released"));
  EXPECT_EQ(named(titled(run.plots, "force over events"), "just before each event").y, csv->numbers("force"));
  EXPECT_THAT(named(titled(run.plots, "Bonds broken by each avalanche"), "bonds").y,
              Pointwise(DoubleEq(), std::vector<double>(json["avalanches"].get<std::size_t>(), 1.0)));
  EXPECT_THAT(named(titled(run.plots, "Broken bonds over displacement"), "broken bonds").y,
              ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));

  const PageTable& broke = titled(run.tables, "What broke");
  EXPECT_EQ(number(fact(broke, "peak: load")), json["peak"]["load"].get<double>());
  EXPECT_EQ(number(fact(broke, "broken bonds")), 8);
  EXPECT_EQ(words(fact(broke, "modes")), "8 by tension");
  EXPECT_EQ(number(fact(titled(run.tables, "Energies"), "dissipated")),
            json["energies"]["dissipated"].get<double>());
}

TEST(PageOfFracture, StatesSayHowFarItIs) {
  const ScratchFolder given, folder;
  run_into(folder, {"fracture", given.write("case.toml", fibre_bundle()), "--set", "fracture.save_every=3"});
  const auto csv = CsvColumns::read((folder / "fracture.csv").string());
  const auto before = csv->numbers("load"), after = csv->numbers("load_after");
  const FoundRun found = only_run(folder);
  std::vector<double> steps;
  for (const SceneState& state : found.states) {
    const auto step = std::size_t(*state.step);
    steps.push_back(*state.step);
    const double load = step == 0 ? before[0] : after[step - 1];
    EXPECT_THAT(state.label, HasSubstr(std::to_string(step) + " broken, load "));
    EXPECT_NEAR(std::stod(state.label.substr(state.label.rfind(' '))), load, 1e-3 * std::abs(load));
    EXPECT_TRUE(std::filesystem::exists(state.files.at(0)));
  }
  EXPECT_THAT(steps, ElementsAre(0, 3, 6, 8));
  EXPECT_EQ(found.states[1].files[0], (folder / "fracture_0003.vtu").string());

  std::filesystem::remove(folder / "fracture.pvd");
  const FoundRun last = only_run(folder);
  EXPECT_THAT(last.page.notes,
              ElementsAre(HasSubstr("fracture.pvd is not there: only the last state is shown")));
  ASSERT_EQ(last.states.size(), 1u);
  EXPECT_EQ(*last.states[0].step, 8);
  EXPECT_EQ(last.states[0].files[0], (folder / "model.vtu").string());
}

TEST(PageOfFracture, InWhichNothingBreaksHasOneState) {
  const ScratchFolder given, folder;
  run_into(folder,
           {"fracture", given.write("case.toml", fibre_bundle()), "--set", "fracture.max_factor=1e-3"});
  const FoundRun found = only_run(folder);
  EXPECT_THAT(found.page.notes, IsEmpty());
  ASSERT_EQ(found.states.size(), 1u);
  EXPECT_EQ(found.states[0].label, "0 broken");
}

/// Two bonds break together, then one after another at the same load.
constexpr const char* rows =
    "step,factor,load,displacement,bond,a,b,mode,utilisation,runner_up,released,strain_energy,work,"
    "dissipated,"
    "factor_after,load_after,displacement_after,avalanche,load\n"
    "1,1,10,1,5,1,2,tension,1,0.5,1,2,3,1,1,8,1,1,7\n"
    "1,1,10,1,6,2,3,shear,1,0.5,1,2,3,1,1,8,1,1,7\n"
    "2,1,9,2,7,3,4,,1,0.5,2,2,3,1,1,6,2,1,6\n"
    "3,1,12,3,8,4,5,,1,0.5,4,,,,,,,2,5\n";

TEST(PageOfFracture, AvalanchesAreCurvesOfTheirOwn) {
  const ScratchFolder folder;
  folder.write("fracture.csv", rows);
  folder.write(
      "summary.json",
      R"({"bondstatic": "0.1.0", "units": "SI", "breaks": 4, "events": 3, "preload": "weight", "curve":
                  {"load": "moment", "load_unit": "N m", "displacement": "rotation", "displacement_unit": "rad"}})");
  const PageRun run = only_run(folder).page;
  const PagePlot& plot = titled(run.plots, "Moment over rotation");
  EXPECT_EQ(plot.x.label, "rotation");
  EXPECT_EQ(plot.x.unit, "rad");
  EXPECT_EQ(plot.y.unit, "N m");
  EXPECT_THAT(named(plot, "avalanche 1 of 3 bonds").y, ElementsAre(10, 8, 9, 6));
  EXPECT_EQ(plot.series.size(), 3u) << "a single bond is no avalanche to be shown";
  EXPECT_EQ(named(plot, "as it happens").y.front(), 10) << "a preload has displaced before";
  EXPECT_TRUE(std::isnan(named(plot, "as it happens").y.back())) << "nothing is left to carry";
  EXPECT_EQ(plot.marks[0].label, "first break: bond 5 (1 to 2), tension and 1 more");
  EXPECT_THAT(named(titled(run.plots, "Bonds broken by each avalanche"), "bonds").y, ElementsAre(3, 1));
  const PageTable& largest = titled(run.tables, "Largest avalanches");
  EXPECT_EQ(number(cell(largest, 0, "bonds")), 3);
  EXPECT_EQ(number(cell(largest, 0, "moment before, N m")), 10);
  EXPECT_EQ(number(cell(largest, 0, "moment after, N m")), 6);
  EXPECT_EQ(number(cell(largest, 0, "released energy, J")), 3);
  EXPECT_THAT(named(titled(run.plots, "load over events"), "just before each event").y, ElementsAre(7, 6, 5))
      << "an output that is called as a column";
}

TEST(PageOfFracture, WithoutEventsOrTableThereAreNoCurves) {
  const ScratchFolder folder;
  folder.write("summary.json", R"({"bondstatic": "0.1.0", "breaks": 0, "events": 0})");
  EXPECT_THAT(only_run(folder).page.notes, Contains(HasSubstr("fracture.csv is not there: no curves")));
  const std::string text = rows;
  folder.write("fracture.csv", text.substr(0, text.find('\n') + 1));
  EXPECT_THAT(only_run(folder).page.plots, IsEmpty());
  folder.write("fracture.csv", text + "2,1,9,2,7,3,4,,1,0.5,2,2,3,1,1,6,2,1,6\n");
  EXPECT_THAT(complaint([&] { only_run(folder); }), HasSubstr("fracture.csv:6:1: step = 2 follows 3"));
}

}  // namespace

}  // namespace bondstatic::test
