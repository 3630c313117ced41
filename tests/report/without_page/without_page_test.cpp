// A library that was built without npm: linked with page_bundle_missing.cpp in the place of the bundle.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bondstatic/error.hpp"
#include "bondstatic/report.hpp"
#include "io/scratch_folder.hpp"

namespace bondstatic {
namespace {

TEST(WithoutPage, AReportSaysWhatIsMissingAndHowToComeByIt) {
  const test::ScratchFolder scratch;
  const std::string file = (scratch / "report.html").string();
  try {
    write_report({scratch.path().string()}, file);
    FAIL() << "a report without a page";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_THAT(error.what(),
                testing::HasSubstr("npm was not there when it was built\n    cure: install npm"));
  }
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace bondstatic
