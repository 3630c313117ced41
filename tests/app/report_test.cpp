// The command `report`, and --report of the others.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/run_program.hpp"

namespace bondstatic {
namespace {

using test::cantilever;
using test::Ended;
using test::read_text;
using test::run_program;
using test::ScratchFolder;
using testing::HasSubstr;
using testing::Not;

constexpr const char* head = "<!doctype html>\n<!-- bondstatic report -->\n";

/// What the page is told.
nlohmann::json page_data(const std::string& file) {
  const std::string text = read_text(file), begin = "id=\"page-data\">";
  const std::size_t from = text.find(begin) + begin.size();
  return nlohmann::json::parse(text.substr(from, text.find("</script>", from) - from));
}

Ended solved(const ScratchFolder& scratch, const std::string& folder,
             const std::vector<std::string>& more = {}) {
  const std::string file = scratch.write("case.toml", cantilever());
  std::vector<std::string> arguments{"solve", file, "--out", folder};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments);
}

TEST(ReportCommand, ShowsAFolderOfResultsInAFileBesideThem) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "results").string();
  ASSERT_EQ(solved(scratch, folder).code, 0);
  const Ended ended = run_program({"report", folder});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr(folder + "/report.html"));
  const std::string text = read_text(folder + "/report.html");
  EXPECT_TRUE(text.starts_with(head));
  const nlohmann::json data = page_data(folder + "/report.html");
  ASSERT_EQ(data["runs"].size(), 1u);
  const nlohmann::json& run = data["runs"][0];
  EXPECT_EQ(run["kind"], "solve");
  EXPECT_EQ(run["scene"]["all_particles"], 11);
  EXPECT_EQ(run["scene"]["all_bonds"], 10);
  EXPECT_THAT(run["resolved_case"].get<std::string>(), HasSubstr("[[particles]]"));
}

TEST(ReportCommand, SeveralFoldersLieSideBySideInOneFile) {
  const ScratchFolder scratch;
  const std::string one = (scratch / "one").string(), other = (scratch / "other").string(),
                    file = (scratch / "both.html").string();
  ASSERT_EQ(solved(scratch, one).code, 0);
  ASSERT_EQ(solved(scratch, other, {"--set", "bonds.0.law=euler-bernoulli"}).code, 0);
  const Ended ended = run_program({"report", one, other, "--out", file});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const nlohmann::json data = page_data(file);
  ASSERT_EQ(data["runs"].size(), 2u);
  EXPECT_EQ(data["runs"][0]["folder"], one);
  EXPECT_EQ(data["runs"][1]["folder"], other);
}

TEST(ReportCommand, SameResultsMakeTheSameBytes) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "results").string();
  ASSERT_EQ(solved(scratch, folder, {"--report"}).code, 0);
  const std::string first = read_text(folder + "/report.html");
  ASSERT_EQ(run_program({"report", folder}).code, 0);
  EXPECT_EQ(read_text(folder + "/report.html"), first);
}

TEST(ReportCommand, TextOfACaseIsNeverATag) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "results").string(), title = "</script><script>alert(1)</script><!--";
  ASSERT_EQ(solved(scratch, folder, {"--set", "title=" + title, "--report"}).code, 0);
  const std::string text = read_text(folder + "/report.html");
  EXPECT_THAT(text, Not(HasSubstr("alert(1)</script>")));
  EXPECT_EQ(page_data(folder + "/report.html")["runs"][0]["title"], title);
}

TEST(ReportCommand, AnotherFileIsNotOverwritten) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "results").string(),
                    file = scratch.write("letter.html", "<p>Dear colleague");
  ASSERT_EQ(solved(scratch, folder).code, 0);
  const Ended ended = run_program({"report", folder, "--out", file});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr(file + ": exists, and is no report\n    cure: "));
  EXPECT_EQ(read_text(file), "<p>Dear colleague");
}

TEST(ReportCommand, AFolderWithoutResultsIsNamedAndTheCureTold) {
  const ScratchFolder scratch;
  for (const std::string& folder : {(scratch / "nowhere").string(), scratch.path().string()}) {
    const Ended ended = run_program({"report", folder, "--out", (scratch / "report.html").string()});
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.err, HasSubstr(folder));
    EXPECT_THAT(ended.err, HasSubstr("cure: "));
    EXPECT_FALSE(std::filesystem::exists((scratch / "report.html").string()));
  }
}

TEST(ReportCommand, AFolderToWriteToMustBeThere) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "results").string();
  ASSERT_EQ(solved(scratch, folder).code, 0);
  const Ended ended = run_program({"report", folder, "--out", (scratch / "no/such/report.html").string()});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("no such folder"));
}

TEST(ReportOption, NeedsAFolderBeforeAnythingIsSolved) {
  const ScratchFolder scratch;
  const Ended ended = run_program({"solve", scratch.write("case.toml", cantilever()), "--report"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("give --out DIR"));
  EXPECT_EQ(ended.out, "");
}

TEST(ReportOption, JsonKeepsStandardOutputToItself) {
  const ScratchFolder scratch;
  const Ended ended = solved(scratch, (scratch / "results").string(), {"--report", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(nlohmann::json::accept(ended.out));
  EXPECT_THAT(ended.err, HasSubstr("report.html"));
}

TEST(ReportOption, NewResultsTakeAnOldReportAway) {
  const ScratchFolder scratch;
  const std::string folder = (scratch / "results").string();
  ASSERT_EQ(solved(scratch, folder, {"--report"}).code, 0);
  ASSERT_TRUE(std::filesystem::exists(folder + "/report.html"));
  ASSERT_EQ(solved(scratch, folder).code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder + "/report.html"));
}

TEST(ReportOption, EveryCommandThatWritesResultsHasIt) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("case.toml", cantilever());
  const std::string density = "particles.0.density=7850";
  const std::vector<std::vector<std::string>> commands{{"relax", file, "--set", density},
                                                       {"check", file, "--set", density},
                                                       {"sweep", file, "--vary", "bonds.0.young=1e9,2e9"}};
  for (const std::vector<std::string>& command : commands) {
    const std::string folder = (scratch / command.front()).string();
    std::vector<std::string> arguments = command;
    for (const std::string& more : {std::string("--out"), folder, std::string("--report")})
      arguments.push_back(more);
    const Ended ended = run_program(arguments);
    ASSERT_EQ(ended.code, 0) << command.front() << ended.err;
    const nlohmann::json data = page_data(folder + "/report.html");
    ASSERT_EQ(data["runs"].size(), 1u);
    EXPECT_EQ(data["runs"][0]["kind"], command.front());
    EXPECT_FALSE(data["runs"][0]["plots"].empty() && data["runs"][0]["sweep"].empty()) << command.front();
  }
}

}  // namespace
}  // namespace bondstatic
