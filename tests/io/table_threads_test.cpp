// A table of several megabytes is cut into pieces: what is read and what is said of it must not show that.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>

#include "io/table.hpp"

namespace bondstatic::test {
namespace {

struct Read {
  std::vector<std::string> faults;
  std::vector<Place> places;
  std::vector<std::uint64_t> x;
  std::vector<Index> id;
};

Read read(const std::string& text, int threads) {
  std::vector<Fault> faults;
  Read out;
  if (const auto table = Table::parse(text, "big.csv", faults, threads)) {
    for (const double x : table->numbers(1, true, faults)) out.x.push_back(std::bit_cast<std::uint64_t>(x));
    out.id = table->whole_numbers(0, faults);
    for (Index row = 0; row < table->rows(); ++row) out.places.push_back(table->place(row, 1));
  }
  for (const Fault& fault : faults) out.faults.push_back(to_string(fault));
  return out;
}

/// Rows of unequal length, with comments and empty lines; every `bad`-th row is replaced.
std::string table_text(Index rows, Index bad = 0, const std::string& instead = "") {
  std::mt19937_64 random(11);
  std::string text = "# made\nid,x,\"y\"\n";
  for (Index row = 0; row < rows; ++row) {
    if (random() % 50 == 0) text += "\n# " + std::string(random() % 200, 'c') + "\n";
    if (bad > 0 && row % bad == bad - 1)
      text += instead + "\n";
    else
      text += fmt::format("{}, {} ,\"{}\"{}\n", row, double(random()) * 1e-9, row % 7, row % 3 ? "" : "\r");
  }
  return text;
}

void expect_same(const Read& one, const Read& other) {
  EXPECT_EQ(one.faults, other.faults);
  EXPECT_EQ(one.x, other.x);
  EXPECT_EQ(one.id, other.id);
  ASSERT_EQ(one.places.size(), other.places.size());
  for (std::size_t i = 0; i < one.places.size(); ++i)
    ASSERT_TRUE(one.places[i].line == other.places[i].line && one.places[i].column == other.places[i].column);
}

TEST(TableThreads, SoundTableIsTheSame) {
  constexpr Index rows = 120000;
  const std::string text = table_text(rows);
  ASSERT_GT(text.size(), std::size_t(3) << 20);
  const Read one = read(text, 1);
  EXPECT_TRUE(one.faults.empty());
  ASSERT_EQ(one.id.size(), std::size_t(rows));
  for (Index row = 0; row < rows; ++row) ASSERT_EQ(one.id[std::size_t(row)], row);
  // Lines counted over all pieces: the last row stands in the last line.
  EXPECT_EQ(one.places.back().line, std::count(text.begin(), text.end(), '\n'));
  for (const int threads : {2, 4}) expect_same(one, read(text, threads));
}

TEST(TableThreads, FaultsAreTheSameAndInOrder) {
  for (const std::string wrong : {"1,2", "1,\"2,3", "1,two,3", ",2,3"})
    for (const Index every : {37, 20000}) {
      const std::string text = table_text(60000, every, wrong);
      const Read one = read(text, 1);
      EXPECT_EQ(one.faults.size(), std::size_t(std::min<Index>(60000 / every, 21))) << wrong;
      expect_same(one, read(text, 3));
    }
}

TEST(TableThreads, TheLineOfAFaultIsThatOfTheText) {
  std::string text = "id,x,y\n";
  int lines = 1;
  for (; text.size() < std::size_t(5) << 19; ++lines) text += "1,2,3\n";
  text += "1,2\n" + std::string("4,5,6\n");
  EXPECT_EQ(read(text, 4).faults.at(0).substr(0, 40),
            fmt::format("big.csv:{}:1: the row has 2 fields, the header 3", lines + 1).substr(0, 40));
}

}  // namespace
}  // namespace bondstatic::test
