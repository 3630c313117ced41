// Results written by several ranks, here threads, beside those of one process.
#include "results/ranked_results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <regex>

#include "bondstatic/error.hpp"
#include "io/read_by_vtk.hpp"
#include "io/scratch_folder.hpp"
#include "results/pieces.hpp"
#include "support/thread_ranks.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::everything_in;
using test::read_text;
using test::ScratchFolder;
using testing::HasSubstr;

const RunInfo info{"a title", "case.toml", "title = \"a title\"\n", true, {"careful"}};
const std::vector<OutputValue> outputs{{"pull", 0.03, 0.02, 1e-9, "a book"}};

struct Writer {
  test::Whole whole = test::whole_answer({"push", "pull"});

  void write(int count, const fs::path& folder, const std::function<void(int rank)>& checkpoint = {},
             const std::function<void(double)>& progress = {}) const {
    const Cut cut(whole.model, test::deal(whole.model, count), count);
    test::run_ranks(count, [&](Ranks& ranks) { write_part(cut, folder, ranks, checkpoint, progress); });
  }

  void write_part(const Cut& cut, const fs::path& folder, Ranks& ranks,
                  const std::function<void(int rank)>& checkpoint = {},
                  const std::function<void(double)>& progress = {}) const {
    const bool first = ranks.rank() == 0;
    const Piece piece = cut.piece(ranks.rank());
    write_results_on_ranks(
        piece, first ? facts_of(whole.model) : ModelFacts{}, first ? info : RunInfo{},
        test::restricted(whole.solution, piece), first ? outputs : std::vector<OutputValue>{},
        folder.string(), ranks, [&, rank = ranks.rank()] { return checkpoint ? checkpoint(rank) : void(); },
        first ? progress : nullptr);
  }

  void write_alone(const fs::path& folder) const {
    write_results(whole.model, info, whole.solution, outputs, folder.string());
  }

  std::set<std::string> files(int count) const {
    const auto names = result_files(facts_of(whole.model), count);
    std::set<std::string> all(names.begin(), names.end());
    all.insert({"push", "pull"});
    return all;
  }
};

/// Every file's content.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const std::string& name : everything_in(folder))
    all[name] = fs::is_directory(folder / name) ? "a folder" : read_text(folder / name);
  return all;
}

/// The header and the rows, these sorted.
std::vector<std::string> sorted_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  std::sort(lines.begin() + 1, lines.end());
  return lines;
}

struct RankedResults : testing::TestWithParam<int> {
  const int count = GetParam();
  const ScratchFolder scratch;
  const Writer run;
};

TEST_P(RankedResults, TablesHaveTheRowsOfOneProcess) {
  run.write(count, scratch / "out");
  run.write_alone(scratch / "alone");
  EXPECT_EQ(everything_in(scratch / "out"), run.files(count));
  for (const char* name : {"push/particles.csv", "push/bonds.csv", "pull/particles.csv", "pull/bonds.csv"})
    EXPECT_EQ(sorted_lines(read_text(scratch / "out" / name)),
              sorted_lines(read_text(scratch / "alone" / name)))
        << name;
}

TEST_P(RankedResults, TablesHaveTheRowsOfOneRankAfterAnother) {
  run.write(count, scratch / "out");
  const std::vector<int> rank_of = test::deal(run.whole.model, count);
  std::string expected;
  for (int rank = 0; rank < count; ++rank)
    for (std::size_t p = 0; p < rank_of.size(); ++p)
      if (rank_of[p] == rank) expected += std::to_string(run.whole.model.particles[p].id) + "\n";
  std::string found;
  std::istringstream lines(read_text(scratch / "out/push/particles.csv"));
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line);) found += line.substr(0, line.find(',')) + "\n";
  EXPECT_EQ(found, expected);
}

TEST_P(RankedResults, SummaryIsThatOfOneProcessButForItsFiles) {
  run.write(count, scratch / "out");
  run.write_alone(scratch / "alone");
  auto summary = nlohmann::json::parse(read_text(scratch / "out/summary.json"));
  auto alone = nlohmann::json::parse(read_text(scratch / "alone/summary.json"));
  EXPECT_EQ(summary["files"], nlohmann::json(result_files(facts_of(run.whole.model), count)));
  alone.erase("files");
  summary.erase("files");
  EXPECT_EQ(summary, alone);
  EXPECT_EQ(read_text(scratch / "out/case.resolved.toml"), info.resolved);
}

/// Of one rank, the grid is model.vtu.
struct RankedGrid : RankedResults {};

