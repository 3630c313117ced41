// How many noisy trials a test of 95 % intervals makes, and how many may miss.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace bondstatic::test {

/// BONDSTATIC_FULL=1 asks for the long variant.
inline int coverage_trials(int otherwise) {
  const char* full = std::getenv("BONDSTATIC_FULL");
  return full != nullptr && std::string(full) == "1" ? 400 : otherwise;
}

/// Of 400 trials 95 +- 3 % must be inside; of fewer as many as scatter allows: 3 % is 2.75 standard
/// deviations of the count of 400.
inline void expect_coverage(int inside, int trials) {
  const double allowed = 0.03 * std::sqrt(400. / trials);
  EXPECT_NEAR(double(inside) / trials, 0.95, allowed) << inside << " of " << trials;
}

}  // namespace bondstatic::test
