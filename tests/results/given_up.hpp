// Writers that are given up before any of their steps: they leave what was there.
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "io/scratch_folder.hpp"

namespace bondstatic::test {

/// write(folder, checkpoint) calls checkpoint() before each of at least `steps` steps. `scratch`/out has what
/// lies there beforehand.
template <class Write>
void expect_all_or_nothing(const ScratchFolder& scratch, int steps, const Write& write) {
  struct GivenUp {};
  const auto before = everything_in(scratch / "out");
  int calls = 0, last = -1;
  const std::function<void()> count = [&] {
    if (++calls == last) throw GivenUp();
  };
  std::filesystem::copy(scratch / "out", scratch / "whole", std::filesystem::copy_options::recursive);
  write(scratch / "whole", count);
  const int all = calls;
  ASSERT_GE(all, steps);
  for (last = 1; last <= all; ++last) {
    calls = 0;
    EXPECT_THROW(write(scratch / "out", count), GivenUp);
    EXPECT_EQ(everything_in(scratch / "out"), before);
  }
}

}  // namespace bondstatic::test
