#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/relax_cases.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::Ended;
using test::everything_in;
using test::expect_same_results;
using test::heavy_cantilever;
using test::read_json;
using test::read_text;
using test::results_in;
using test::run_program;
using test::ScratchFolder;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;
using testing::UnorderedElementsAre;

constexpr const char* always =
    "step,time,load_factor,kinetic,strain,work,dissipated,balance,fastest,unbalanced";

std::vector<std::vector<std::string>> csv_rows(const fs::path& file) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream stream(read_text(file));
  for (std::string line; std::getline(stream, line);) {
    rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
  }
  return rows;
}

TEST(Relax, PrintsTheOutputsAndHowItCameToRest) {
  const ScratchFolder scratch;
  const Ended ended = run_program(
      {"relax", scratch.write("case.toml", heavy_cantilever()), "--set", "dynamics.kinematics=small"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  for (const char* part : {"11 particles, 10 bonds (timoshenko)", "tip", "-8.5342417", "\n  run ",
                           "at rest after", "\n  rest ", "(limit 1e-09)", "(limit 1e-08)", "\n  energies ",
                           "balance", "\n  time step ", "of the critical", "\n  slowest ", "rad per time",
                           "\n  damping ", "particle damping 0.7: predicted", "would be fastest"})
    EXPECT_THAT(ended.out, HasSubstr(part));
  EXPECT_THAT(ended.out, Not(HasSubstr("\033")));
  EXPECT_THAT(ended.err, IsEmpty());
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("case.toml"));
}

TEST(Relax, WritesItsResultsAndASummaryThatListsThem) {
  const ScratchFolder scratch;
  const Ended ended = run_program(
      {"relax", scratch.write("case.toml", heavy_cantilever()), "--out", (scratch / "out").string()});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto there = everything_in(scratch / "out");
  EXPECT_THAT(there, UnorderedElementsAre("particles.csv", "bonds.csv", "model.vtu", "history.csv",
                                          "case.resolved.toml", "summary.json"));
  const auto summary = read_json(scratch / "out/summary.json");
  EXPECT_EQ(summary["files"].get<std::set<std::string>>(), there);
  EXPECT_EQ(summary["files"].back(), "summary.json");
  EXPECT_EQ(summary["title"], "cantilever");
  EXPECT_EQ(summary["at_rest"], true);
  EXPECT_EQ(summary["counts"]["bonds"], 10);
  ASSERT_THAT(summary["load_cases"], SizeIs(1));
  const auto& run = summary["load_cases"][0];
  EXPECT_EQ(run["end"], "at rest");
  EXPECT_LT(run["fastest_particle"].get<double>(), 1e-9);
  EXPECT_LT(run["unbalanced_force"].get<double>(), 1e-8);
  EXPECT_LT(run["energies"]["balance"].get<double>(), 1e-9);
  EXPECT_EQ(run["energies"]["strain"], run["energy"]);
  EXPECT_LT(run["plan"]["time_step"].get<double>(), run["plan"]["critical_time_step"].get<double>());
  EXPECT_EQ(run["largest_displacement"]["particle"], 11);
  EXPECT_NEAR(summary["outputs"][0]["value"].get<double>(), -8.5342, 1e-4);
}

TEST(Relax, HistoryRunsFromTheStartToTheStateOfRest) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_program({"relax", scratch.write("case.toml", heavy_cantilever()), "--out",
                         (scratch / "out").string()})
                .code,
            0);
  const auto rows = csv_rows(scratch / "out/history.csv");
  const auto summary = read_json(scratch / "out/summary.json");
  const auto& run = summary["load_cases"][0];
  EXPECT_THAT(read_text(scratch / "out/history.csv"), StartsWith(std::string(always) + ",tip\n0,0,0,0,0,"));
  EXPECT_THAT(rows, Each(SizeIs(11)));
  const auto last = [&](int column) { return std::stod(rows.back().at(std::size_t(column))); };
  EXPECT_EQ(last(0), run["steps"].get<double>());
  EXPECT_EQ(last(1), run["time"].get<double>());
  EXPECT_EQ(last(2), 1);
  EXPECT_EQ(last(4), run["energy"].get<double>());
  EXPECT_EQ(last(8), run["fastest_particle"].get<double>());
  EXPECT_EQ(last(10), summary["outputs"][0]["value"].get<double>());
  for (std::size_t row = 2; row < rows.size(); ++row)
    EXPECT_LT(std::stod(rows[row - 1][0]), std::stod(rows[row][0]));
}

