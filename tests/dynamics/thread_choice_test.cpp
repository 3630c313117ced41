#include "dynamics/thread_choice.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace bondstatic {
namespace {

using std::chrono::milliseconds;

/// Goes through so many calls and says how the last one ran. The first trial meets `at_first` a step, what
/// comes later `later`; one thread alone always takes 2 ms.
bool ends_together(int calls, milliseconds at_first, milliseconds later) {
  constexpr Index steps = 20;
  ThreadChoice choose;
  bool last = false;
  for (int call = 0; call < calls; ++call)
    choose(steps, [&](Index count, bool together) {
      last = together;
      for (Index n = 0; n < count; ++n)
        std::this_thread::sleep_for(!together ? milliseconds(2) : call == 0 ? at_first : later);
    });
  return last;
}

TEST(ThreadChoice, TakesTheFasterWay) {
  EXPECT_TRUE(ends_together(8, milliseconds(0), milliseconds(0)));
  EXPECT_FALSE(ends_together(3, milliseconds(20), milliseconds(20)));
}

TEST(ThreadChoice, RepeatsATrialThatWentWrong) {
  EXPECT_TRUE(ends_together(8, milliseconds(20), milliseconds(0)));
}

TEST(ThreadChoice, GoesBackToOneThreadWhenCoresAreTaken) {
  EXPECT_FALSE(ends_together(8, milliseconds(0), milliseconds(20)));
}

}  // namespace
}  // namespace bondstatic
