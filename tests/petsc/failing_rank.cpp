// A run in which the last rank fails with exit code 5 while the others wait for it in the middle of a sum:
// for ranks_test.cpp.
#include <cstdio>

#include "solver/petsc_module.hpp"

int main() {
  using namespace bondstatic;
  const std::unique_ptr<Ranks> ranks = petsc_module().join_ranks();
  const auto say = [](const RankStatus& status) { std::fprintf(stderr, "%s\n", status.message.c_str()); };
  const double mine = 1;
  if (ranks->rank() + 1 == ranks->size())
    ranks->agree({ExitCode::out_of_memory, "out of memory in the middle"}, say);
  else
    ranks->all_gather({&mine, 1});
  return 0;
}
