#include "io/replace_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <thread>

#include "bondstatic/error.hpp"
#include "io/child_process.hpp"
#include "io/file_limits.hpp"
#include "io/scratch_folder.hpp"

namespace bondstatic {
namespace {

namespace fs = std::filesystem;
using test::ChildProcess;
using test::everything_in;
using test::FileSizeLimit;
using test::read_text;
using test::ScratchFolder;
using test::WithoutRoot;
using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// What the message of replace_file() says; "" where it succeeds.
std::string refusal(const fs::path& path, const std::string& content) {
  try {
    replace_file(path, content);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::internal);
    return error.what();
  }
}

TEST(ReplaceFile, MakesAndReplacesAndLeavesNothingElse) {
  const ScratchFolder scratch;
  for (const std::string& content :
       {std::string("first\0\xff", 7), std::string(5 << 20, 'x'), std::string(), std::string("short")}) {
    replace_file(scratch / "state", content);
    EXPECT_EQ(read_whole_file(scratch / "state"), content);
    EXPECT_THAT(everything_in(scratch.path()), ElementsAre("state"));
  }
}

TEST(ReplaceFile, TakesANameInTheCurrentFolder) {
  const ScratchFolder scratch;
  const fs::path before = fs::current_path();
  fs::current_path(scratch.path());
  replace_file("state", "here");
  fs::current_path(before);
  EXPECT_EQ(read_text(scratch / "state"), "here");
}

TEST(ReplaceFile, RemovesWhatAKilledOneLeft) {
  const ScratchFolder scratch;
  scratch.write(".state.new", "whole");
  scratch.write(".state.part", "in pie");
  replace_file(scratch / "state", "content");
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("state"));
}

TEST(ReplaceFile, GivesTheFileOrdinaryPermissions) {
  const ScratchFolder scratch;
  const mode_t before = umask(027);
  replace_file(scratch / "state", "content");
  umask(before);
  EXPECT_EQ(fs::status(scratch / "state").permissions(), fs::perms(0640));
}

TEST(ReplaceFile, KeepsALinkAndReplacesWhatItLeadsTo) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "large_disk");
  scratch.write("large_disk/state", "old");
  fs::create_symlink("large_disk/state", scratch / "link");
  replace_file(scratch / "link", "new");
  EXPECT_TRUE(fs::is_symlink(scratch / "link"));
  EXPECT_EQ(read_text(scratch / "large_disk/state"), "new");
}

TEST(ReplaceFile, RefusesWhatIsNoFile) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / "folder");
  fs::create_symlink("nowhere", scratch / "dangling");
  ASSERT_EQ(mkfifo((scratch / "pipe").c_str(), 0600), 0);
  const auto before = everything_in(scratch.path());
  for (const char* name : {"folder", "folder/", "dangling", "pipe", "missing/state", "pipe/state", ""}) {
    EXPECT_THAT(refusal(scratch / name, "content"), StartsWith((scratch / name).string() + ": cannot "));
    EXPECT_EQ(everything_in(scratch.path()), before) << name;
  }
  EXPECT_TRUE(fs::is_fifo(scratch / "pipe"));
}

TEST(ReplaceFile, FailsInAReadOnlyFolderAndKeepsTheOldFile) {
  const ScratchFolder scratch;
  scratch.write("state", "old");
  fs::permissions(scratch.path(), fs::perms(0555));
  {
    const WithoutRoot user;
    EXPECT_THAT(refusal(scratch / "state", "new"), HasSubstr("state: cannot open for writing: Permission"));
  }
  EXPECT_EQ(read_text(scratch / "state"), "old");
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("state"));
  fs::permissions(scratch.path(), fs::perms(0755));
}

TEST(ReplaceFile, FailedWriteLeavesTheOldFileAndNothingElse) {
  const ScratchFolder scratch;
  scratch.write("state", "old");
  {
    const FileSizeLimit limit(1 << 16);
    EXPECT_THAT(refusal(scratch / "state", std::string(1 << 17, 'x')), HasSubstr("state: cannot write: "));
  }
  EXPECT_EQ(read_text(scratch / "state"), "old");
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("state"));
}

