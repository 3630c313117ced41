// What the solver takes of the machine, and gives back.
#include "solver/machine.hpp"

#include <gtest/gtest.h>
#include <omp.h>
#include <unistd.h>

namespace bondstatic::test {
namespace {

TEST(Machine, ThreadsWorthHavingStayWithinWhatIsAsked) {
  EXPECT_EQ(threads_worth_having(1), 1);
  EXPECT_LE(threads_worth_having(100000), sysconf(_SC_NPROCESSORS_ONLN));
  for (const int most : {2, 4, 1000}) {
    const int threads = threads_worth_having(most);
    EXPECT_GE(threads, 1);
    EXPECT_LE(threads, most);
  }
}

TEST(Machine, OpenMpRegionsAreSerialWhileTheSolverRuns) {
  const int before = omp_get_max_active_levels();
  ASSERT_GT(before, 0);
  {
    const SolverThreads guard(2);
    EXPECT_EQ(omp_get_max_active_levels(), 0);
  }
  EXPECT_EQ(omp_get_max_active_levels(), before);
}

TEST(Machine, MemoryFiguresAreBytes) {
  EXPECT_GT(available_memory(), 1e7);
  EXPECT_GT(peak_resident_memory(), 1e6);
  EXPECT_LT(peak_resident_memory(), 1e12);
}

}  // namespace
}  // namespace bondstatic::test