TEST(Relax, SeveralLoadCasesHaveAFolderEachAndTheirOwnOutputsInTheHistory) {
  const ScratchFolder scratch;
  const Ended ended = run_program(
      {"relax", scratch.write("case.toml", test::two_load_cases()), "--out", (scratch / "out").string()});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(
      everything_in(scratch / "out"),
      UnorderedElementsAre("down", "down/particles.csv", "down/bonds.csv", "down/model.vtu",
                           "down/history.csv", "twist", "twist/particles.csv", "twist/bonds.csv",
                           "twist/model.vtu", "twist/history.csv", "case.resolved.toml", "summary.json"));
  EXPECT_THAT(read_text(scratch / "out/down/history.csv"), StartsWith(std::string(always) + ",tip\n"));
  EXPECT_THAT(read_text(scratch / "out/twist/history.csv"), StartsWith(std::string(always) + ",turn\n"));
  for (const char* part : {"\n  down\n", "\n  twist\n"}) EXPECT_THAT(ended.out, HasSubstr(part));
  const auto summary = read_json(scratch / "out/summary.json");
  EXPECT_EQ(summary["load_cases"][0]["folder"], "down");
  EXPECT_EQ(summary["load_cases"][1]["folder"], "twist");
}

TEST(Relax, JsonIsTheSummaryAndNothingElse) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", heavy_cantilever());
  const Ended written = run_program({"relax", file, "--json", "--out", (scratch / "out").string()});
  ASSERT_EQ(written.code, 0) << written.err;
  auto summary = read_json(scratch / "out/summary.json");
  EXPECT_EQ(nlohmann::json::parse(written.out), summary);
  const Ended printed = run_program({"relax", file, "--json"});
  ASSERT_EQ(printed.code, 0) << printed.err;
  auto told = nlohmann::json::parse(printed.out);
  EXPECT_THAT(told["files"], IsEmpty());
  told["files"] = summary["files"];
  EXPECT_EQ(test::without_timings(told), test::without_timings(summary));
}

TEST(Relax, ReplacesTheResultsOfAnEarlierRun) {
  const ScratchFolder scratch;
  const std::string one = scratch.write("one.toml", heavy_cantilever()), out = (scratch / "out").string();
  const std::string fresh = (scratch / "fresh").string();
  ASSERT_EQ(run_program({"relax", scratch.write("two.toml", test::two_load_cases()), "--out", out}).code, 0);
  scratch.write("out/notes.txt", "mine");
  ASSERT_EQ(run_program({"relax", one, "--out", out}).code, 0);
  ASSERT_EQ(run_program({"relax", one, "--out", fresh}).code, 0);
  auto expected = results_in(fresh);
  expected["notes.txt"] = "mine";
  expect_same_results(results_in(out), expected);
  ASSERT_EQ(run_program({"solve", one, "--out", out}).code, 0);
  EXPECT_FALSE(fs::exists(scratch / "out/history.csv"));
  EXPECT_THAT(everything_in(out), SizeIs(6));
}

TEST(Relax, ResolvedCaseGivesTheSameFiles) {
  const ScratchFolder scratch;
  const std::string first = (scratch / "a").string(), second = (scratch / "b").string();
  ASSERT_EQ(
      run_program({"relax", scratch.write("case.toml", test::two_load_cases()), "--out", first, "--set",
                   "dynamics.bond_damping={normal = 0.01, bending = 0.02}", "--set", "dynamics.ramp=smooth"})
          .code,
      0);
  const Ended again = run_program({"relax", first + "/case.resolved.toml", "--out", second});
  ASSERT_EQ(again.code, 0) << again.err;
  auto found = results_in(second), expected = results_in(first);
  for (auto* results : {&found, &expected}) {
    auto summary = nlohmann::json::parse(results->at("summary.json"));
    summary.erase("case");
    results->at("summary.json") = summary.dump();
  }
  expect_same_results(found, expected);
}

TEST(Relax, ThreadsDoNotChangeABit) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", R"(title = "block of 1344 bonds"
[[particles]]
lattice = { kind = "simple-cubic", count = [8, 8, 8], spacing = 0.2 }
radius = 0.1
density = 2500
[[bonds]]
law = "timoshenko"
contact_radius_factor = 1.1
young = 1e9
poisson = 0.2
[[supports]]
at = { lowest = { axis = "z", within = 0.01 } }
fix = "all"
[[loads]]
at = { highest = { axis = "z", within = 0.01 } }
force = [1e3, 0, -2e3]
)");
  const auto results = [&](const std::string& threads) {
    const std::string out = (scratch / threads).string();
    const Ended ended = run_program({"relax", file, "--threads", threads, "--out", out});
    EXPECT_EQ(ended.code, 0) << ended.err;
    auto files = results_in(out);
    files.erase("case.resolved.toml");  // tells how many were asked for
    // Frequencies may differ in their last bits: the plan rounds what the run takes from them.
    auto summary = nlohmann::json::parse(files.at("summary.json"));
    auto& plan = summary["load_cases"][0]["plan"];
    plan = {plan["time_step"], plan["ramp_time"], plan["hold_time"]};
    files["summary.json"] = summary.dump();
    return files;
  };
  expect_same_results(results("4"), results("1"));
}

}  // namespace
}  // namespace bondstatic