/// Where the file system knows no unnamed files.
TEST(ReplaceFile, FallsBackToANamedFile) {
  const ScratchFolder scratch;
  replace_file(scratch / "state", "old", UnnamedFiles::never);
  EXPECT_EQ(read_text(scratch / "state"), "old");
  replace_file(scratch / "state", "new", UnnamedFiles::never);
  {
    const FileSizeLimit limit(1 << 16);
    EXPECT_THROW(replace_file(scratch / "state", std::string(1 << 17, 'x'), UnnamedFiles::never), Error);
  }
  EXPECT_EQ(read_text(scratch / "state"), "new");
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("state"));
}

/// Several lengths, so that no two differ in a prefix only.
std::string numbered(int number) {
  const std::string line = std::to_string(number) + "\n";
  std::string content;
  for (int i = 0; i < 2000 + number % 7 * 9000; ++i) content += line;
  return content;
}

void expect_whole(const fs::path& path) {
  const std::string content = read_text(path);
  ASSERT_FALSE(content.empty());
  EXPECT_TRUE(content == numbered(std::stoi(content))) << path;
}

TEST(ReplaceFile, IsWholeWheneverItIsKilled) {
  const ScratchFolder scratch;
  const fs::path path = scratch / "state";
  replace_file(path, numbered(0));
  std::string last;
  int replaced = 0;
  for (int round = 1; round <= 100; ++round) {
    ChildProcess child([&] {
      for (int number = 1000 * round;; ++number) replace_file(path, numbered(number));
      return 0;
    });
    // Longer where a busy machine lets too few of them get through.
    const int patience = replaced * 5 < round ? 8 : 1;
    std::this_thread::sleep_for(std::chrono::microseconds(patience * (1000 + 7919 * round % 23000)));
    child.kill();
    EXPECT_THAT(everything_in(scratch.path()),
                AnyOf(ElementsAre("state"), ElementsAre(".state.new", "state")));
    expect_whole(path);
    if (fs::exists(scratch / ".state.new")) expect_whole(scratch / ".state.new");
    const std::string now = read_text(path);
    replaced += now != last;
    last = now;
  }
  EXPECT_GT(replaced, 10) << "killed too early to tell";
  replace_file(path, "end");
  EXPECT_THAT(everything_in(scratch.path()), ElementsAre("state"));
}

TEST(ReplaceFile, IsWholeForAReaderAtAnyTime) {
  const ScratchFolder scratch;
  const fs::path path = scratch / "state";
  replace_file(path, numbered(0));
  ChildProcess child([&] {
    for (int number = 1;; ++number) replace_file(path, numbered(number));
    return 0;
  });
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
  while (std::chrono::steady_clock::now() < end) expect_whole(path);
}

TEST(ReadWholeFile, IsNothingWhereThereIsNone) {
  const ScratchFolder scratch;
  scratch.write("file", "");
  EXPECT_EQ(read_whole_file(scratch / "none"), std::nullopt);
  EXPECT_EQ(read_whole_file(scratch / "file/none"), std::nullopt);
  EXPECT_EQ(read_whole_file(scratch / "file"), "");
}

TEST(ReadWholeFile, RefusesWhatCannotBeRead) {
  const ScratchFolder scratch;
  scratch.write("secret", "content");
  fs::permissions(scratch.path(), fs::perms(0755));
  fs::permissions(scratch / "secret", fs::perms(0));
  ASSERT_EQ(mkfifo((scratch / "pipe").c_str(), 0666), 0);
  const WithoutRoot user;
  for (const fs::path& path : {scratch / "secret", scratch / "pipe", scratch.path(), fs::path("/dev/zero")}) {
    try {
      read_whole_file(path);
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::invalid_input);
      EXPECT_THAT(error.what(), StartsWith(path.string() + ": cannot be read: "));
    }
  }
}

}  // namespace
}  // namespace bondstatic
