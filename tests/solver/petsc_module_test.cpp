#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include "app/run_program.hpp"

namespace bondstatic {
namespace {

using test::cantilever;
using test::Ended;
using test::run_program;
using test::ScratchFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// Seen by the program that the test starts.
struct ModulesIn {
  explicit ModulesIn(const std::string& folder) { setenv("BONDSTATIC_MODULES", folder.c_str(), 1); }
  ~ModulesIn() { unsetenv("BONDSTATIC_MODULES"); }
};

TEST(PetscModule, WithoutItThePetscSolversSayHowToComeByOne) {
  const ScratchFolder scratch;
  const ModulesIn nowhere(scratch.path().string());
  const std::string file = scratch.write("case.toml", cantilever());
  for (const char* solver : {"petsc", "petsc-mumps"}) {
    const Ended ended = run_program({"solve", file, "--solver", solver});
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.err, AllOf(HasSubstr("petsc-dev"), HasSubstr("BONDSTATIC_PETSC"),
                                 HasSubstr("BONDSTATIC_MODULES")));
  }
  EXPECT_THAT(run_program({"solvers"}).out, Not(HasSubstr("petsc")));
}

TEST(PetscModule, WhatIsNoModuleIsAnErrorNotACrash) {
  const ScratchFolder scratch;
  const ModulesIn here(scratch.path().string());
  scratch.write("libbondstatic_petsc.so", "not a library");
  const Ended ended = run_program({"solve", scratch.write("case.toml", cantilever()), "--solver", "petsc"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("does not load"));
}

TEST(PetscModule, OtherSolversTakeNoOptionsOfALibrary) {
  const ScratchFolder scratch;
  const Ended ended = run_program(
      {"solve", scratch.write("case.toml", cantilever()), "--solver", "eigen", "--", "-ksp_rtol", "1"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("-ksp_rtol 1"));
}

}  // namespace
}  // namespace bondstatic
