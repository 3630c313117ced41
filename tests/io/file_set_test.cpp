#include "io/file_set.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bondstatic/error.hpp"
#include "io/file_limits.hpp"
#include "io/scratch_folder.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::everything_in;
using test::FileSizeLimit;
using test::read_text;
using test::ScratchFolder;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// The Error that `action` throws.
template <class Action>
Error error_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error;
  }
  throw std::runtime_error("no error");
}

TEST(FileSet, ShowsNothingBeforeCommitAndAllAfterIt) {
  const ScratchFolder scratch;
  const fs::path folder = scratch / "deep/er/out";
  FileSet files(folder);
  files.create("case/table.csv").append("1,2\n");
  files.create("summary.json").append("{}");
  EXPECT_FALSE(fs::exists(folder / "summary.json"));
  files.commit();
  EXPECT_EQ(read_text(folder / "case/table.csv"), "1,2\n");
  EXPECT_EQ(read_text(folder / "summary.json"), "{}");
}

TEST(FileSet, LeavesNoStagingFolder) {
  const ScratchFolder scratch;
  {
    FileSet files(scratch / "out/");
    files.create("a").append("a");
    files.commit();
  }
  EXPECT_THAT(everything_in(scratch.path()), UnorderedElementsAre("out", "out/a"));
}

TEST(FileSet, AbandonedLeavesNoTraceNotEvenFoldersItMade) {
  const ScratchFolder scratch;
  {
    FileSet files(scratch / "new/out");
    files.create("sub/a").append(std::string(3 << 20, 'x'));
  }
  EXPECT_THAT(everything_in(scratch.path()), IsEmpty());
}

TEST(FileSet, CheckpointThatThrowsAtAnyPointLeavesTheEarlierResultsUntouched) {
  const ScratchFolder scratch;
  const auto write = [&](const std::string& content, int allowed) {
    int calls = 0;
    FileSet files(scratch / "out", [&] {
      if (calls++ == allowed) throw Error(ExitCode::interrupted, "interrupted");
    });
    files.supersede({"a", "old/b", "summary"});
    files.create("a").append(content);
    files.create("new/c").append(content);
    files.create("summary").append(content);
    files.commit();
  };
  {
    FileSet files(scratch / "out");
    for (const char* name : {"a", "old/b", "summary"}) files.create(name).append("first");
    files.commit();
  }
  const auto before = everything_in(scratch.path());
  int interrupted = 0;
  for (;; ++interrupted) {
    try {
      write("second", interrupted);
      break;
    } catch (const Error&) {
      EXPECT_EQ(everything_in(scratch.path()), before);
      for (const char* name : {"out/a", "out/old/b", "out/summary"})
        EXPECT_EQ(read_text(scratch / name), "first");
    }
  }
  // Three files written, three set aside, three renamed.
  EXPECT_EQ(interrupted, 9);
  EXPECT_THAT(everything_in(scratch.path()),
              UnorderedElementsAre("out", "out/a", "out/new", "out/new/c", "out/summary"));
  EXPECT_EQ(read_text(scratch / "out/a"), "second");
}

TEST(FileSet, NeverOverwritesAFileThatIsNotSuperseded) {
  const ScratchFolder scratch;
  scratch.write("bonds.csv", "precious");
  const Error error = error_of([&] {
    FileSet files(scratch.path());
    files.create("a").append("a");
    files.create("bonds.csv").append("new");
    files.commit();
  });
  EXPECT_EQ(error.code(), ExitCode::invalid_input);
  EXPECT_THAT(error.what(), HasSubstr((scratch / "bonds.csv").string()));
  EXPECT_THAT(everything_in(scratch.path()), UnorderedElementsAre("bonds.csv"));
  EXPECT_EQ(read_text(scratch / "bonds.csv"), "precious");
}

TEST(FileSet, FolderBelowAFileIsRefusedByName) {
  const ScratchFolder scratch;
  scratch.write("file", "");
  const fs::path folder = scratch / "file/out";
  for (const Error& error :
       {error_of([&] { FileSet files(folder); }), error_of([&] { check_writable(folder, {}, {}); })}) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_THAT(error.what(), HasSubstr(folder.string()));
  }
  EXPECT_THAT(everything_in(scratch.path()), UnorderedElementsAre("file"));
}

TEST(FileSet, CheckFindsFilesInTheWayBeforeTheWork) {
  const ScratchFolder scratch;
  scratch.write("bonds.csv", "");
  EXPECT_NO_THROW(check_writable(scratch.path(), {"bonds.csv"}, {"bonds.csv"}));
  EXPECT_THROW(check_writable(scratch.path(), {"bonds.csv"}, {}), Error);
  EXPECT_NO_THROW(check_writable(scratch / "not/yet/there", {"bonds.csv"}, {}));
  EXPECT_THAT(everything_in(scratch.path()), UnorderedElementsAre("bonds.csv"));
}

TEST(FileSet, FailedWriteNamesThePathAndLeavesNothing) {
  const ScratchFolder scratch;
  std::string message;
  {
    const FileSizeLimit limit(1 << 16);
    message = error_of([&] {
                FileSet files(scratch / "out");
                files.create("small").append("fits");
                files.create("large").append(std::string(1 << 17, 'x'));
                files.commit();
              }).what();
  }
  EXPECT_THAT(message, HasSubstr((scratch / "out/large").string()));
  EXPECT_THAT(everything_in(scratch.path()), IsEmpty());
}

TEST(FileSet, TakesFilesOfOtherProcessesAndGoesOnWithItsOwn) {
  const ScratchFolder scratch;
  {
    FileSet files(scratch / "out");
    files.create("table").append("one\n");
    files.create("other").append("x");
    std::ofstream(files.shared_folder() / "part") << "two\n" << std::string(3'000'000, '3') << "\n";
    std::ofstream(files.shared_folder() / "foreign") << "theirs";
    files.extend("table").append_file(files.shared_folder() / "part");
    fs::remove(files.shared_folder() / "part");
    files.adopt("foreign");
    EXPECT_EQ(files.bytes(), 4 + 1 + 4 + 3'000'001);
    files.commit();
  }
  EXPECT_EQ(read_text(scratch / "out/table"), "one\ntwo\n" + std::string(3'000'000, '3') + "\n");
  EXPECT_EQ(read_text(scratch / "out/foreign"), "theirs");
  EXPECT_EQ(everything_in(scratch / "out"), (std::set<std::string>{"table", "other", "foreign"}));
}

}  // namespace
}  // namespace bondstatic
