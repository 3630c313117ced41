#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/fracture_cases.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::Ended;
using test::everything_in;
using test::expect_same_results;
using test::fracture_results_in;
using test::read_json;
using test::read_text;
using test::run_program;
using test::ScratchFolder;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::UnorderedElementsAre;

/// Columns of a table by name; "" is NaN.
std::map<std::string, std::vector<double>> columns_of(const fs::path& file) {
  std::istringstream stream(read_text(file));
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> columns;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream fields(line + ',');
    std::size_t i = 0;
    for (std::string field; std::getline(fields, field, ','); ++i) {
      if (columns.size() <= i && names.size() == i) {
        names.push_back(field);
        continue;
      }
      const bool number = !field.empty() && field.find_first_not_of("0123456789.-e+") == std::string::npos;
      columns[names.at(i)].push_back(number ? std::stod(field) : std::nan(""));
    }
  }
  return columns;
}

TEST(FractureCommand, TellsFirstBreakPeakAndEnd) {
  const ScratchFolder scratch;
  const Ended ended = run_program({"fracture", scratch.write("case.toml", test::fibre_bundle())});
  EXPECT_EQ(ended.code, 0) << ended.err;
  for (const char* part : {"16 particles, 8 bonds (contact)", "\n  first break ", "by tension", "\n  peak ",
                           "\n  broken ", "8 bonds in 8 events", "8 by tension", "\n  end ", "\n  energies ",
                           "balance", "\n  accuracy ", "\n  run ", "a break"})
    EXPECT_THAT(ended.out, HasSubstr(part));
  EXPECT_THAT(ended.out, Not(HasSubstr("\033")));
  EXPECT_THAT(ended.err, IsEmpty());
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("case.toml"));
}

TEST(FractureCommand, WritesItsResultsAndASummaryThatListsThem) {
  const ScratchFolder scratch;
  const Ended ended = run_program({"fracture", scratch.write("case.toml", test::fibre_bundle()), "--out",
                                   (scratch / "out").string(), "--set", "fracture.save_every=3"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto there = everything_in(scratch / "out");
  EXPECT_THAT(
      there, testing::IsSupersetOf({"particles.csv", "bonds.csv", "model.vtu", "fracture.csv", "fracture.svg",
                                    "fracture.pvd", "fracture_0000.vtu", "fracture_0003.vtu",
                                    "fracture_0006.vtu", "case.resolved.toml", "summary.json"}));
  const auto summary = read_json(scratch / "out/summary.json");
  EXPECT_EQ(summary["files"].get<std::set<std::string>>(), there);
  EXPECT_EQ(summary["breaks"], 8);
  EXPECT_EQ(summary["control"], "displacement");
  EXPECT_LT(summary["energies"]["balance"].get<double>(), 1e-14);
}

/// F(d) = k d (N - broken): each fibre breaks at its own elongation, the weakest first.
TEST(FractureCommand, FibreBundleFollowsItsClosedForm) {
  const ScratchFolder scratch;
  ASSERT_EQ(run_program({"fracture", scratch.write("case.toml", test::fibre_bundle()), "--out",
                         (scratch / "out").string()})
                .code,
            0);
  const auto columns = columns_of(scratch / "out/fracture.csv");
  const std::vector<double>&d = columns.at("displacement"), &load = columns.at("load");
  ASSERT_THAT(d, SizeIs(8));
  EXPECT_TRUE(std::is_sorted(d.begin(), d.end()));
  double dissipated = 0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    const double force = 100 * d[i] * double(8 - i);
    EXPECT_GE(100 * d[i], 5);
    EXPECT_LE(100 * d[i], 15);
    EXPECT_NEAR(load[i], force, 1e-13 * force);
    EXPECT_NEAR(columns.at("force")[i], force, 1e-13 * force);
    EXPECT_NEAR(columns.at("utilisation")[i], 1, 1e-12);
    if (i + 1 == d.size()) break;  // with the last one the specimen is in two
    EXPECT_NEAR(columns.at("runner_up")[i], d[i] / d[i + 1], 1e-12);
    EXPECT_NEAR(columns.at("displacement_after")[i], d[i], 1e-13 * d[i]);
    EXPECT_NEAR(columns.at("load_after")[i], 100 * d[i] * double(7 - i), 1e-13 * force);
    dissipated += 100 * d[i] * d[i] / 2;
    EXPECT_NEAR(columns.at("dissipated")[i], dissipated, 1e-12 * dissipated);
  }
}

TEST(FractureCommand, JsonIsTheSummaryAndNothingElse) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", test::fibre_bundle());
  const Ended ended = run_program({"fracture", file, "--json", "--out", (scratch / "out").string()});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(nlohmann::json::parse(ended.out), read_json(scratch / "out/summary.json"));
}

