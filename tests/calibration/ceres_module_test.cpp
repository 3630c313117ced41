#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include "app/run_program.hpp"

namespace bondstatic::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string example = BONDSTATIC_SOURCE_DIR "/cases/calibration/cantilever-kappa.toml";

// The program starts without Ceres, and the BLAS of its solvers stays its own.
TEST(CeresModule, NothingOfItIsLoadedBeforeItIsAskedFor) {
  setenv("LD_TRACE_LOADED_OBJECTS", "1", 1);
  const Ended ended = run_program({"--version"});
  unsetenv("LD_TRACE_LOADED_OBJECTS");
  EXPECT_THAT(ended.out, HasSubstr("libstdc++"));
  for (const char* library : {"ceres", "glog", "atlas", "f77blas"})
    EXPECT_THAT(ended.out, Not(HasSubstr(library)));
}

TEST(CeresModule, WithoutItCalibrationSaysHowToComeByIt) {
  const ScratchFolder scratch;
  setenv("BONDSTATIC_MODULES", scratch.path().c_str(), 1);
  const Ended nowhere = run_program({"calibrate", "no_such_case.toml"});  // said before anything is read
  scratch.write("libbondstatic_ceres.so", "not a library");
  const Ended broken = run_program({"calibrate", example});
  unsetenv("BONDSTATIC_MODULES");
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_THAT(nowhere.err, AllOf(HasSubstr("libceres-dev"), HasSubstr("BONDSTATIC_CALIBRATION"),
                                 HasSubstr("BONDSTATIC_MODULES")));
  EXPECT_EQ(broken.code, 2);
  EXPECT_THAT(broken.err, HasSubstr("does not load"));
}

TEST(CeresModule, CeresWritesNothing) {
  const Ended ended = run_program({"calibrate", example});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.err.find("Ceres"), std::string::npos);
  EXPECT_EQ(ended.err.find("WARNING"), std::string::npos);
}

}  // namespace
}  // namespace bondstatic::test
