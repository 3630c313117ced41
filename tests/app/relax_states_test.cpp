// The states that a run to rest keeps on its way: written, superseded, and the same after a stop.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/relax_cases.hpp"
#include "report/csv_columns.hpp"
#include "report/read_grid.hpp"
#include "results/state_series.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::Ended;
using test::everything_in;
using test::expect_same_results;
using test::read_json;
using test::results_in;
using test::run_program;
using test::ScratchFolder;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class RelaxStates : public testing::Test {
 protected:
  ScratchFolder scratch;
  std::string file = scratch.write("case.toml", test::two_load_cases());
  fs::path out = scratch / "out";

  Ended relax(const fs::path& folder, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{
        "relax", file, "--threads", "1", "--out", folder.string(), "--set", "dynamics.save_interval=0.02"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  /// Steps of the states of a load case that the summary lists, ascending.
  std::vector<Index> steps(const std::string& load_case) const {
    std::vector<Index> found;
    const std::string begins = load_case + "/relax_";
    for (const auto& name : read_json(out / "summary.json")["files"].get<std::vector<std::string>>())
      if (name.starts_with(begins)) found.push_back(std::stol(name.substr(begins.size())));
    return found;
  }
};

TEST_F(RelaxStates, HaveTheDisplacementsOfTheHistory) {
  const Ended ended = relax(out, {"--set", "outputs.0.scale=1"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("states shown"));
  EXPECT_THAT(ended.out, Not(HasSubstr("relax_0000.vtu")));
  const auto summary = read_json(out / "summary.json");
  for (const auto& [load_case, output, place] :
       {std::tuple{0, "tip", "displacement"}, std::tuple{1, "turn", "rotation"}}) {
    const auto& run = summary["load_cases"][std::size_t(load_case)];
    const std::string name = run["name"];
    const auto history = CsvColumns::read((out / name / "history.csv").string());
    const auto step = history->whole_numbers("step");
    const auto value = history->numbers(output);
    const std::vector<Index> states = steps(name);
    ASSERT_GT(states.size(), 5u);
    EXPECT_EQ(states.front(), 0);
    EXPECT_EQ(states.back(), run["steps"].get<Index>());
    for (const Index state : states) {
      const Grid grid({(out / name / (state_file("relax", state))).string()});
      const auto row = std::find(step.begin(), step.end(), state) - step.begin();
      ASSERT_LT(row, std::ptrdiff_t(step.size())) << "states stand at looks";
      EXPECT_EQ(grid.numbers(Grid::Of::points, place)[std::size_t(3 * 10 + (load_case == 0 ? 1 : 0))],
                value[std::size_t(row)]);
    }
    const Grid last({(out / name / (state_file("relax", states.back()))).string()}),
        rest({(out / name / "model.vtu").string()});
    for (const char* column : {"displacement", "rotation", "reaction_force"})
      EXPECT_EQ(last.numbers(Grid::Of::points, column), rest.numbers(Grid::Of::points, column)) << column;
    for (const char* column : {"normal_force", "energy"})
      EXPECT_EQ(last.numbers(Grid::Of::lines, column), rest.numbers(Grid::Of::lines, column)) << column;
    double fastest = 0;
    const auto velocity = last.numbers(Grid::Of::points, "velocity");
    for (std::size_t p = 0; p < velocity.size(); p += 3)
      fastest = std::max(fastest, Eigen::Map<const Vector3>(&velocity[p]).norm());
    EXPECT_LE(fastest, run["fastest_particle"].get<double>());
  }
}

TEST_F(RelaxStates, ChangeNothingElse) {
  ASSERT_EQ(relax(out).code, 0);
  const std::string plain = (scratch / "plain").string();
  ASSERT_EQ(run_program({"relax", file, "--threads", "1", "--out", plain}).code, 0);
  auto with = results_in(out);
  auto without = results_in(plain);
  EXPECT_EQ(std::erase_if(with, [](const auto& one) { return one.first.find("relax") != std::string::npos; }),
            steps("down").size() + steps("twist").size() + 2);
  for (auto* results : {&with, &without}) {
    auto summary = nlohmann::json::parse(results->at("summary.json"));
    summary.erase("files");
    results->at("summary.json") = summary.dump();
    results->erase("case.resolved.toml");
  }
  expect_same_results(with, without);
}

TEST_F(RelaxStates, AreTheSameAfterAStopAtTheLimitOfSteps) {
  ASSERT_EQ(relax(scratch / "whole").code, 0);
  const auto expected = results_in(scratch / "whole");
  for (const char* limit : {"1000", "4321"}) {
    SCOPED_TRACE(limit);
    ASSERT_EQ(relax(out, {"--set", std::string("dynamics.max_steps=") + limit}).code, 4);
    EXPECT_EQ(steps("down").back(), std::stol(limit));
    EXPECT_THAT(everything_in(out), Contains("relax.unfinished"));
    ASSERT_EQ(relax(out, {"--resume"}).code, 0);
    expect_same_results(results_in(out), expected);
    EXPECT_THAT(everything_in(out), Not(Contains("relax.unfinished")));
  }
}

TEST_F(RelaxStates, OfAnEarlierRunGoAway) {
  ASSERT_EQ(relax(out).code, 0);
  const std::string plain = (scratch / "plain").string();
  for (const std::string& folder : {out.string(), plain})
    ASSERT_EQ(run_program({"solve", file, "--out", folder, "--threads", "1"}).code, 0);
  EXPECT_EQ(everything_in(out), everything_in(plain));
}

TEST_F(RelaxStates, ThatAreMissingOrOfAnotherIntervalCannotBeGoneOnWith) {
  ASSERT_EQ(relax(out, {"--set", "dynamics.max_steps=4321"}).code, 4);
  Ended ended = relax(out, {"--resume", "--set", "dynamics.save_interval=0.03"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("other options of [dynamics]"));
  fs::remove(out / "relax.unfinished/twist/relax_0000.vtu");
  const auto before = results_in(out);
  ended = relax(out, {"--resume"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("twist/relax_0000.vtu: not there, and relax.checkpoint speaks of it"));
  expect_same_results(results_in(out), before);
  fs::remove(out / "relax.checkpoint");
  EXPECT_EQ(relax(out).code, 0);
  EXPECT_THAT(everything_in(out), Not(Contains("relax.unfinished")));
}

}  // namespace
}  // namespace bondstatic
