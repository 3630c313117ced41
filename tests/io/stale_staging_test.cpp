#include "io/stale_staging.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "io/child_process.hpp"
#include "io/file_set.hpp"
#include "io/scratch_folder.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::ChildProcess;
using test::everything_in;
using test::read_text;
using test::ScratchFolder;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

fs::path staging_in(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().starts_with(".bondstatic-")) return entry.path();
  return {};
}

void write_a(const fs::path& folder) {
  FileSet files(folder);
  files.create("a").append("a");
  files.commit();
}

/// A file of a staging folder that nobody holds.
void leave(const ScratchFolder& scratch, const std::string& name, const std::string& content) {
  fs::create_directories((scratch / (".bondstatic-aB3dE6/" + name)).parent_path());
  scratch.write(".bondstatic-aB3dE6/" + name, content);
}

TEST(StaleStaging, IsRemovedByTheNextSet) {
  const ScratchFolder scratch;
  ChildProcess([&] {
    FileSet files(scratch.path());
    files.create("large").append(std::string(3 << 20, 'x'));
    _exit(0);
    return 0;
  }).wait();
  ASSERT_NE(staging_in(scratch.path()), fs::path());
  write_a(scratch.path());
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("a"));
}

TEST(StaleStaging, OfALiveProcessIsLeftAlone) {
  const ScratchFolder scratch;
  ChildProcess child([&] {
    FileSet files(scratch / "out");
    files.create("b").append("b");
    scratch.write("started", "");
    while (!fs::exists(scratch / "go on")) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    files.commit();
    return 0;
  });
  while (!fs::exists(scratch / "started")) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  write_a(scratch / "out");
  EXPECT_NE(staging_in(scratch / "out"), fs::path());
  scratch.write("go on", "");
  EXPECT_EQ(child.wait(), 0);
  EXPECT_THAT(everything_in(scratch / "out"), UnorderedElementsAre("a", "b"));
}

TEST(StaleStaging, OfTheSameProcessIsLeftAlone) {
  const ScratchFolder scratch;
  FileSet files(scratch.path());
  files.create("b").append("b");
  write_a(scratch.path());
  files.commit();
  EXPECT_EQ(read_text(scratch / "b"), "b");
}

TEST(StaleStaging, GivesBackWhatWasSetAside) {
  const ScratchFolder scratch;
  scratch.write("present", "present");
  leave(scratch, "old/sub/b", "only copy");
  leave(scratch, "old/present", "older");
  leave(scratch, "new/sub/b", "not committed");
  sweep_stale_staging(scratch.path());
  EXPECT_THAT(everything_in(scratch.path()), UnorderedElementsAre("present", "sub", "sub/b"));
  EXPECT_EQ(read_text(scratch / "sub/b"), "only copy");
  EXPECT_EQ(read_text(scratch / "present"), "present");
}

TEST(StaleStaging, CompletesACommitThatHasSetAllAside) {
  const ScratchFolder scratch;
  scratch.write("a", "second");
  for (const char* name : {"old/a", "old/b", "old/summary"}) leave(scratch, name, "first");
  leave(scratch, "ready/sub/c", "second");
  leave(scratch, "ready/summary", "second");
  sweep_stale_staging(scratch.path());
  EXPECT_THAT(everything_in(scratch.path()), UnorderedElementsAre("a", "sub", "sub/c", "summary"));
  for (const char* name : {"a", "sub/c", "summary"}) EXPECT_EQ(read_text(scratch / name), "second");
}

TEST(StaleStaging, LeavesWhatIsNotOurs) {
  const ScratchFolder scratch;
  for (const char* name : {".bondstatic-backup", ".bondstatic-2", "sub", "sub/.bondstatic-aB3dE6"}) {
    fs::create_directory(scratch / name);
    scratch.write(std::string(name) + "/notes", "precious");
  }
  scratch.write(".bondstatic-abcdef", "a file");
  fs::create_directories(scratch / "sub/real/new");
  fs::create_directory_symlink("sub/real", scratch / ".bondstatic-linked");
  const auto before = everything_in(scratch.path());
  sweep_stale_staging(scratch.path());
  EXPECT_EQ(everything_in(scratch.path()), before);
}

TEST(StaleStaging, MakingAndSweepingAtOnceHarmsNobody) {
  const ScratchFolder scratch;
  const auto repeat = [&](const std::string& name) {
    for (int i = 0; i < 300; ++i) {
      FileSet files(scratch.path());
      files.supersede({name});
      files.create(name).append(std::to_string(i));
      files.commit();
    }
    return 0;
  };
  ChildProcess a([&] { return repeat("a"); }), b([&] { return repeat("b"); }), c([&] { return repeat("c"); });
  EXPECT_EQ(a.wait(), 0);
  EXPECT_EQ(b.wait(), 0);
  EXPECT_EQ(c.wait(), 0);
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("a", "b", "c"));
}

/// Two kinds of result sets; each set has its number in every file.
std::vector<std::string> names_of(int number) {
  if (number % 2 == 0) return {"a", "even/b", "even/c", "summary"};
  return {"a", "odd/d", "summary"};
}

void write_set(const fs::path& folder, int number, Checkpoint checkpoint = {}) {
  FileSet files(folder, std::move(checkpoint));
  if (fs::exists(folder / "summary")) files.supersede(names_of(std::stoi(read_text(folder / "summary"))));
  for (const std::string& name : names_of(number)) files.create(name).append(std::to_string(number));
  files.commit();
}

/// The number of the set; checks that all of it is there and nothing else.
int whole_set_in(const fs::path& folder) {
  const std::string number = read_text(folder / "summary");
  std::vector<std::string> names;
  for (const std::string& name : everything_in(folder)) {
    if (fs::is_directory(folder / name)) continue;
    names.push_back(name);
    EXPECT_EQ(read_text(folder / name), number) << name;
  }
  EXPECT_EQ(names, names_of(std::stoi(number)));
  return std::stoi(number);
}

TEST(StaleStaging, KilledBeforeAnyStepOfACommitTheResultsAreThoseOfOneRun) {
  const ScratchFolder scratch;
  std::vector<int> found;
  for (int allowed = 0;; ++allowed) {
    const fs::path folder = scratch / std::to_string(allowed);
    write_set(folder, 1);
    const int status = ChildProcess([&] {
                         int calls = 0;
                         write_set(folder, 2, [&] {
                           if (calls++ == allowed) ::kill(getpid(), SIGKILL);
                         });
                         return 0;
                       }).wait();
    if (status == 0) break;
    sweep_stale_staging(folder);
    found.push_back(whole_set_in(folder));
  }
  // Four files written, three set aside, four put in place.
  EXPECT_THAT(found, ElementsAre(1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2));
}

TEST(StaleStaging, KilledAtAnyMomentTheResultsAreThoseOfOneRun) {
  const ScratchFolder scratch;
  const fs::path folder = scratch / "out";
  write_set(folder, 0);
  int last = 0, completed = 0;
  for (int round = 1; round <= 200; ++round) {
    ChildProcess child([&] {
      for (int number = 10000 * round;; ++number) write_set(folder, number);
      return 0;
    });
    // Longer where a busy machine lets too few of them get through.
    const int patience = completed * 10 < round ? 8 : 1;
    std::this_thread::sleep_for(std::chrono::microseconds(patience * (500 + 7919 * round % 3000)));
    child.kill();
    sweep_stale_staging(folder);
    const int number = whole_set_in(folder);
    completed += number != last;
    last = number;
    if (HasFailure()) return;
  }
  EXPECT_GT(completed, 10) << "killed too early to tell";
}

}  // namespace
}  // namespace bondstatic
