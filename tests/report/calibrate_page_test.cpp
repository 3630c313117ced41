#include <gmock/gmock.h>

#include <cmath>

#include "report/found_pages.hpp"

namespace bondstatic::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string cases = BONDSTATIC_SOURCE_DIR "/cases/calibration/";

/// Five packings, two parameters: intervals, correlations, scatter.
TEST(PageOfCalibrate, ShowsHowCertainParametersAre) {
  const ScratchFolder folder;
  run_into(folder, {"calibrate", cases + "edem-seeds.toml"});
  const nlohmann::json json = json_in(folder / "calibration.json");
  const FoundRun found = only_run(folder);
  const PageRun& run = found.page;
  EXPECT_EQ(run.kind, "calibrate");
  EXPECT_TRUE(found.si);
  EXPECT_TRUE(found.states.empty());
  EXPECT_EQ(run.resolved_case, read_text(folder / "calibrated.toml"));
  EXPECT_EQ(words(fact(titled(run.tables, "Calibration"), "because")), json["reason"]);

  const PagePlot& between = titled(run.plots, "Parameters between their bounds");
  const PageTable& parameters = titled(run.tables, "Parameters");
  for (std::size_t p = 0; p < 2; ++p) {
    const auto& one = json["parameters"][p];
    const double low = std::log(one["min"].get<double>()), high = std::log(one["max"].get<double>());
    const auto part = [&](const char* key) {
      return (std::log(one[key].get<double>()) - low) / (high - low);
    };
    const PageSeries& calibrated = named(between, "calibrated");
    EXPECT_DOUBLE_EQ(calibrated.y[p], part("value"));
    EXPECT_DOUBLE_EQ(calibrated.low[p], part("lower_95"));
    EXPECT_DOUBLE_EQ(calibrated.high[p], part("upper_95"));
    EXPECT_DOUBLE_EQ(named(between, "start").y[p], part("start"));
    EXPECT_EQ(number(cell(parameters, p, "95 % to")), one["upper_95"].get<double>());
    const std::string name = one["name"];
    const PagePlot& way = titled(run.plots, name + " on its way");
    EXPECT_TRUE(way.y.log);
    EXPECT_THAT(named(way, "calibrated, 95 % interval").low, ElementsAre(one["lower_95"].get<double>()));
    for (std::size_t i = 0; i < json["history"].size(); ++i)
      EXPECT_EQ(named(way, "evaluated").y[i], json["history"][i]["parameters"][name].get<double>());
    EXPECT_EQ(number(cell(titled(run.tables, "Correlation of the parameters"), 0, name)),
              json["correlation"][0][p].get<double>());
  }
  const PagePlot& cost = titled(run.plots, "Cost of each evaluation");
  EXPECT_TRUE(cost.y.log);
  EXPECT_EQ(named(cost, "steps taken").y[0], json["history"][0]["cost"].get<double>());

  const PagePlot& targets = titled(run.plots, "Achieved against wanted");
  ASSERT_EQ(targets.x.categories.size(), 10u);
  EXPECT_NEAR(named(targets, "achieved").y[3], json["targets"][3]["residual"].get<double>(), 1e-12);
  EXPECT_EQ(named(targets, "wanted, with its tolerance").low[0], -1);
  const PagePlot& seeds = titled(run.plots, "nu in each test");
  ASSERT_EQ(seeds.x.categories.size(), 5u);
  EXPECT_EQ(seeds.x.categories[0], json["targets"][5]["test"]);
  EXPECT_EQ(named(seeds, "achieved").y[0], json["targets"][5]["achieved"].get<double>());
  EXPECT_DOUBLE_EQ(named(seeds, "wanted").high[0], 0.22 + json["targets"][5]["tolerance"].get<double>());
  EXPECT_EQ(number(cell(titled(run.tables, "Scatter of the tests"), 0, "standard deviation")),
            json["scatter"][0]["standard_deviation"].get<double>());
  EXPECT_EQ(number(fact(titled(run.tables, "Singular values of the sensitivities"), "2")),
            json["singular_values"][1].get<double>());
}

TEST(PageOfCalibrate, WarnsOfWhatTheTestsCannotTell) {
  const ScratchFolder folder;
  run_into(folder, {"calibrate", cases + "unidentifiable.toml"});
  const nlohmann::json json = json_in(folder / "calibration.json");
  const PageRun run = only_run(folder).page;
  const std::string sentence = json["unidentified"][0]["sentence"];
  EXPECT_THAT(run.warnings, testing::Contains("Not told apart: " + sentence + "."));
  const PageTable& table = titled(run.tables, "What the tests cannot tell apart");
  EXPECT_EQ(number(cell(table, 0, "bonds.0.young")),
            json["unidentified"][0]["direction"]["bonds.0.young"].get<double>());
  EXPECT_FALSE(has_title(run.tables, "Correlation of the parameters")) << "there is none";
}

TEST(PageOfCalibrate, TargetsWithoutTolerancesAreOverWhatIsWanted) {
  const ScratchFolder folder;
  folder.write("calibration.json", R"({"bondstatic": "0.1.0", "targets": [
      {"output": "E", "wanted": 4, "achieved": 5, "tolerance": null, "weight": 2, "residual": 0.5},
      {"output": "F", "wanted": 0, "achieved": 1, "tolerance": null}]})");
  const PageRun run = only_run(folder).page;
  const PagePlot& plot = titled(run.plots, "Achieved against wanted");
  EXPECT_THAT(plot.y.label, HasSubstr("over wanted"));
  EXPECT_EQ(named(plot, "achieved").y[0], 0.25);
  EXPECT_TRUE(std::isnan(named(plot, "achieved").y[1]));
  EXPECT_TRUE(named(plot, "wanted").low.empty());
  EXPECT_EQ(number(cell(titled(run.tables, "Targets"), 0, "weight")), 2);
}

}  // namespace

}  // namespace bondstatic::test
