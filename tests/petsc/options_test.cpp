// Options behind "--", as a user meets them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/run_program.hpp"

namespace bondstatic {
namespace {

using test::cantilever;
using test::Ended;
using test::run_program;
using test::ScratchFolder;
using testing::HasSubstr;
using testing::IsEmpty;

Ended solve_with(const std::string& solver, const std::vector<std::string>& options) {
  const ScratchFolder scratch;
  std::vector<std::string> arguments{"solve", scratch.write("case.toml", cantilever()), "--json", "--solver",
                                     solver};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_program(arguments);
}

TEST(PetscOptions, ReachPetscWhoseWordsGoToStandardError) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--", "-ksp_type", "fcg", "-ksp_view", "-ksp_rtol", "1e-3"},
        std::vector<std::string>{"--", "-ksp_view", "-pc_type", "jacobi"}}) {
    const Ended ended = solve_with("petsc", options);
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_LT(nlohmann::json::parse(ended.out)["outputs"][0]["relative_error"].get<double>(), 1e-13);
    EXPECT_THAT(ended.err, HasSubstr(options[1] == "-ksp_type" ? "type: fcg" : "type: jacobi"));
  }
}

TEST(PetscOptions, NothingAskedNothingSaid) {
  for (const char* solver : {"petsc", "petsc-mumps"}) {
    const Ended ended = solve_with(solver, {});
    EXPECT_EQ(ended.code, 0);
    EXPECT_THAT(ended.err, IsEmpty());
  }
}

struct Wrong {
  const char* solver;
  std::vector<std::string> options;
  const char* named;
};

TEST(PetscOptions, WhatNobodyUnderstandsIsInvalidInputByName) {
  for (const Wrong& wrong : {Wrong{"petsc", {"--", "-ksp_rtool", "1e-6"}, "-ksp_rtool"},
                             Wrong{"petsc-mumps", {"--", "-pc_type", "gamg"}, "-pc_type"},
                             Wrong{"petsc", {"--", "-pc_type", "gamng"}, "gamng"},
                             Wrong{"petsc", {"--", "-ksp_rtol", "small"}, "small"},
                             Wrong{"petsc", {"--", "ksp_rtol", "1e-6"}, "\"ksp_rtol\""}}) {
    const Ended ended = solve_with(wrong.solver, wrong.options);
    EXPECT_EQ(ended.code, 2) << ended.err;
    EXPECT_THAT(ended.out, IsEmpty());
    EXPECT_THAT(ended.err, HasSubstr(wrong.named));
    EXPECT_THAT(ended.err, HasSubstr("cure:"));
  }
}

}  // namespace
}  // namespace bondstatic