TEST(FractureCommand, ReplacesTheResultsOfAnEarlierRun) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", test::fibre_bundle()), out = (scratch / "out").string();
  ASSERT_EQ(run_program({"fracture", file, "--out", out, "--set", "fracture.save_every=1"}).code, 0);
  scratch.write("out/notes.txt", "mine");
  ASSERT_EQ(run_program({"fracture", file, "--out", out}).code, 0);
  ASSERT_EQ(run_program({"fracture", file, "--out", (scratch / "fresh").string()}).code, 0);
  auto expected = fracture_results_in(scratch / "fresh");
  expected["notes.txt"] = "mine";
  expect_same_results(fracture_results_in(out), expected);
  ASSERT_EQ(run_program({"solve", file, "--out", out}).code, 0);
  EXPECT_THAT(everything_in(out), SizeIs(6));
}

TEST(FractureCommand, ResolvedCaseGivesTheSameFiles) {
  const ScratchFolder scratch;
  const std::string first = (scratch / "a").string(), second = (scratch / "b").string();
  ASSERT_EQ(run_program({"fracture", scratch.write("case.toml", test::fibre_bundle()), "--out", first}).code,
            0);
  const Ended again = run_program({"fracture", first + "/case.resolved.toml", "--out", second});
  ASSERT_EQ(again.code, 0) << again.err;
  auto found = fracture_results_in(second), expected = fracture_results_in(first);
  for (auto* results : {&found, &expected}) {
    auto summary = nlohmann::json::parse(results->at("summary.json"));
    summary.erase("case");
    results->at("summary.json") = summary.dump();
  }
  expect_same_results(found, expected);
}

TEST(FractureCommand, StopsWhereItIsAsked) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", test::fibre_bundle());
  const auto end = [&](const std::string& set) {
    const Ended ended = run_program({"fracture", file, "--json", "--set", set});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return nlohmann::json::parse(ended.out)["end"].get<std::string>();
  };
  EXPECT_EQ(end("fracture.max_breaks=3"), "breaks");
  EXPECT_EQ(end("fracture.max_factor=0.06"), "factor");
  EXPECT_EQ(end("fracture.max_displacement=0.06"), "displacement");
  EXPECT_EQ(end("fracture.load_drop=0.5"), "load drop");
}

TEST(FractureCommand, BadInputIsSaidWithItsPlace) {
  const ScratchFolder scratch;
  std::string text = test::pulled_block();
  const std::string strength = "tensile_strength = 1e3";
  text.replace(text.find(strength), strength.size(), "tensile_strength = -5");
  const std::string file = scratch.write("case.toml", text);
  const Ended ended = run_program({"fracture", file, "--out", (scratch / "out").string()});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr(file + ":10:"));
  EXPECT_THAT(ended.err, HasSubstr("tensile_strength = -5"));
  EXPECT_THAT(ended.out, IsEmpty());
  EXPECT_FALSE(fs::exists(scratch / "out"));
}

TEST(FractureCommand, WithoutStrengthsIsBadInput) {
  const ScratchFolder scratch;
  const Ended ended = run_program({"fracture", scratch.write("case.toml", test::cantilever())});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("no bonds have a strength"));
}

TEST(FractureCommand, ThreadsDoNotChangeABit) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", test::pulled_block());
  const auto results = [&](const std::string& threads) {
    const std::string out = (scratch / threads).string();
    const Ended ended = run_program(
        {"fracture", file, "--threads", threads, "--out", out, "--set", "fracture.max_breaks=60"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    auto files = fracture_results_in(out);
    files.erase("case.resolved.toml");  // tells how many were asked for
    files.erase("summary.json");
    return files;
  };
  expect_same_results(results("4"), results("1"));
}

}  // namespace
}  // namespace bondstatic
