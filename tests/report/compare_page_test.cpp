#include <gmock/gmock.h>

#include <cmath>

#include "report/found_pages.hpp"

namespace bondstatic::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string lammps = BONDSTATIC_SOURCE_DIR "/cases/lammps-bpm/";

/// A run of a shear stiffness that the case has not.
TEST(PageOfCompare, ShowsTheVerdictAndItsSuspects) {
  const ScratchFolder folder;
  run_into(folder, {"compare", lammps + "case.toml", lammps + "dump.final", "--threads", "1", "--solver",
                    "cholmod", "--set", "bonds.0.ks=4.04e5"});
  const nlohmann::json json = json_in(folder / "summary.json"), comparison = json["comparison"];
  const FoundRun found = only_run(folder);
  const PageRun& run = found.page;
  EXPECT_EQ(run.kind, "compare");
  EXPECT_TRUE(found.si);
  ASSERT_EQ(found.states.size(), 1u);
  EXPECT_THAT(found.states[0].files, ElementsAre((folder / "model.vtu").string()));
  const PageTable& verdict = titled(run.tables, "Static answer and run");
  EXPECT_EQ(words(fact(verdict, "verdict")), "different model");
  EXPECT_EQ(words(fact(verdict, "because")), comparison["reason"]);
  EXPECT_EQ(number(fact(verdict, "particles found in both")), 2068);

  const PagePlot& fields = titled(run.plots, "Differences by field");
  const PageTable& table = titled(run.tables, "Differences");
  for (std::size_t i = 0; i < comparison["fields"].size(); ++i) {
    const auto& one = comparison["fields"][i];
    EXPECT_EQ(fields.x.categories[i], one["field"]);
    EXPECT_EQ(named(fields, "norm").y[i], one["difference"].get<double>());
    EXPECT_EQ(named(fields, "largest").y[i], one["largest"].get<double>());
    EXPECT_EQ(number(cell(table, i, "norm, run")), one["run_norm"].get<double>());
  }
  EXPECT_THAT(named(fields, "tolerance on displacement and rotation").y, ElementsAre(1e-3, 1e-3));

  const auto& suspects = comparison["suspects"];
  ASSERT_GT(suspects.size(), 2u);
  const PagePlot& left = titled(run.plots, "What each suspect leaves of the difference");
  ASSERT_EQ(left.x.categories.size(), suspects.size());
  for (std::size_t i = 0; i < suspects.size(); ++i)
    EXPECT_EQ(named(left, "left").y[i], suspects[i]["left"].get<double>());
  EXPECT_EQ(named(left, "difference of displacements").y[0],
            comparison["fields"][0]["difference"].get<double>());
  EXPECT_EQ(words(cell(titled(run.tables, "What could be different from the case"), 0, "if the run has")),
            suspects[0]["text"]);

  const PageTable& worst = titled(run.tables, "Particles with the largest differences");
  const auto& first = comparison["worst"][0];
  EXPECT_EQ(words(cell(worst, 0, "particle")), "particle " + std::to_string(first["particle"].get<int>()));
  EXPECT_EQ(number(cell(worst, 0, "run uz, m")), first["run"][2].get<double>());
  EXPECT_EQ(number(fact(titled(run.tables, "What the run's state carries that rest does not"),
                        "unbalanced forces over the loads")),
            comparison["state"]["residual_linear"].get<double>());
  EXPECT_EQ(titled(run.tables, "What was assumed of the run's files").rows.size(),
            comparison["notes"].size());
}

TEST(PageOfCompare, DrawsSeveralStepsOfARun) {
  const ScratchFolder folder;
  folder.write("summary.json",
               R"({"bondstatic": "0.1.0", "comparison": {"fields": [{"field": "displacement"}]},
      "series": [{"step": 0, "displacement": 1}, {"step": 100, "displacement": 0.25}, {"step": 200}]})");
  const PagePlot plot = titled(only_run(folder).page.plots, "Differences by step of the run");
  EXPECT_TRUE(plot.y.log);
  EXPECT_THAT(plot.series.at(0).x, ElementsAre(0, 100, 200));
  EXPECT_EQ(plot.series[0].y[1], 0.25);
  EXPECT_TRUE(std::isnan(plot.series[0].y[2]));
  folder.write("steps.csv",
               "step,displacement,rotation,scale,energy,kinetic,residual\n0,1,0.5,1,2,3,4\n7,0.1,,1,2,3,5\n");
  const PagePlot full = titled(only_run(folder).page.plots, "Differences by step of the run");
  EXPECT_THAT(named(full, "unbalanced forces over the loads").y, ElementsAre(4, 5));
  EXPECT_THAT(named(full, "displacement").x, ElementsAre(0, 7));
}

}  // namespace

}  // namespace bondstatic::test