TEST_P(RankedGrid, VtkMakesOneGridOfThePieces) {
  run.write(count, scratch / "out");
  run.write_alone(scratch / "alone");
  auto found = test::read_by_vtk((scratch / "out/push/model.pvtu").string(), scratch);
  auto alone = test::read_by_vtk((scratch / "alone/push/model.vtu").string(), scratch);
  EXPECT_EQ(found["cells"], alone["cells"]);

  // The components and then the values, as words.
  const auto words = [](const std::string& text) {
    std::istringstream stream(text);
    return std::vector<std::string>(std::istream_iterator<std::string>(stream), {});
  };
  const auto ghosts = words(found["array point vtkGhostType"]);
  ASSERT_EQ(ghosts.size(), 1 + std::stoul(found["points"]));
  EXPECT_EQ(std::count(ghosts.begin() + 1, ghosts.end(), "0"), std::stol(alone["points"]));
  EXPECT_EQ(std::count(ghosts.begin() + 1, ghosts.end(), "1"),
            std::stol(found["points"]) - std::stol(alone["points"]));

  // A row an id: what VTK finds of the item in all arrays.
  const auto rows = [&](std::map<std::string, std::string>& grid, const std::string& where,
                        bool with_copies) {
    const auto ids = words(grid["array " + where + " id"]);
    std::vector<std::string> all(ids.size());
    for (const auto& [key, text] : grid) {
      const bool position = where == "point" && key == "array position Points";
      if ((!key.starts_with("array " + where + " ") && !position) || key.ends_with("vtkGhostType")) continue;
      if (with_copies && key.find("reaction") != std::string::npos) continue;
      const auto values = words(text);
      const std::size_t width = std::stoul(values[0]);
      for (std::size_t i = 1; i < all.size(); ++i)
        for (std::size_t c = 0; c < width; ++c) all[i] += ' ' + values[1 + width * (i - 1) + c];
    }
    std::multiset<std::string> kept;
    for (std::size_t i = 1; i < all.size(); ++i)
      if (with_copies || !grid.contains("array point vtkGhostType") || where == "cell" || ghosts[i] == "0")
        kept.insert(all[i]);
    return kept;
  };
  EXPECT_EQ(rows(found, "point", false), rows(alone, "point", false));
  EXPECT_EQ(rows(found, "cell", false), rows(alone, "cell", false));
  // Copies are what they are copies of, as far as their rank knows.
  const auto copied = rows(found, "point", true), own = rows(alone, "point", true);
  EXPECT_EQ(std::set<std::string>(copied.begin(), copied.end()),
            std::set<std::string>(own.begin(), own.end()));
  const auto points = words(found["array point id"]);
  const std::string left_out = std::to_string(run.whole.model.particles[5].id);
  const auto reactions = words(found["array point reaction_force"]);
  for (std::size_t i = 1; i < ghosts.size(); ++i)
    EXPECT_EQ(reactions[1 + 3 * (i - 1)] == "nan", ghosts[i] == "1" || points[i] == left_out);
  // Lines end where the bonds do.
  const auto a = words(found["array cell a"]), b = words(found["array cell b"]);
  for (std::size_t k = 0; k < run.whole.model.bonds.size(); ++k) {
    const auto cell = words(found["cell " + std::to_string(k)]);
    ASSERT_EQ(cell.size(), 3u);
    EXPECT_EQ(points.at(1 + std::stoul(cell[1])), a.at(k + 1));
    EXPECT_EQ(points.at(1 + std::stoul(cell[2])), b.at(k + 1));
  }
}

TEST_P(RankedGrid, PiecesHaveTheArraysThatAreDeclared) {
  run.write(count, scratch / "out");
  const auto arrays = [](const std::string& text) {
    std::vector<std::string> found;
    const std::regex array("DataArray (type=\"\\w+\" Name=\"\\w+\" NumberOfComponents=\"\\d\")");
    for (std::sregex_iterator at(text.begin(), text.end(), array), end; at != end; ++at)
      found.push_back((*at)[1]);
    return found;
  };
  const auto declared = arrays(read_text(scratch / "out/pull/model.pvtu"));
  EXPECT_EQ(declared.size(), 9u + 1 + 17 + 1);  // of points, ghosts, of bonds, positions
  for (int rank = 0; rank < count; ++rank) {
    auto there = arrays(read_text(scratch / ("out/pull/model_" + std::to_string(rank) + ".vtu")));
    EXPECT_THAT(there.back(), HasSubstr("types"));
    there.resize(there.size() - 3);  // connectivity, offsets, types
    EXPECT_EQ(there, declared);
  }
}

TEST_P(RankedResults, ReplaceThoseOfOtherNumbersOfRanks) {
  for (const int before : {4, 2, 1, 3}) {
    run.write(before, scratch / "out");
    scratch.write("out/notes.txt", "mine");
    run.write(count, scratch / "out");
    auto files = run.files(count);
    files.insert("notes.txt");
    EXPECT_EQ(everything_in(scratch / "out"), files) << "after " << before << " ranks";
    run.write_alone(scratch / "out");
    files = run.files(1);
    files.insert("notes.txt");
    EXPECT_EQ(everything_in(scratch / "out"), files);
  }
}

TEST_P(RankedResults, FailureOfOneRankLeavesTheFolderAsItWas) {
  run.write(3, scratch / "out");
  const auto before = contents(scratch.path());
  for (int failing = 0; failing < count; ++failing) {
    std::atomic<int> failed = 0, looks = 0;
    const Cut cut(run.whole.model, test::deal(run.whole.model, count), count);
    test::run_ranks(count, [&](Ranks& ranks) {
      try {
        run.write_part(cut, scratch / "out", ranks, [&](int rank) {
          if (rank == failing && ++looks == 4) throw Error(ExitCode::interrupted, "enough");
        });
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::interrupted);
        EXPECT_STREQ(error.what(), "enough");
        ++failed;
      }
    });
    EXPECT_EQ(failed, count);
    EXPECT_EQ(contents(scratch.path()), before) << "rank " << failing;
  }
}

