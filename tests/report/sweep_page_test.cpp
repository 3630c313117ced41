#include <gmock/gmock.h>

#include "report/found_pages.hpp"
#include "report/sweep_table.hpp"

namespace bondstatic::test {

namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pointwise;

constexpr const char* laws = "bonds.0.law=timoshenko,euler-bernoulli,parallel";
const std::string paper = BONDSTATIC_SOURCE_DIR "/cases/chen2022/";

PageRun page_of(const std::string& csv) {
  const ScratchFolder folder;
  folder.write("sweep.csv", csv);
  return only_run(folder).page;
}

/// [Chen2022] Fig. 10: deflection of beams of 1 to 10 bonds, a curve a law, on a log axis.
TEST(PageOfSweep, DrawsFig10OfThePaper) {
  const ScratchFolder folder;
  run_into(folder, {"sweep", paper + "case2.toml", "--vary", laws, "--vary",
                    "particles.0.line.count=11,2,3,4,5,6,7,8,9,10"});
  const auto csv = CsvColumns::read((folder / "sweep.csv").string());
  const PageRun run = only_run(folder).page;
  EXPECT_EQ(run.title, "Sweep of bonds.0.law, particles.0.line.count");
  const PagePlot& plot = titled(run.plots, "tip");
  EXPECT_EQ(plot.x.label, "particles.0.line.count");
  EXPECT_FALSE(plot.x.log);
  EXPECT_TRUE(plot.y.log);
  ASSERT_EQ(plot.series.size(), 3u);
  const auto tip = csv->numbers("tip");
  for (std::size_t law = 0; law < 3; ++law) {
    const PageSeries& series = plot.series[law];
    EXPECT_EQ(series.draw, PageSeries::Draw::line_and_points);
    EXPECT_THAT(series.x, ElementsAre(2, 3, 4, 5, 6, 7, 8, 9, 10, 11));
    EXPECT_EQ(series.y.back(), tip[10 * law]) << "sorted by the number of particles";
    EXPECT_EQ(series.y.front(), tip[10 * law + 1]);
  }
  EXPECT_EQ(plot.series[2].name, "law = parallel");
  EXPECT_FALSE(titled(run.plots, "moment at the root").y.log);
  EXPECT_FALSE(has_title(run.plots, "moment at the root: difference from law = timoshenko"))
      << "the moment is the same whatever the law";
}

/// [Chen2022] Fig. 12: count and gap change together, the beams do not mind, the parallel bond does.
TEST(PageOfSweep, DrawsFig12OfThePaper) {
  const ScratchFolder folder;
  run_into(folder, {"sweep", paper + "case3.toml", "--vary", laws, "--vary",
                    "particles.0.line.count:bonds.0.gap=2:3.6,3:1.6,5:0.6,11:0"});
  const PageRun run = only_run(folder).page;
  const PagePlot& plot = titled(run.plots, "tip");
  EXPECT_EQ(plot.x.label, "particles.0.line.count");
  ASSERT_EQ(plot.series.size(), 3u) << "the gap makes no curves of its own";
  EXPECT_THAT(named(plot, "law = parallel").x, ElementsAre(2, 3, 5, 11));
  EXPECT_THAT(named(plot, "law = timoshenko").y,
              Pointwise(DoubleNear(1e-12), std::vector(4, 8.534241726238742)));
  EXPECT_FALSE(plot.y.log);
  // Errors in percent of the beam that is exact.
  const PagePlot& error = titled(run.plots, "tip: difference from law = timoshenko");
  EXPECT_EQ(error.y.unit, "%");
  ASSERT_EQ(error.series.size(), 2u);
  EXPECT_NEAR(named(error, "law = euler-bernoulli").y[0], 100 * (8.488263631567748 / 8.534241726238742 - 1),
              1e-10);
}

/// [Chen2022] Fig. 8: deflections along the beam are outputs called by a number.
TEST(PageOfSweep, DrawsFig8OfThePaper) {
  const ScratchFolder folder;
  run_into(folder, {"sweep", paper + "case1.toml", "--vary", laws});
  const PageRun run = only_run(folder).page;
  const PagePlot& plot = titled(run.plots, "Outputs by number: particle");
  EXPECT_THAT(named(plot, "law = parallel").x, ElementsAre(2, 3, 4, 5, 6, 7, 8, 9, 10));
  EXPECT_NEAR(named(plot, "law = timoshenko").y[0], 0.1276776321248316, 1e-14);
  EXPECT_EQ(titled(run.plots, "particle: difference from law = timoshenko").series.size(), 2u);
  const PagePlot& tip = titled(run.plots, "tip");
  EXPECT_THAT(tip.x.categories, ElementsAre("timoshenko", "euler-bernoulli", "parallel"));
  EXPECT_EQ(tip.series.at(0).draw, PageSeries::Draw::bars);
}

TEST(PageOfSweep, FailedPointsAreListedAndNotDrawn) {
  const PageRun run = page_of(
      "bonds.0.law,particles.0.line.count,tip,status\nparallel,2,,invalid-input\nparallel,11,-2,done\n"
      "timoshenko,2,,mechanism\ntimoshenko,11,-4,done\n");
  const PagePlot& plot = titled(run.plots, "tip");
  EXPECT_THAT(named(plot, "law = parallel").x, ElementsAre(11));
  EXPECT_THAT(named(plot, "law = parallel").y, ElementsAre(-2));
  EXPECT_THAT(named(titled(run.plots, "tip: difference from law = timoshenko"), "law = parallel").y,
              ElementsAre(-50));
  const PageTable& failed = titled(run.tables, "Points that failed");
  ASSERT_EQ(failed.rows.size(), 2u);
  EXPECT_EQ(words(cell(failed, 1, "status")), "mechanism");
  EXPECT_EQ(number(cell(failed, 1, "particles.0.line.count")), 2);
  EXPECT_EQ(titled(run.tables, "Points of the sweep").rows.size(), 2u);
  EXPECT_THAT(run.warnings, ElementsAre("2 of 4 points failed; the plots leave them out."));
}

TEST(PageOfSweep, AbscissaeInEvenRatiosAreLogarithmic) {
  const auto log_of = [](const std::vector<std::string>& values) {
    std::string csv = "bonds.0.young,tip,status\n";
    for (const std::string& value : values) csv += value + ",1,done\n";
    return page_of(csv).plots.at(0).x.log;
  };
  EXPECT_TRUE(log_of({"1e9", "1e10", "1e11"}));
  EXPECT_TRUE(log_of({"1", "2", "5", "10", "20", "50", "100"}));
  EXPECT_FALSE(log_of({"1", "50", "100"}));
  EXPECT_FALSE(log_of({"1e9", "1e10", "5e10"}));
  EXPECT_FALSE(log_of({"0", "1", "10", "100"}));
}

TEST(PageOfSweep, KeysMayHaveUnitsTablesAndNoNumbers) {
  const PageRun run = page_of(
      "bonds.0,solve.x,tip,status\n"
      "\"{ law = \"\"a\"\", gap = 1, k = [1, 2] }\",\"\"\"50 GPa\"\"\",1,done\n"
      "\"{ law = \"\"b\"\", gap = 1, k = [1, 2] }\",\"\"\"50 GPa\"\"\",2,done\n"
      "\"{ law = \"\"a\"\", gap = 1, k = [1, 2] }\",\"\"\"70 GPa\"\"\",3,done\n"
      "\"{ law = \"\"b\"\", gap = 1, k = [1, 2] }\",\"\"\"70 GPa\"\"\",4,done\n");
  const PagePlot& plot = titled(run.plots, "tip");
  EXPECT_EQ(plot.x.label, "solve.x");
  EXPECT_EQ(plot.x.unit, "GPa");
  EXPECT_THAT(named(plot, "bonds.0 = law = \"b\"").x, ElementsAre(50, 70));
  EXPECT_THAT(named(plot, "bonds.0 = law = \"b\"").y, ElementsAre(2, 4));
  EXPECT_EQ(words(cell(titled(run.tables, "Points of the sweep"), 0, "solve.x")), "50 GPa");
}

TEST(PageOfSweep, OtherTablesAreRefused) {
  EXPECT_THAT(complaint([] { page_of("bonds.0.law,tip\na,1\n"); }),
              HasSubstr("sweep.csv:1:1: the last column is tip where status must be"));
  EXPECT_THAT(complaint([] { page_of("bonds.0.law,tip,status\na,one,done\n"); }),
              HasSubstr("sweep.csv:2:3: tip = \"one\" is not a number"));
  EXPECT_THAT(page_of("bonds.0.law,tip,status\n").notes, ElementsAre(HasSubstr("has no points")));
}

}  // namespace

}  // namespace bondstatic::test
