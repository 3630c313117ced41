#include "report/csv_columns.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "report/found_pages.hpp"
#include "report/thinned.hpp"

namespace bondstatic::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(CsvOfResults, OutputsMayBeCalledAnything) {
  const ScratchFolder folder;
  const auto csv = CsvColumns::read(folder.write(
      "a.csv", "time,Time,\"a, \"\"b\"\"\",force #2,12,x;y,nan\n1,2,3,4,5,6,7\n8,,10,11,12,13,14\n"));
  ASSERT_TRUE(csv);
  EXPECT_THAT(csv->names(), ElementsAre("time", "Time", "a, \"b\"", "force #2", "12", "x;y", "nan"));
  EXPECT_THAT(csv->numbers("time"), ElementsAre(1, 8));
  EXPECT_THAT(csv->numbers("force #2"), ElementsAre(4, 11));
  EXPECT_THAT(csv->numbers("12"), ElementsAre(5, 12));
  EXPECT_THAT(csv->numbers("nan"), ElementsAre(7, 14));
  EXPECT_EQ(csv->numbers("Time")[0], 2);
  EXPECT_TRUE(std::isnan(csv->numbers("Time")[1]));
}

TEST(CsvOfResults, ATableMayHaveNoRowsAndAFileMayNotBeThere) {
  const ScratchFolder folder;
  const auto csv = CsvColumns::read(folder.write("a.csv", "step,load\n"));
  ASSERT_TRUE(csv);
  EXPECT_EQ(csv->rows(), 0);
  EXPECT_TRUE(csv->numbers("load").empty());
  EXPECT_FALSE(CsvColumns::read((folder / "b.csv").string()));
}

TEST(CsvOfResults, FaultsNameFileLineAndColumn) {
  const ScratchFolder folder;
  const auto said = [&](const std::string& text) {
    return complaint([&] { CsvColumns::read(folder.write("a.csv", text))->numbers("load"); });
  };
  EXPECT_THAT(said("step,load\n1,2\n3,four\n"), HasSubstr("a.csv:3:3: load = \"four\" is not a number"));
  EXPECT_THAT(said("step,load\n1,2,3\n"), HasSubstr("a.csv:2:1: the row has 3 fields, the header 2"));
  EXPECT_THAT(said("step,loads\n1,2\n"), HasSubstr("a.csv:1:1: there is no column load, but step, loads"));
  EXPECT_THAT(said("\n1,2\n"), HasSubstr("a.csv:1:1: the first line is empty"));
}

TEST(ThinnedCurve, KeepsEndsPeaksAndGaps) {
  PageSeries series{"a", {}, {}, PageSeries::Draw::line};
  for (int i = 0; i < 200'000; ++i) {
    series.x.push_back(i);
    series.y.push_back(i == 77'777    ? 1e6
                       : i == 123'456 ? -1e6
                       : i == 150'000 ? std::nan("")
                                      : std::sin(0.001 * i));
  }
  PageSeries points = series;
  ASSERT_TRUE(thin(series));
  EXPECT_LE(series.x.size(), 5u * parts_of_thin_series);
  EXPECT_EQ(series.x.size(), series.y.size());
  EXPECT_EQ(series.x.front(), 0);
  EXPECT_EQ(series.x.back(), 199'999);
  EXPECT_TRUE(std::is_sorted(series.x.begin(), series.x.end()));
  const auto at = [&](double x) {
    const auto found = std::find(series.x.begin(), series.x.end(), x);
    return found == series.x.end() ? 0 : series.y[std::size_t(found - series.x.begin())];
  };
  EXPECT_EQ(at(77'777), 1e6);
  EXPECT_EQ(at(123'456), -1e6);
  EXPECT_TRUE(std::isnan(at(150'000)));
  points.draw = PageSeries::Draw::points;
  EXPECT_FALSE(thin(points));
}

}  // namespace

}  // namespace bondstatic::test
