#include "io/csv_writer.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <sstream>

#include "io/file_set.hpp"
#include "io/scratch_folder.hpp"

namespace bondstatic {
namespace {

std::string written(const std::vector<Column>& columns) {
  const test::ScratchFolder scratch;
  FileSet files(scratch / "out");
  write_csv(files.create("table.csv"), columns);
  files.commit();
  return test::read_text(scratch / "out/table.csv");
}

TEST(CsvWriter, HeaderThenRowsAndNothingForNaN) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(
      written({{"id", std::vector<Index>{7, (Index(1) << 53) + 1}}, {"u, v", std::vector<double>{0.1, nan}}}),
      "id,\"u, v\"\n7,0.1\n9007199254740993,\n");
}

TEST(CsvWriter, WithoutRowsThereIsStillAHeader) {
  EXPECT_EQ(written({{"id", std::vector<Index>{}}, {"x", std::vector<double>{}}}), "id,x\n");
}

TEST(CsvWriter, EveryFiniteDoubleReadsBackBitwise) {
  std::mt19937_64 random(20260);
  std::vector<double> values{0.0,
                             -0.0,
                             1e-323,
                             5e-324,
                             0.1,
                             1.0 / 3,
                             std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::min(),
                             -8.534242e-3};
  while (values.size() < 100000)
    if (const double value = std::bit_cast<double>(random()); std::isfinite(value)) values.push_back(value);
  std::istringstream lines(written({{"x", values}}));
  std::string line;
  std::getline(lines, line);
  for (const double value : values) {
    ASSERT_TRUE(std::getline(lines, line));
    ASSERT_LE(line.size(), 24u);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(std::strtod(line.c_str(), nullptr)),
              std::bit_cast<std::uint64_t>(value))
        << line;
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(CsvWriter, QuotesWhatWouldBreakTheTable) {
  EXPECT_EQ(csv_field("plain"), "plain");
  EXPECT_EQ(csv_field("[1, 2]"), "\"[1, 2]\"");
  EXPECT_EQ(csv_field("say \"so\""), "\"say \"\"so\"\"\"");
}

}  // namespace
}  // namespace bondstatic
