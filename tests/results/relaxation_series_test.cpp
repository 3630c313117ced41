// The states that a run to rest keeps on its way, as files.
#include "results/relaxation_series.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bondstatic/error.hpp"
#include "bondstatic/results.hpp"
#include "io/read_by_vtk.hpp"
#include "io/scratch_folder.hpp"
#include "results/given_up.hpp"
#include "results/hand_made.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::everything_in;
using test::read_text;
using test::ScratchFolder;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using testing::UnorderedElementsAre;

struct KeptRun {
  Model model = test::hand_made_model();
  RunInfo info{"a title", "case.toml", "title = \"a title\"\n", true, {}};
  RelaxOptions asked;
  Relaxation relaxation;

  explicit KeptRun(std::vector<std::string> load_cases = {""}) {
    model.load_cases = std::move(load_cases);
    asked.save_interval = 0.5;
    for (const std::string& name : model.load_cases) {
      relaxation.cases.emplace_back();
      relaxation.cases.back().state = test::hand_made_result(name);
      relaxation.cases.back().end = RunEnd::at_rest;
    }
  }

  void show(const fs::path& folder, std::size_t load_case, const SavedState& at) {
    std::vector<SavedState>& saved = relaxation.cases[load_case].saved;
    if (saved.empty() || saved.back().step != at.step) saved.push_back(at);
    std::vector<Vector6> velocity(4, Vector6::Constant(1 / 3.0));
    velocity[3].setConstant(not_given);
    show_relaxation(model, relaxation.cases[load_case].state, velocity, saved, folder.string());
  }
  void show_all(const fs::path& folder) {
    for (std::size_t c = 0; c < relaxation.cases.size(); ++c) {
      show(folder, c, {0, 0});
      show(folder, c, {12345, 0.1 + 0.2});
    }
  }
  std::vector<std::vector<SavedState>> saved() const {
    std::vector<std::vector<SavedState>> all;
    for (const RelaxedCase& one : relaxation.cases) all.push_back(one.saved);
    return all;
  }
  void write(const fs::path& folder, const std::function<void()>& checkpoint = {}) const {
    write_relaxation(model, info, relaxation, {}, folder.string(), checkpoint);
  }
  void check(const fs::path& folder) const { check_relaxation_folder(model, asked, folder.string()); }
  void keep(const fs::path& folder, const std::vector<std::vector<SavedState>>& saved = {}) const {
    keep_shown_relaxation(model, saved, folder.string());
  }
};

TEST(RelaxationSeries, IsPlayedInTime) {
  const ScratchFolder scratch;
  KeptRun run;
  run.show_all(scratch / "out");
  EXPECT_THAT(everything_in(scratch / "out"),
              UnorderedElementsAre("relax.unfinished", "relax.unfinished/relax.pvd",
                                   "relax.unfinished/relax_0000.vtu", "relax.unfinished/relax_12345.vtu"));
  const std::string series = read_text(scratch / "out/relax.unfinished/relax.pvd");
  EXPECT_THAT(series, HasSubstr("timestep=\"0\" part=\"0\" file=\"relax_0000.vtu\""));
  EXPECT_THAT(series, HasSubstr("timestep=\"0.30000000000000004\" part=\"0\" file=\"relax_12345.vtu\""));
  run.write(scratch / "out");
  EXPECT_FALSE(fs::exists(scratch / "out/relax.unfinished"));
  EXPECT_EQ(read_text(scratch / "out/relax.pvd"), series);
  const auto found = test::read_by_vtk((scratch / "out/relax_12345.vtu").string(), scratch);
  const auto rest = test::read_by_vtk((scratch / "out/model.vtu").string(), scratch);
  EXPECT_THAT(found, IsSupersetOf(rest)) << "the grid of a state has what model.vtu has";
  EXPECT_TRUE(found.contains("array point velocity")) << testing::PrintToString(found);
}

TEST(RelaxationSeries, OfSeveralLoadCasesLieInTheirFoldersAndInTheSummary) {
  const ScratchFolder scratch;
  KeptRun run({"push", "pull"});
  run.show_all(scratch / "out");
  EXPECT_THAT(everything_in(scratch / "out"),
              IsSupersetOf({"relax.unfinished/push/relax.pvd", "relax.unfinished/pull/relax_12345.vtu"}));
  run.check(scratch / "out");
  run.write(scratch / "out");
  std::set<std::string> there = everything_in(scratch / "out");
  EXPECT_EQ(there.erase("push") + there.erase("pull"), 2u);
  EXPECT_THAT(there, IsSupersetOf({"push/relax_0000.vtu", "push/relax_12345.vtu", "push/relax.pvd",
                                   "pull/relax_0000.vtu", "pull/relax_12345.vtu", "pull/relax.pvd"}));
  const auto summary = nlohmann::json::parse(read_text(scratch / "out/summary.json"));
  EXPECT_EQ(summary["files"].get<std::set<std::string>>(), there);
}

