#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "app/relax_cases.hpp"

namespace bondstatic {
namespace {

using test::Ended;
using test::everything_in;
using test::heavy_cantilever;
using test::read_json;
using test::read_text;
using test::run_program;
using test::ScratchFolder;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

const std::vector<std::string> fields{"displacement", "rotation",    "reaction force", "reaction moment",
                                      "bond force",   "bond moment", "energy"};

class CheckProgram : public testing::Test {
 protected:
  ScratchFolder scratch;
  std::string file = scratch.write("case.toml", heavy_cantilever());

  Ended check(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"check", file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  nlohmann::json certificate(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = check(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return nlohmann::json::parse(ended.out);
  }
};

TEST_F(CheckProgram, PrintsACertificateOfFiniteKinematicsByOrders) {
  const Ended ended = check();
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, IsEmpty());
  for (const char* part :
       {"static answer and explicit run, finite kinematics", "relative difference", "largest", "norm",
        "first order", "second order", "third order", "largest at", "verdict    agree within 1e-06",
        "\n  static ", "relative error at most", "at rest after", "\n  rest ", "\n  energies ",
        "\n  time step ", "of the critical", "\n  slowest ", "would be fastest", "times as long"})
    EXPECT_THAT(ended.out, HasSubstr(part));
  for (const std::string& field : fields) EXPECT_THAT(ended.out, HasSubstr("\n  " + field));
  EXPECT_THAT(ended.out, ContainsRegex("displacement +1\\.3e-03 .* particle 11\n"));
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("case.toml"));
}

TEST_F(CheckProgram, PrintsACertificateOfSmallKinematicsWithoutOrders) {
  const Ended ended = check({"--set", "dynamics.kinematics=small"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("small kinematics"));
  EXPECT_THAT(ended.out, HasSubstr("verdict    agree within 1e-06"));
  EXPECT_THAT(ended.out, Not(HasSubstr("order")));
}

TEST_F(CheckProgram, JsonHasAnEntryAField) {
  const auto json = certificate();
  EXPECT_EQ(json["kinematics"], "finite");
  EXPECT_EQ(json["agrees"], true);
  EXPECT_EQ(json["tolerance"], 1e-6);
  ASSERT_THAT(json["load_cases"], SizeIs(1));
  const auto& one = json["load_cases"][0];
  ASSERT_THAT(one["differences"], SizeIs(fields.size()));
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto& field = one["differences"][i];
    EXPECT_EQ(field["field"], fields[i]);
    EXPECT_LE(field["first_order"].get<double>(), 1e-6) << fields[i];
    for (const char* key : {"largest", "norm", "second_order"}) EXPECT_TRUE(field[key].is_number()) << key;
  }
  EXPECT_EQ(one["differences"][0]["largest_at"], nlohmann::json({{"particle", 11}}));
  EXPECT_TRUE(one["differences"][4]["largest_at"].contains("bond"));
  EXPECT_TRUE(one["differences"][6]["largest_at"].is_null());
  EXPECT_LT(one["static"]["forward_error"].get<double>(), 1e-12);
  EXPECT_EQ(one["run"]["end"], "at rest");
  EXPECT_TRUE(one["run"]["plan"]["best_particle_damping"].is_number());
  EXPECT_DOUBLE_EQ(json["ratio"].get<double>() * json["static_seconds"].get<double>(),
                   json["dynamic_seconds"].get<double>());
}

TEST_F(CheckProgram, SmallKinematicsMeetTheStaticAnswerFarBelowTheTolerance) {
  const auto json = certificate({"--set", "dynamics.kinematics=small"});
  for (const auto& field : json["load_cases"][0]["differences"]) {
    EXPECT_LT(field["largest"].get<double>(), 1e-9) << field;
    EXPECT_EQ(field["first_order"], field["largest"]);
    EXPECT_TRUE(field["second_order"].is_null());
    EXPECT_TRUE(field["third_order"].is_null());
  }
}

TEST_F(CheckProgram, WritesTheCertificateAndReplacesAnEarlierOne) {
  const std::string out = (scratch / "out").string();
  scratch.write("case.toml", test::two_load_cases());
  ASSERT_EQ(check({"--out", out}).code, 0);
  EXPECT_THAT(everything_in(out), ElementsAre("certificate.json"));
  const auto json = read_json(scratch / "out/certificate.json");
  ASSERT_THAT(json["load_cases"], SizeIs(2));
  EXPECT_EQ(json["load_cases"][0]["name"], "down");
  EXPECT_EQ(json["load_cases"][1]["name"], "twist");
  const Ended again = check({"--json", "--out", out, "--set", "dynamics.kinematics=small"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(again.out, read_text(scratch / "out/certificate.json"));
  EXPECT_EQ(nlohmann::json::parse(again.out)["kinematics"], "small");
}

TEST_F(CheckProgram, RunThatIsNotAtRestProvesNothing) {
  const std::string out = (scratch / "out").string();
  const Ended ended = check({"--out", out, "--set", "dynamics.max_steps=1000"});
  EXPECT_EQ(ended.code, 4);
  for (const char* part : {"verdict    not at rest", "after 1000 steps", "cure: raise max_steps"})
    EXPECT_THAT(ended.out, HasSubstr(part));
  EXPECT_EQ(read_json(scratch / "out/certificate.json")["agrees"], false);
}

TEST_F(CheckProgram, RunUnderAPartOfTheLoadThatIsNotAtRestProvesNothing) {
  // Half the load takes longer here: its unrest is the same part of less.
  const auto steps = [&](const std::string& force) {
    const Ended ended =
        run_program({"relax", file, "--json", "--set", "loads.0.force=[0, " + force + ", 0]"});
    return nlohmann::json::parse(ended.out)["load_cases"][0]["steps"].get<long>();
  };
  const long whole = steps("-100e3"), half = steps("-50e3");
  ASSERT_LT(whole, half);
  const Ended ended = check({"--set", "dynamics.max_steps=" + std::to_string((whole + half) / 2)});
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.out, HasSubstr("verdict    not at rest under a part of the load"));
}

TEST_F(CheckProgram, DifferenceBeyondTheToleranceIsNamed) {
  // Small kinematics take one run, whatever it shows.
  const std::string small = "dynamics.kinematics=small";
  const Ended ended = check({"--set", small, "--set", "check.tolerance=1e-30"});
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.out,
              HasSubstr("verdict    DIFFER by more than 1e-30 in displacement, rotation, reaction force"));
  const auto json = nlohmann::json::parse(check({"--set", small, "--json"}).out);
  const auto differences = json["load_cases"][0]["differences"];
  std::vector<std::pair<double, std::string>> by_size;
  for (const auto& field : differences)
    by_size.emplace_back(field["first_order"].get<double>(), field["field"]);
  std::sort(by_size.rbegin(), by_size.rend());
  // Between the two largest differences, one field is left to be named.
  const double between = (by_size[0].first + by_size[1].first) / 2;
  const Ended one_left =
      check({"--set", small, "--set", "check.tolerance=" + nlohmann::json(between).dump()});
  EXPECT_EQ(one_left.code, 4);
  EXPECT_THAT(one_left.out, HasSubstr(" in " + by_size[0].second + "\n"));
}

TEST_F(CheckProgram, NeedsADensity) {
  scratch.write("case.toml", test::cantilever());
  const Ended ended = check({"--out", (scratch / "out").string()});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr(file + ":2:1: particles without density"));
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("case.toml"));
}

TEST_F(CheckProgram, UnwritableFolderIsNamedBeforeTheRun) {
  const std::string out = (scratch / "case.toml/out").string();
  const Ended ended = check({"--out", out, "--set", "supports.0.fix=[\"x\"]"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr(out));
}

TEST_F(CheckProgram, MechanismIsTold) {
  const Ended ended = check({"--out", (scratch / "out").string(), "--set", "supports.0.fix=[\"x\"]"});
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("case.toml"));
}

}  // namespace
}  // namespace bondstatic
