#include <fmt/format.h>
#include <gmock/gmock.h>

#include "report/found_pages.hpp"

namespace bondstatic::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string moving_case() {
  std::string text = cantilever();
  text.insert(text.find("radius = 0.2"), "density = 7850\n");
  return text + "[dynamics]\nvelocity_limit = 1e-3\nforce_limit = 1e-4\n";
}

TEST(PageOfRelax, DrawsItsHistory) {
  const ScratchFolder given, folder;
  run_into(folder, {"relax", given.write("case.toml", moving_case())});
  const nlohmann::json json = json_in(folder / "summary.json");
  const auto history = CsvColumns::read((folder / "history.csv").string());
  const FoundRun found = only_run(folder);
  const PageRun& run = found.page;
  EXPECT_EQ(run.kind, "relax");
  EXPECT_FALSE(found.si);
  EXPECT_THAT(run.warnings, IsEmpty());
  ASSERT_EQ(found.states.size(), 1u);
  EXPECT_EQ(found.states[0].label, "at rest");

  const PagePlot& energies = titled(run.plots, "Energies");
  EXPECT_EQ(energies.x.unit, "") << "the case is in no known units";
  for (const char* name : {"work", "strain", "dissipated", "kinetic"}) {
    EXPECT_EQ(named(energies, name).x, history->numbers("time"));
    EXPECT_EQ(named(energies, name).y, history->numbers(name));
  }
  const PagePlot& rest = titled(run.plots, "Way to rest");
  EXPECT_TRUE(rest.y.log);
  const auto unbalanced = history->numbers("unbalanced");
  EXPECT_TRUE(std::isnan(named(rest, "unbalanced force").y[0])) << "zero has no place on a log axis";
  EXPECT_EQ(named(rest, "unbalanced force").y.back(), unbalanced.back());
  EXPECT_EQ(named(titled(run.plots, "Fastest particle"), "fastest particle").y.back(),
            history->numbers("fastest").back());
  EXPECT_EQ(named(titled(run.plots, "Load factor"), "load factor").y, history->numbers("load_factor"));
  const PagePlot& tip = titled(run.plots, "tip over time");
  EXPECT_EQ(named(tip, "run").y, history->numbers("tip"));
  EXPECT_TRUE(named(tip, "expected").reference);
  EXPECT_THAT(named(tip, "expected").y, ElementsAre(-8.534241726238742, -8.534241726238742));

  const PageTable& table = titled(run.tables, "Explicit run");
  const auto& one = json["load_cases"][0];
  EXPECT_EQ(number(fact(table, "steps")), one["steps"].get<double>());
  EXPECT_EQ(number(fact(table, "dissipated energy")), one["energies"]["dissipated"].get<double>());
  EXPECT_EQ(words(fact(table, "end")), "at rest");
  const PageTable& plan = titled(run.tables, "Time step and damping, from the model's frequencies");
  EXPECT_EQ(number(fact(plan, "critical time step")), one["plan"]["critical_time_step"].get<double>());
  EXPECT_EQ(number(fact(plan, "frequency of mode 1, rad per time")),
            one["plan"]["lowest_frequencies"][0].get<double>());
}