TEST_P(RankedResults, GoIntoNoFolderThatCannotBeMade) {
  scratch.write("file", "mine");
  std::atomic<int> failed = 0;
  const Cut cut(run.whole.model, test::deal(run.whole.model, count), count);
  test::run_ranks(count, [&](Ranks& ranks) {
    try {
      run.write_part(cut, scratch / "file/out", ranks);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::invalid_input);
      EXPECT_THAT(error.what(), HasSubstr("cannot write results here"));
      ++failed;
    }
  });
  EXPECT_EQ(failed, count);
}

TEST_P(RankedResults, ProgressEndsNearTheWhole) {
  std::vector<double> parts;
  run.write(count, scratch / "out", {}, [&](double part) { parts.push_back(part); });
  ASSERT_FALSE(parts.empty());
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  EXPECT_GT(parts.back(), 0.7);
  EXPECT_LE(parts.back(), 1);
}

INSTANTIATE_TEST_SUITE_P(Ranks, RankedResults, testing::Values(1, 2, 3, 4));
INSTANTIATE_TEST_SUITE_P(Ranks, RankedGrid, testing::Values(2, 3, 4));

TEST(RankedResultsOfOneRank, AreThoseOfOneProcess) {
  const ScratchFolder scratch;
  const Writer run;
  run.write(1, scratch / "out");
  run.write_alone(scratch / "alone");
  EXPECT_EQ(contents(scratch / "out"), contents(scratch / "alone"));
}

TEST(RankedResultsOnMoreRanksThanParticles, AreWhole) {
  const ScratchFolder scratch;
  const Writer run;
  run.write(70, scratch / "out");
  run.write_alone(scratch / "alone");
  EXPECT_EQ(sorted_lines(read_text(scratch / "out/pull/bonds.csv")),
            sorted_lines(read_text(scratch / "alone/pull/bonds.csv")));
  auto found = test::read_by_vtk((scratch / "out/pull/model.pvtu").string(), scratch);
  EXPECT_EQ(found["cells"], std::to_string(run.whole.model.bonds.size()));
}

TEST(RankedResultsCheck, KnowsTheNamesOfThePieces) {
  const ScratchFolder scratch;
  const Writer run;
  fs::create_directory(scratch / "pull");
  scratch.write("pull/model_2.vtu", "mine");
  const ModelFacts facts = facts_of(run.whole.model);
  EXPECT_NO_THROW(check_result_folder(facts, scratch.path().string()));
  EXPECT_NO_THROW(check_result_folder(facts, scratch.path().string(), 2));
  EXPECT_THROW(check_result_folder(facts, scratch.path().string(), 3), Error);
  EXPECT_THROW(run.write(3, scratch.path()), Error);
  EXPECT_EQ(everything_in(scratch.path()), (std::set<std::string>{"pull", "pull/model_2.vtu"}));
}

/// A rank on a machine that has other folders.
class Elsewhere final : public Ranks {
 public:
  explicit Elsewhere(Ranks& ranks) : ranks_(ranks) {}
  int rank() const override { return ranks_.rank(); }
  int size() const override { return ranks_.size(); }
  int on_this_machine() const override { return 1; }
  RankStatus agree(const RankStatus& mine, void (*say)(const RankStatus&)) override {
    return ranks_.agree(mine, say);
  }
  std::string scatter(const std::function<std::string(int)>& made) override { return ranks_.scatter(made); }
  std::vector<std::string> gather(const std::string& mine) override { return ranks_.gather(mine); }
  std::string broadcast(const std::string& of_first) override {
    const std::string said = ranks_.broadcast(of_first);
    return said.starts_with("/") && rank() == 1 ? "/nowhere" + said : said;
  }
  std::vector<double> all_gather(std::span<const double> mine) override { return ranks_.all_gather(mine); }
  void exchange(std::span<const Parcel> sent, std::span<const Parcel> taken) override {
    ranks_.exchange(sent, taken);
  }

 private:
  Ranks& ranks_;
};

TEST(RankedResultsOnSeveralMachines, NeedAFolderThatAllSee) {
  const ScratchFolder scratch;
  const Writer run;
  const Cut cut(run.whole.model, test::deal(run.whole.model, 2), 2);
  std::atomic<int> failed = 0;
  test::run_ranks(2, [&](Ranks& ranks) {
    Elsewhere elsewhere(ranks);
    try {
      run.write_part(cut, scratch / "out", elsewhere);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::invalid_input);
      EXPECT_THAT(error.what(), HasSubstr("process 1 does not see"));
      ++failed;
    }
  });
  EXPECT_EQ(failed, 2);
  EXPECT_TRUE(everything_in(scratch.path()).empty());
}

}  // namespace
}  // namespace bondstatic