TEST(RelaxationSeries, OfAnEarlierRunGoesAway) {
  const ScratchFolder scratch;
  KeptRun run({"push", "pull"});
  run.show_all(scratch / "out");
  run.write(scratch / "out");
  KeptRun next;
  next.check(scratch / "out");
  next.show(scratch / "out", 0, {0, 0});
  next.write(scratch / "out");
  EXPECT_THAT(everything_in(scratch / "out"),
              UnorderedElementsAre("summary.json", "case.resolved.toml", "particles.csv", "bonds.csv",
                                   "model.vtu", "history.csv", "relax.pvd", "relax_0000.vtu"));
  KeptRun without;
  without.write(scratch / "out");
  EXPECT_THAT(everything_in(scratch / "out"), Not(Contains(HasSubstr("relax"))));
}

TEST(RelaxationSeries, OfARunThatIsNotAtRestStaysToBeGoneOnWith) {
  const ScratchFolder scratch;
  KeptRun run({"push", "pull"});
  run.show_all(scratch / "out");
  scratch.write("out/relax.checkpoint", "half way");
  run.relaxation.cases[1].end = RunEnd::step_limit;
  run.write(scratch / "out");
  EXPECT_TRUE(fs::exists(scratch / "out/push/relax_12345.vtu"));
  run.check(scratch / "out");
  check_shown_relaxation(run.model, run.saved(), (scratch / "out").string());
  run.relaxation.cases[1].end = RunEnd::at_rest;
  run.write(scratch / "out");
  EXPECT_FALSE(fs::exists(scratch / "out/relax.unfinished"));
}

TEST(RelaxationSeries, LosesWhatIsDroppedOnDemandOnly) {
  const ScratchFolder scratch;
  KeptRun run({"push", "pull"});
  run.show_all(scratch / "out");
  run.relaxation.cases[0].saved = {};
  run.show(scratch / "out", 0, {999, 0.5});
  const fs::path push = scratch / "out/relax.unfinished/push";
  EXPECT_THAT(read_text(push / "relax.pvd"), Not(HasSubstr("relax_0000")));
  EXPECT_TRUE(fs::exists(push / "relax_0000.vtu"));
  run.keep(scratch / "out", run.saved());
  EXPECT_THAT(everything_in(push), UnorderedElementsAre("relax.pvd", "relax_0999.vtu"));
  EXPECT_TRUE(fs::exists(scratch / "out/relax.unfinished/pull/relax_12345.vtu"));
}

TEST(RelaxationSeries, OfARunThatNobodyGoesOnWithIsRemoved) {
  const ScratchFolder scratch;
  KeptRun run({"push", "pull"});
  run.show_all(scratch / "out");
  // What a kill may leave.
  fs::create_directories(scratch / "out/relax.unfinished/push/.bondstatic-abcdef/new");
  scratch.write("out/relax.unfinished/push/.relax.pvd.new", "<?xml");
  KeptRun({"drag"}).keep(scratch / "out");
  EXPECT_THAT(everything_in(scratch / "out"), IsEmpty());
  run.show_all(scratch / "out");
  scratch.write("out/relax.unfinished/notes.txt", "mine");
  run.keep(scratch / "out");
  EXPECT_THAT(everything_in(scratch / "out"),
              UnorderedElementsAre("relax.unfinished", "relax.unfinished/notes.txt"));
}

TEST(RelaxationSeries, WithAMissingStateIsNoticed) {
  const ScratchFolder scratch;
  KeptRun run({"push", "pull"});
  run.show_all(scratch / "out");
  fs::remove(scratch / "out/relax.unfinished/pull/relax_12345.vtu");
  try {
    check_shown_relaxation(run.model, run.saved(), (scratch / "out").string());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_THAT(error.what(),
                HasSubstr("pull/relax_12345.vtu: not there, and relax.checkpoint speaks of it"));
    EXPECT_THAT(error.what(), HasSubstr("cure: "));
  }
}

TEST(RelaxationSeries, GivenUpHalfWayLeavesTheFolderAsItWas) {
  const ScratchFolder scratch;
  KeptRun run({"push", "pull"});
  run.show_all(scratch / "out");
  test::expect_all_or_nothing(
      scratch, 17, [&](const fs::path& folder, const auto& checkpoint) { run.write(folder, checkpoint); });
}

TEST(RelaxationSeries, DoesNotReplaceFilesOfTheUser) {
  for (const char* name : {"relax_0001.vtu", "relax.pvd"}) {
    const ScratchFolder scratch;
    scratch.write(name, "mine");
    KeptRun run;
    EXPECT_THROW(run.check(scratch.path()), Error) << name;
    run.asked.save_interval = not_given;
    EXPECT_NO_THROW(run.check(scratch.path())) << name;
    run.show(scratch.path(), 0, {1, 0.1});
    EXPECT_THROW(run.write(scratch.path()), Error) << name;
    EXPECT_EQ(read_text(scratch / name), "mine");
  }
}

}  // namespace
}  // namespace bondstatic
