#include <gmock/gmock.h>

#include "report/found_pages.hpp"
#include "report/output_plots.hpp"

namespace bondstatic::test {

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Three particles' deflections, two load cases, in SI units.
std::string case_text() {
  std::string text =
      cantilever() +
      "case = \"down\"\n[[loads]]\nat = { id = 11 }\nforce = [\"1 kN\", 0, 0]\ncase = \"along\"\n";
  text.insert(text.find("force = [0, -100e3"), "case = \"down\"\n");
  for (const char* id : {"3", "5", "7"})
    text += std::string("[[outputs]]\nname = \"particle ") + id + "\"\nof = \"uy\"\nat = { id = " + id +
            " }\ncase = \"down\"\nexpected = -1\n";
  return text;
}

TEST(PageOfSolve, SaysWhatTheSummarySays) {
  const ScratchFolder given, folder;
  run_into(folder, {"solve", given.write("case.toml", case_text()), "--sensitivities"});
  const nlohmann::json json = json_in(folder / "summary.json");
  const FoundRun found = only_run(folder);
  const PageRun& run = found.page;
  EXPECT_EQ(run.kind, "solve");
  EXPECT_EQ(run.title, "cantilever");
  EXPECT_TRUE(found.si);
  EXPECT_THAT(run.notes, IsEmpty());
  EXPECT_EQ(run.resolved_case, read_text(folder / "case.resolved.toml"));

  ASSERT_EQ(found.states.size(), 2u);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(found.states[c].load_case, json["load_cases"][c]["name"]);
    EXPECT_THAT(found.states[c].files,
                ElementsAre((folder / found.states[c].load_case / "model.vtu").string()));
    EXPECT_FALSE(found.states[c].step);
  }

  const PageTable& outputs = titled(run.tables, "Outputs");
  ASSERT_EQ(outputs.rows.size(), json["outputs"].size());
  for (std::size_t i = 0; i < outputs.rows.size(); ++i) {
    const auto& one = json["outputs"][i];
    EXPECT_EQ(words(cell(outputs, i, "output")), one["name"]);
    EXPECT_EQ(number(cell(outputs, i, "value")), one["value"].get<double>());
    EXPECT_EQ(number(cell(outputs, i, "expected")), one["expected"].get<double>());
    EXPECT_EQ(number(cell(outputs, i, "relative error")), one["relative_error"].get<double>());
    EXPECT_EQ(words(cell(outputs, i, "within")), i == 0 ? "yes" : "no");
  }
  EXPECT_EQ(words(cell(outputs, 0, "source")), "[Chen2022] Eq. 29");

  const PageTable& cases = titled(run.tables, "Load cases");
  for (std::size_t c = 0; c < 2; ++c) {
    const auto& one = json["load_cases"][c];
    EXPECT_EQ(words(cell(cases, c, "load case")), one["name"]);
    EXPECT_EQ(number(cell(cases, c, "strain energy, J")), one["energy"].get<double>());
    EXPECT_EQ(number(cell(cases, c, "uy, m")), one["largest_displacement"]["components"][1].get<double>());
    EXPECT_EQ(words(cell(cases, c, "at")), "particle 11");
  }
  const PageTable& accuracy = titled(run.tables, "Accuracy");
  ASSERT_EQ(accuracy.rows.size(), 3u);
  EXPECT_EQ(words(cell(accuracy, 2, "load case")), "worst of all");
  EXPECT_EQ(number(cell(accuracy, 2, "forward error")), json["accuracy"]["forward_error"].get<double>());
  EXPECT_EQ(number(fact(titled(run.tables, "What was solved"), "bonds")), 10);
  EXPECT_EQ(words(fact(titled(run.tables, "What was solved"), "bonds by law")), "10 timoshenko");
  EXPECT_EQ(words(fact(titled(run.tables, "Solver"), "solver")), json["solver"]["name"]);
  EXPECT_EQ(number(fact(titled(run.tables, "Memory"), "peak of the process, MB")),
            json["memory"]["peak_bytes"].get<double>() / 1e6);
  const PageTable& time = titled(run.tables, "Time");
  ASSERT_EQ(time.rows.size(), json["phases"].size() + 1);
  EXPECT_EQ(number(cell(time, 0, "time, s")), json["phases"][0]["seconds"].get<double>());