TEST(PageOfRelax, PlaysTheStatesOfTheRunInTime) {
  const ScratchFolder given, folder;
  run_into(folder,
           {"relax", given.write("case.toml", moving_case()), "--set", "dynamics.save_interval=\"0.01 s\""});
  const auto history = CsvColumns::read((folder / "history.csv").string());
  const auto time = history->numbers("time"), kinetic = history->numbers("kinetic");
  const FoundRun found = only_run(folder);
  EXPECT_THAT(found.page.notes, IsEmpty());
  ASSERT_GT(found.states.size(), 4u);
  for (std::size_t i = 0; i < found.states.size(); ++i) {
    const SceneState& state = found.states[i];
    const auto row = std::find(time.begin(), time.end(), *state.step) - time.begin();
    ASSERT_LT(row, std::ptrdiff_t(time.size()));
    const bool last = i + 1 == found.states.size();
    EXPECT_EQ(state.label, fmt::format("time {:.4g} s, kinetic {:.4g} J{}", *state.step,
                                       kinetic[std::size_t(row)], last ? ", at rest" : ""));
    const double before = i > 0 ? *found.states[i - 1].step : -1;
    EXPECT_GT(*state.step, before + (i > 0 && !last ? 0.005 : 0));
  }
  EXPECT_EQ(*found.states[0].step, 0);
  EXPECT_EQ(*found.states.back().step,
            json_in(folder / "summary.json")["load_cases"][0]["time"].get<double>());
  EXPECT_EQ(found.states[0].files[0], (folder / "relax_0000.vtu").string());

  folder.write("history.csv", "evaluation,cost\n1,2\n");
  EXPECT_EQ(only_run(folder).states[0].label, "time 0 s");
  std::filesystem::remove(folder / "relax.pvd");
  const FoundRun last = only_run(folder);
  EXPECT_THAT(last.page.notes, testing::Contains(HasSubstr("relax.pvd is not there: only the last state")));
  ASSERT_EQ(last.states.size(), 1u);
  EXPECT_EQ(last.states[0].label, "at rest");
}

TEST(PageOfRelax, SaysWhatIsMissingAndWhatIsNoAnswerYet) {
  const ScratchFolder folder;
  folder.write("summary.json", R"({"bondstatic": "0.1.0", "at_rest": false, "load_cases": [{"name": "x"}]})");
  const PageRun run = only_run(folder).page;
  ASSERT_EQ(run.warnings.size(), 1u);
  EXPECT_THAT(run.warnings[0], HasSubstr("has not come to rest"));
  EXPECT_THAT(run.notes, testing::Contains(HasSubstr("history.csv is not there: no curves over time")));
  folder.write("history.csv", "evaluation,cost\n1,2\n");
  EXPECT_THAT(only_run(folder).page.notes, testing::Contains(HasSubstr("history.csv is of another run")));
}

TEST(PageOfCheck, ShowsTheCertificate) {
  const ScratchFolder given, folder;
  run_into(folder, {"check", given.write("case.toml", moving_case())});
  const nlohmann::json json = json_in(folder / "certificate.json");
  const PageRun run = only_run(folder).page;
  EXPECT_EQ(run.kind, "check");
  const auto& one = json["load_cases"][0];
  const PageTable& table = titled(run.tables, "Static answer and explicit run");
  const PagePlot& plot = titled(run.plots, "Differences");
  EXPECT_TRUE(plot.y.log);
  ASSERT_EQ(table.rows.size(), one["differences"].size());
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& field = one["differences"][i];
    EXPECT_EQ(plot.x.categories[i], field["field"]);
    EXPECT_EQ(named(plot, "largest").y[i], field["largest"].get<double>());
    EXPECT_EQ(named(plot, "first order").y[i], field["first_order"].get<double>());
    EXPECT_EQ(named(plot, "second order").y[i], field["second_order"].get<double>());
    EXPECT_EQ(number(cell(table, i, "norm")), field["norm"].get<double>());
    EXPECT_EQ(words(cell(table, i, "within")) == "yes",
              field["first_order"].get<double>() <= json["tolerance"].get<double>());
  }
  EXPECT_EQ(named(plot, "tolerance on the first order").y[0], json["tolerance"].get<double>());
  EXPECT_EQ(words(fact(titled(run.tables, "Certificate"), "verdict")),
            std::string("static answer and explicit run ") + (json["agrees"] ? "agree" : "do not agree") +
                " within 1e-06");
  EXPECT_EQ(named(titled(run.plots, "Lowest frequencies"), "model").y,
            one["run"]["plan"]["lowest_frequencies"].get<std::vector<double>>());
  EXPECT_EQ(number(cell(titled(run.tables, "Accuracy of the static answer"), 0, "forward error")),
            one["static"]["forward_error"].get<double>());
}

}  // namespace

}  // namespace bondstatic::test
