#include "io/line_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/number_field.hpp"
#include "io/scratch_folder.hpp"

namespace bondstatic::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Reading {
  std::vector<std::string> lines;
  std::vector<Fault> faults;
};

Reading read_all(const std::string& text) {
  const ScratchFolder folder;
  Reading reading;
  auto reader = LineReader::open(folder.write("t", text), {"case.toml", 2, 1}, reading.faults);
  while (reader) {
    const auto line = reader->next(reading.faults);
    if (!line) break;
    reading.lines.emplace_back(*line);
  }
  EXPECT_EQ(reader && reader->failed(), !reading.faults.empty());
  return reading;
}

TEST(LineReader, GivesLinesWithoutTheirEndsAndTheByteOrderMark) {
  EXPECT_THAT(read_all("\xEF\xBB\xBF"
                       "a b\r\n\n c\n")
                  .lines,
              ElementsAre("a b", "", " c"));
  EXPECT_THAT(read_all("a\nb").lines, ElementsAre("a", "b"));
  EXPECT_THAT(read_all("").lines, ElementsAre());
  EXPECT_THAT(read_all("\n").lines, ElementsAre(""));
}

TEST(LineReader, LinesDoNotDependOnWhereTheBufferEnds) {
  std::string text;
  std::vector<std::string> lines;
  for (std::size_t i = 0; text.size() < 3'000'000; ++i) {
    lines.push_back(std::to_string(i) + std::string(i * i % 9973, 'x'));
    text += lines.back() + "\n";
  }
  EXPECT_EQ(read_all(text).lines, lines);
}

TEST(LineReader, ALineMayHaveOneMebibyteAndNotMore) {
  const std::string longest(1 << 20, 'x');
  EXPECT_EQ(read_all("a\n" + longest + "\nb\n").lines.size(), 3u);
  const Reading reading = read_all("a\n" + longest + "x\nb\n");
  EXPECT_THAT(reading.lines, ElementsAre("a"));
  ASSERT_EQ(reading.faults.size(), 1u);
  EXPECT_EQ(reading.faults[0].place.line, 2);
  EXPECT_THAT(reading.faults[0].message, HasSubstr("1 MiB"));
  EXPECT_FALSE(read_all(std::string(50'000'000, 'x')).faults.empty());
}

TEST(LineReader, NulBytesAreAFaultWithTheirPlace) {
  const Reading reading = read_all(std::string("ab\ncd\0e\n", 8));
  EXPECT_THAT(reading.lines, ElementsAre("ab"));
  ASSERT_EQ(reading.faults.size(), 1u);
  EXPECT_EQ(reading.faults[0].place.line, 2);
  EXPECT_EQ(reading.faults[0].place.column, 3);
  EXPECT_THAT(reading.faults[0].message, HasSubstr("binary"));
}

TEST(LineReader, WhatIsNoFileIsAFaultOfWhoNamesIt) {
  const ScratchFolder folder;
  for (const std::string& path :
       {(folder / "none").string(), folder.path().string(), std::string("/dev/null"), std::string()}) {
    std::vector<Fault> faults;
    EXPECT_FALSE(LineReader::open(path, {"case.toml", 2, 1}, faults)) << path;
    ASSERT_EQ(faults.size(), 1u) << path;
    EXPECT_EQ(faults[0].place.file, "case.toml");
    EXPECT_EQ(faults[0].place.line, 2);
  }
}

TEST(LineReader, GoesBackToALine) {
  const ScratchFolder folder;
  std::string text;
  for (int i = 1; i <= 100'000; ++i) text += "line " + std::to_string(i) + "\n";
  std::vector<Fault> faults;
  auto reader = LineReader::open(folder.write("t", text), {}, faults);
  std::vector<std::uint64_t> offsets;
  while (reader->next(faults)) offsets.push_back(reader->offset());
  EXPECT_EQ(reader->part(), 1);
  for (const int line : {1, 77'777, 3, 99'999, 100'000}) {
    reader->go_to(offsets[std::size_t(line - 1)], line, faults);
    EXPECT_EQ(reader->next(faults), "line " + std::to_string(line));
    EXPECT_EQ(reader->line(), line);
    EXPECT_TRUE(reader->line_ended());
  }
  EXPECT_FALSE(reader->next(faults));
  EXPECT_TRUE(faults.empty());
}

TEST(LineReader, KnowsWhetherALineHasItsEnd) {
  const ScratchFolder folder;
  std::vector<Fault> faults;
  auto reader = LineReader::open(folder.write("t", "a\nb"), {}, faults);
  EXPECT_EQ(reader->next(faults), "a");
  EXPECT_TRUE(reader->line_ended());
  EXPECT_EQ(reader->next(faults), "b");
  EXPECT_FALSE(reader->line_ended());
}

TEST(NumberField, TakesWhatIsANumberAndNothingElse) {
  EXPECT_EQ(number_field("0.0064093101982724259"), 0.0064093101982724259);
  EXPECT_EQ(number_field("+1e3"), 1000);
  EXPECT_EQ(number_field("4.9406564584124654e-324"), 4.9406564584124654e-324);
  EXPECT_TRUE(std::isinf(number_field("1e400")));
  for (const char* text : {"", "+", "+-1", "1,5", "0x10", "1 ", "e5", "1.5.2"})
    EXPECT_TRUE(std::isnan(number_field(text))) << text;
  EXPECT_EQ(whole_number_field("-12"), -12);
  EXPECT_EQ(whole_number_field("9223372036854775807"), 9223372036854775807);
  for (const char* text : {"", "+-1", "12.0", "9223372036854775808", "1e3", "x"})
    EXPECT_FALSE(whole_number_field(text)) << text;
}

TEST(NumberField, SplitsAtBlanksUpToAComment) {
  std::vector<std::string_view> fields{"old"};
  split_at_blanks("  1\t2.5  a#b # c d", fields);
  EXPECT_THAT(fields, ElementsAre("1", "2.5", "a#b"));
  split_at_blanks(" # all", fields);
  EXPECT_TRUE(fields.empty());
}

}  // namespace
}  // namespace bondstatic::test
