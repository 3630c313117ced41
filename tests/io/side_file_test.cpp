#include "io/side_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <thread>

#include "bondstatic/error.hpp"
#include "io/file_limits.hpp"
#include "io/scratch_folder.hpp"

namespace bondstatic {
namespace {

using test::everything_in;
using test::read_text;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(SideFile, IsPartOfItsSet) {
  for (const int threads : {1, 2, 4}) {
    const test::ScratchFolder scratch;
    std::optional<FileSet> set(std::in_place, scratch / "out", Checkpoint(), threads);
    FileSet& files = *set;
    std::thread::id writer;
    int threads_of_file = 0;
    SideFile side(files, "case/side", [&](OutputFile& file) {
      writer = std::this_thread::get_id();
      threads_of_file = file.threads();
      for (int i = 0; i < 300'000; ++i) file.append("side ");
    });
    for (const char* name : {"one", "two"}) files.create(name).append(std::string(3'000'000, 'x'));
    side.finish();
    EXPECT_EQ(writer == std::this_thread::get_id(), threads == 1);
    EXPECT_EQ(threads_of_file, 1);
    files.create("last").append("last");
    files.commit();
    EXPECT_EQ(files.bytes(), 1'500'000 + 6'000'000 + 4);
    set.reset();
    EXPECT_EQ(read_text(scratch / "out/case/side").size(), 1'500'000u);
    EXPECT_THAT(everything_in(scratch / "out"),
                testing::UnorderedElementsAre("case", "case/side", "one", "two", "last"));
  }
}

void write_until_stopped(OutputFile& file) {
  for (;;) {
    file.append(std::string(100'000, 'x'));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(SideFile, AnErrorBesideItEndsIt) {
  const test::ScratchFolder scratch;
  try {
    FileSet files(scratch / "out", {}, 2);
    SideFile side(files, "side", write_until_stopped);
    throw std::runtime_error("beside it");
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "beside it");
  }
  EXPECT_THAT(everything_in(scratch.path()), IsEmpty());
}

TEST(SideFile, AnInterruptIsSeenWhileItIsWaitedFor) {
  const test::ScratchFolder scratch;
  int looks = 0;
  EXPECT_THROW(
      {
        FileSet files(
            scratch / "out",
            [&] {
              if (++looks == 3) throw std::runtime_error("interrupt");
            },
            2);
        SideFile side(files, "side", write_until_stopped);
        side.finish();
      },
      std::runtime_error);
  EXPECT_EQ(looks, 3);
  EXPECT_THAT(everything_in(scratch.path()), IsEmpty());
}

TEST(SideFile, ItsErrorNamesItAndLeavesNothing) {
  for (const int threads : {1, 2}) {
    const test::ScratchFolder scratch;
    const test::FileSizeLimit limit(1 << 16);
    try {
      FileSet files(scratch / "out", {}, threads);
      SideFile side(files, "side", [](OutputFile& file) { file.append(std::string(1 << 20, 'x')); });
      files.create("table").append("fits");
      side.finish();
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr((scratch / "out/side").string()));
    }
    EXPECT_THAT(everything_in(scratch.path()), IsEmpty());
  }
}

}  // namespace
}  // namespace bondstatic