  const auto& first = json["outputs"][0]["sensitivities"][0];
  const PageTable& sensitivities = titled(run.tables, "Sensitivities");
  EXPECT_EQ(number(cell(sensitivities, 0, "derivative")), first["derivative"].get<double>());
  EXPECT_EQ(named(titled(run.plots, "Relative sensitivities"), "bonds.0.young").y[0],
            first["elasticity"].get<double>());
}

TEST(PageOfSolve, DrawsOutputsBesideWhatWasExpected) {
  const ScratchFolder given, folder;
  run_into(folder, {"solve", given.write("case.toml", case_text())});
  const nlohmann::json json = json_in(folder / "summary.json");
  const PageRun run = only_run(folder).page;
  const PagePlot& errors = titled(run.plots, "Outputs: relative errors");
  EXPECT_TRUE(errors.y.log);
  EXPECT_THAT(errors.x.categories, ElementsAre("tip", "particle 3", "particle 5", "particle 7"));
  EXPECT_EQ(named(errors, "found against expected").y[1], json["outputs"][1]["relative_error"].get<double>());
  EXPECT_TRUE(named(errors, "tolerance").reference);
  EXPECT_THAT(named(errors, "tolerance").y, ElementsAre(1e-9, 1e-9, 1e-9, 1e-9));
  const PagePlot& ratios = titled(run.plots, "Outputs over expected values");
  EXPECT_EQ(named(ratios, "found").y[2], -json["outputs"][2]["value"].get<double>());
  const PagePlot& family = titled(run.plots, "Outputs by number: particle");
  EXPECT_THAT(named(family, "found").x, ElementsAre(3, 5, 7));
  EXPECT_EQ(named(family, "found").y[1], json["outputs"][2]["value"].get<double>());
  EXPECT_THAT(named(family, "expected").y, ElementsAre(-1, -1, -1));
}

TEST(PageOfSolve, SaysWhatAPeriodicCellIsWorth) {
  const ScratchFolder folder;
  run_into(folder, {"solve", BONDSTATIC_SOURCE_DIR "/cases/periodic-cell/fcc.toml"});
  const nlohmann::json json = json_in(folder / "summary.json");
  const PageRun run = only_run(folder).page;
  const PageTable& stiffness = titled(run.tables, "Effective stiffness, Pa");
  ASSERT_EQ(stiffness.rows.size(), 6u);
  EXPECT_EQ(number(cell(stiffness, 0, "yy")), json["effective_stiffness"]["stiffness"][0][1].get<double>());
  EXPECT_EQ(number(fact(titled(run.tables, "Effective stiffness: the nearest isotropic one"),
                        "Young's modulus, Pa")),
            json["effective_stiffness"]["isotropic"]["young"].get<double>());
  EXPECT_EQ(number(cell(titled(run.tables, "Stress, Pa: xx"), 0, "x")),
            json["load_cases"][0]["stress"][0][0].get<double>());
}

TEST(PageOfSolve, SaysWhatWasLeftOut) {
  const ScratchFolder folder;
  nlohmann::json ids = nlohmann::json::array();
  for (int id = 1; id <= 25; ++id) ids.push_back(id);
  folder.write("summary.json", nlohmann::json{{"bondstatic", "0.1.0"},
                                              {"case", "cases/some.toml"},
                                              {"dropped", {ids, {9223372036854775807}}},
                                              {"warnings", {"one", "two"}}}
                                   .dump());
  const PageRun run = only_run(folder).page;
  EXPECT_EQ(run.title, "some.toml");
  EXPECT_THAT(run.warnings, ElementsAre("one", "two"));
  const PageTable& table = titled(run.tables, "Left out: nothing supports them");
  EXPECT_EQ(number(cell(table, 0, "particles")), 25);
  EXPECT_TRUE(words(cell(table, 0, "ids")).ends_with("19, 20 and 5 more"));
  EXPECT_EQ(words(cell(table, 1, "ids")), "9223372036854775807");
}

TEST(NumberedOutputs, AreThreeOfAStemAtLeast) {
  const auto families =
      numbered_outputs({"a 10", "a 2", "tip", "a 1", "b1", "b2", "12", "13", "14", "c_1.5"});
  ASSERT_EQ(families.size(), 1u);
  EXPECT_EQ(families[0].stem, "a");
  EXPECT_THAT(families[0].number, ElementsAre(1, 2, 10));
  EXPECT_THAT(families[0].index, ElementsAre(3, 1, 0));
}

}  // namespace

}  // namespace bondstatic::test
