#include "report/result_folder.hpp"

#include <gmock/gmock.h>

#include "bondstatic/version.hpp"
#include "report/found_pages.hpp"

namespace bondstatic::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace fs = std::filesystem;

std::string said_of(const fs::path& folder) {
  return complaint([&] { read_results(folder.string()); });
}

constexpr const char* two_load_cases = R"({"bondstatic": "9.9.9", "units": "SI", "load_cases": [
  {"name": "a/b", "folder": "a%2Fb", "energy": 1}, {"name": "", "folder": "unnamed", "energy": 2}]})";

TEST(ResultFolder, NoFolderNoResultsAndMisspeltFoldersAreToldApart) {
  const ScratchFolder folder;
  fs::create_directory(folder / "results");
  EXPECT_THAT(said_of(folder / "results"), HasSubstr("results: has no results: summary.json (solve, relax"));
  EXPECT_THAT(said_of(folder / "results"), HasSubstr("bondstatic solve CASE --out DIR"));
  EXPECT_THAT(said_of(folder / "resluts"), HasSubstr("is not there\n    cure: did you mean"));
  EXPECT_THAT(said_of(folder / "resluts/"), HasSubstr((folder / "results").string()));
  EXPECT_THAT(said_of(folder / "quite another"), HasSubstr("bondstatic solve CASE --out DIR"));
  folder.write("results/case.toml", "");
  EXPECT_THAT(said_of(folder / "results"), HasSubstr("has a case, but no results"));
  folder.write("results/relax.checkpoint", "");
  EXPECT_THAT(said_of(folder / "results"), HasSubstr("bondstatic relax CASE --out"));
  EXPECT_THAT(said_of(folder / "results/case.toml"),
              HasSubstr("is a file where a folder of results must be"));
}

TEST(ResultFolder, DamagedFilesAreRefused) {
  const ScratchFolder folder;
  folder.write("summary.json", "{\"bondstatic\": ");
  EXPECT_THAT(said_of(folder.path()), HasSubstr("summary.json:1:16: is no JSON"));
  folder.write("summary.json", "{\"title\": \"a\"}");
  EXPECT_THAT(said_of(folder.path()),
              HasSubstr("bondstatic is missing and must be the version that wrote it"));
  folder.write("summary.json", R"({"bondstatic": "0.1.0", "load_cases": [{"energy": "much"}]})");
  EXPECT_THAT(said_of(folder.path()), HasSubstr("load_cases[0].energy = \"much\" must be a number"));
  folder.write("summary.json", R"({"bondstatic": "0.1.0", "at_rest": 3})");
  EXPECT_THAT(said_of(folder.path()), HasSubstr("bondstatic relax CASE"));
  fs::remove(folder / "summary.json");
  fs::create_directory(folder / "summary.json");
  EXPECT_THAT(said_of(folder.path()), HasSubstr("is a folder"));
}

TEST(ResultFolder, LoadCasesLeadToTheirGridsAndNowhereElse) {
  const ScratchFolder folder;
  folder.write("summary.json", two_load_cases);
  fs::create_directory(folder / "a%2Fb");
  folder.write("a%2Fb/model.vtu", "");
  const FoundRun run = only_run(folder);
  EXPECT_EQ(run.page.kind, "solve");
  EXPECT_TRUE(run.si);
  ASSERT_EQ(run.states.size(), 1u);
  EXPECT_EQ(run.states[0].load_case, "a/b");
  EXPECT_THAT(run.states[0].files, ElementsAre((folder / "a%2Fb/model.vtu").string()));
  ASSERT_EQ(run.page.notes.size(), 2u);
  EXPECT_THAT(run.page.notes[0], HasSubstr("Written by bondstatic 9.9.9, shown by " + version()));
  EXPECT_THAT(run.page.notes[1], HasSubstr("unnamed/model.vtu is not there"));
  const PageTable& table = titled(run.page.tables, "Load cases");
  EXPECT_EQ(number(cell(table, 1, "strain energy, J")), 2);
  EXPECT_EQ(table.columns.size(), 2u) << "what nothing is known of has no column";

  for (const char* outside : {"..", "/etc", "a/../..", "."}) {
    nlohmann::json json = nlohmann::json::parse(two_load_cases);
    json["load_cases"][0]["folder"] = outside;
    folder.write("summary.json", json.dump());
    EXPECT_THAT(said_of(folder.path()), HasSubstr("load_cases[0].folder = ")) << outside;
  }
}

TEST(ResultFolder, PiecesOfRanksMakeOneState) {
  const ScratchFolder folder;
  folder.write("summary.json", R"({"bondstatic": "0.1.0", "load_cases": [{"name": ""}]})");
  const auto listing = [](const std::string& second) {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\">\n<PUnstructuredGrid "
           "GhostLevel=\"0\">\n"
           "<Piece Source=\"model_0.vtu\"/>\n<Piece " +
           second + "/>\n</PUnstructuredGrid>\n</VTKFile>\n";
  };
  for (const char* piece : {"model_0.vtu", "model_1.vtu"}) folder.write(piece, "");
  folder.write("model.pvtu", listing("Source=\"model_1.vtu\""));
  const FoundRun run = only_run(folder);
  ASSERT_EQ(run.states.size(), 1u);
  EXPECT_THAT(run.states[0].files,
              ElementsAre((folder / "model_0.vtu").string(), (folder / "model_1.vtu").string()));
  folder.write("model.pvtu", listing("Source=\"model_2.vtu\""));
  EXPECT_THAT(only_run(folder).states, IsEmpty());
  EXPECT_THAT(only_run(folder).page.notes.back(),
              HasSubstr("model_2.vtu is not there, and model.pvtu names it"));
  folder.write("model.pvtu", listing("Source=\"../model_1.vtu\""));
  EXPECT_THAT(said_of(folder.path()),
              HasSubstr("model.pvtu:5:2: \"../model_1.vtu\" must be the name of a file"));
  folder.write("model.pvtu", listing("Sauce=\"model_1.vtu\""));
  EXPECT_THAT(said_of(folder.path()), HasSubstr("model.pvtu:5:2: has no Source"));
  folder.write("model.pvtu", "<VTKFile><PUnstructuredGrid>");
  EXPECT_THAT(said_of(folder.path()), HasSubstr("is no XML"));
}

TEST(ResultFolder, OneFolderMayHaveSeveralKinds) {
  const ScratchFolder folder;
  const std::string json = R"({"bondstatic": "0.1.0", "title": "</script><b>"})";
  for (const char* name : {"summary.json", "certificate.json", "calibration.json"}) folder.write(name, json);
  folder.write("sweep.csv", "bonds.0.law,particles,bonds,tip,status\nparallel,2,1,1,done\n");
  folder.write("case.resolved.toml", "title = \"solved\"\n");
  folder.write("calibrated.toml", "title = \"calibrated\"\n");
  std::vector<std::string> kinds, cases;
  for (const FoundRun& run : read_results(folder.path().string())) {
    kinds.push_back(run.page.kind);
    cases.push_back(run.page.resolved_case);
    EXPECT_EQ(run.page.folder, folder.path().string());
  }
  EXPECT_THAT(kinds, ElementsAre("solve", "check", "calibrate", "sweep"));
  EXPECT_THAT(cases, ElementsAre("title = \"solved\"\n", "", "title = \"calibrated\"\n", ""));
  EXPECT_EQ(read_results(folder.path().string())[0].page.title, "</script><b>");
}

}  // namespace

}  // namespace bondstatic::test
