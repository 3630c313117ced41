// One slip in a sound case.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "bondstatic/error.hpp"

namespace bondstatic::test {

struct Slip {
  std::string name;
  int line;  ///< of the sound case that is replaced
  std::string replacement;
  int fault_line, fault_column;
  std::string message, cure;  ///< parts of them
};

inline void PrintTo(const Slip& slip, std::ostream* out) {
  *out << slip.name;
}

/// One fault, at its place, that says what is wrong and how to cure it.
inline void expect_told(const Slip& slip, const std::vector<Fault>& faults) {
  ASSERT_EQ(faults.size(), 1u) << (faults.empty() ? "read without a fault" : InputError(faults).what());
  EXPECT_EQ(faults[0].place.file, "case.toml");
  EXPECT_EQ(faults[0].place.line, slip.fault_line);
  EXPECT_EQ(faults[0].place.column, slip.fault_column);
  EXPECT_THAT(faults[0].message, testing::HasSubstr(slip.message));
  EXPECT_THAT(faults[0].cure, testing::HasSubstr(slip.cure));
  EXPECT_FALSE(faults[0].cure.empty());
}

}  // namespace bondstatic::test
