#include <gmock/gmock.h>

#include "report/found_pages.hpp"
#include "report/sweep_table.hpp"

namespace bondstatic::test {

namespace {

using testing::_;
using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

constexpr const char* laws = "bonds.0.law=timoshenko,euler-bernoulli,parallel";
const std::string paper = BONDSTATIC_SOURCE_DIR "/cases/chen2022/";

PageRun page_of(const std::string& csv) {
  const ScratchFolder folder;
  folder.write("sweep.csv", csv);
  return only_run(folder).page;
}

const PageSweep::Column& column_of(const PageSweep& sweep, const PageSweep::Abscissa& abscissa) {
  return sweep.columns.at(abscissa.column);
}

std::vector<std::string> abscissae_of(const PageSweep& sweep) {
  std::vector<std::string> names;
  for (const PageSweep::Abscissa& one : sweep.abscissae) names.push_back(column_of(sweep, one).name);
  return names;
}

const PageSweep::Abscissa& abscissa(const PageSweep& sweep, const std::string& name) {
  for (const PageSweep::Abscissa& one : sweep.abscissae)
    if (column_of(sweep, one).name == name) return one;
  throw std::runtime_error("no abscissa " + name);
}

const std::vector<std::string>& curves_over(const PageSweep& sweep, const PageSweep::Abscissa& over) {
  return sweep.curves.at(over.curves).names;
}

/// Pairs of x and y, by rows.
std::vector<std::pair<double, double>> curve(const PageSweep& sweep, const PageSweep::Abscissa& over,
                                             const std::string& ordinate, const std::string& name) {
  const auto& values = sweep.columns.at(titled(sweep.ordinates, ordinate).column).values;
  const PageSweep::Curves& curves = sweep.curves.at(over.curves);
  std::vector<std::pair<double, double>> points;
  for (std::size_t row = 0; row < values.size(); ++row)
    if (curves.names.at(curves.of_row.at(row)) == name && std::isfinite(values[row]))
      points.emplace_back(column_of(sweep, over).values.at(row), values[row]);
  return points;
}

/// [Chen2022] Fig. 10: deflection of beams of 1 to 10 bonds, a curve a law, on a log axis.
TEST(PageOfSweep, DrawsFig10OfThePaper) {
  const ScratchFolder folder;
  run_into(folder, {"sweep", paper + "case2.toml", "--vary", laws, "--vary",
                    "particles.0.line.count=11,2,3,4,5,6,7,8,9,10"});
  const auto csv = CsvColumns::read((folder / "sweep.csv").string());
  const PageRun run = only_run(folder).page;
  EXPECT_EQ(run.title, "Sweep of bonds.0.law, particles.0.line.count");
  const PageSweep& sweep = run.sweep.value();
  EXPECT_THAT(abscissae_of(sweep),
              ElementsAre("number of bonds", "bonds.0.law", "particles.0.line.count", "number of particles",
                          "tip", "rotation of the tip", "moment at the root", "slenderness"));
  EXPECT_TRUE(titled(sweep.ordinates, "tip").log);
  EXPECT_FALSE(titled(sweep.ordinates, "moment at the root").log);
  EXPECT_FALSE(has_title(sweep.ordinates, "moment at the root: difference from law = timoshenko"))
      << "the moment is the same whatever the law";
  const auto tip = csv->numbers("tip");
  for (const char* name : {"number of bonds", "slenderness"}) {
    const PageSweep::Abscissa& over = abscissa(sweep, name);
    EXPECT_FALSE(over.log);
    EXPECT_THAT(curves_over(sweep, over),
                ElementsAre("law = timoshenko", "law = euler-bernoulli", "law = parallel"));
    const auto points = curve(sweep, over, "tip", "law = euler-bernoulli");
    ASSERT_EQ(points.size(), 10u);
    EXPECT_NEAR(points[0].first, 10, 1e-14);
    EXPECT_EQ(points[0].second, tip[10]);
    EXPECT_NEAR(points[1].first, 1, 1e-15) << "a bond is as long as it is thick";
    EXPECT_EQ(points[1].second, tip[11]);
  }
  const PageSweep::Abscissa& law = abscissa(sweep, "bonds.0.law");
  EXPECT_THAT(column_of(sweep, law).categories, ElementsAre("timoshenko", "euler-bernoulli", "parallel"));
  EXPECT_EQ(curves_over(sweep, law).size(), 10u) << "a curve each count";
}

/// [Chen2022] Fig. 12: count and gap change together, the beams do not mind, the parallel bond does.
TEST(PageOfSweep, DrawsFig12OfThePaper) {
  const ScratchFolder folder;
  run_into(folder, {"sweep", paper + "case3.toml", "--vary", laws, "--vary",
                    "bonds.0.gap:particles.0.line.count=3.6:2,1.6:3,0.6:5,0:11"});
  const PageRun run = only_run(folder).page;
  const PageSweep& sweep = run.sweep.value();
  const PageSweep::Abscissa& bonds = sweep.abscissae.at(0);
  EXPECT_EQ(column_of(sweep, bonds).name, "number of bonds");
  EXPECT_EQ(curves_over(sweep, bonds).size(), 3u) << "the gap makes no curves of its own";
  const auto parallel = curve(sweep, bonds, "tip", "law = parallel");
  EXPECT_THAT(parallel, ElementsAre(Pair(1, _), Pair(2, _), Pair(4, _), Pair(10, _)));
  const auto exact = DoubleNear(8.534241726238742, 1e-12);
  EXPECT_THAT(curve(sweep, bonds, "tip", "law = timoshenko"), Each(Pair(_, exact)));
  EXPECT_FALSE(titled(sweep.ordinates, "tip").log);
  // Errors in percent of the beam that is exact.
  const std::string error = "tip: difference from law = timoshenko";
  EXPECT_EQ(sweep.columns.at(titled(sweep.ordinates, error).column).unit, "%");
  EXPECT_THAT(curve(sweep, bonds, error, "law = timoshenko"), IsEmpty());
  const auto short_of = DoubleNear(100 * (8.488263631567748 / 8.534241726238742 - 1), 1e-10);
  EXPECT_THAT(curve(sweep, bonds, error, "law = euler-bernoulli").at(0), Pair(1, short_of));
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
  const PageSweep& sweep = run.sweep.value();
  EXPECT_THAT(abscissae_of(sweep).at(0), "bonds.0.law");
  EXPECT_THAT(column_of(sweep, sweep.abscissae.at(0)).categories,
              ElementsAre("timoshenko", "euler-bernoulli", "parallel"));
  EXPECT_FALSE(has_title(sweep.ordinates, "particle 2")) << "it is drawn by number";
}

TEST(PageOfSweep, CountsAreAbscissaeOfTheirOwnWhereAFactorBrings) {
  const PageRun run = page_of(
      "bonds.0.gap,bonds.0.law,particles,bonds,E,status\n0.1,a,9,20,1,done\n0.1,b,9,20,2,done\n"
      "0.2,a,9,25,3,done\n0.2,b,9,25,4,done\n0.3,a,9,25,5,done\n0.3,b,9,25,6,done\n");
  const PageSweep& sweep = run.sweep.value();
  EXPECT_THAT(abscissae_of(sweep), ElementsAre("bonds.0.gap", "bonds.0.law", "number of bonds", "E"));
  const PageSweep::Abscissa& bonds = abscissa(sweep, "number of bonds");
  EXPECT_THAT(curve(sweep, bonds, "E", "law = a"), ElementsAre(Pair(20, 1), Pair(25, 3), Pair(25, 5)));
  EXPECT_THAT(curve(sweep, abscissa(sweep, "E"), "E", "law = b"),
              ElementsAre(Pair(2, 2), Pair(4, 4), Pair(6, 6)));
}

TEST(PageOfSweep, LatticesCountTheirBondsToo) {
  const PageRun run = page_of(
      "particles.0.lattice.count,particles,bonds,E,status\n"
      "\"[2, 2, 2]\",8,12,1,done\n\"[3, 3, 3]\",27,54,2,done\n");
  EXPECT_THAT(abscissae_of(run.sweep.value()),
              ElementsAre("number of bonds", "particles.0.lattice.count", "number of particles", "E"));
}

TEST(PageOfSweep, FailedPointsAreListedAndNotDrawn) {
  const PageRun run = page_of(
      "bonds.0.law,particles.0.line.count,particles,bonds,tip,status\nparallel,2,,,,invalid-input\n"
      "parallel,11,11,10,-2,done\ntimoshenko,2,2,1,,mechanism\ntimoshenko,11,11,10,-4,done\n");
  const PageSweep& sweep = run.sweep.value();
  const PageSweep::Abscissa& bonds = sweep.abscissae.at(0);
  EXPECT_EQ(column_of(sweep, bonds).name, "number of bonds");
  EXPECT_THAT(curve(sweep, bonds, "tip", "law = parallel"), ElementsAre(Pair(10, -2)));
  EXPECT_THAT(curve(sweep, bonds, "tip: difference from law = timoshenko", "law = parallel"),
              ElementsAre(Pair(10, -50)));
  const PageTable& failed = titled(run.tables, "Points that failed");
  ASSERT_EQ(failed.rows.size(), 2u);
  EXPECT_EQ(words(cell(failed, 1, "status")), "mechanism");
  EXPECT_EQ(number(cell(failed, 1, "particles.0.line.count")), 2);
  EXPECT_EQ(titled(run.tables, "Points of the sweep").rows.size(), 2u);
  EXPECT_THAT(run.warnings, ElementsAre("2 of 4 points failed; the plots leave them out."));
}

TEST(PageOfSweep, AbscissaeInEvenRatiosAreLogarithmic) {
  const auto log_of = [](const std::vector<std::string>& values) {
    std::string csv = "bonds.0.young,particles,bonds,tip,status\n";
    for (const std::string& value : values) csv += value + ",2,1,1,done\n";
    return page_of(csv).sweep.value().abscissae.at(0).log;
  };
  EXPECT_TRUE(log_of({"1e9", "1e10", "1e11"}));
  EXPECT_TRUE(log_of({"1", "2", "5", "10", "20", "50", "100"}));
  EXPECT_FALSE(log_of({"1", "50", "100"}));
  EXPECT_FALSE(log_of({"1e9", "1e10", "5e10"}));
  EXPECT_FALSE(log_of({"0", "1", "10", "100"}));
}

TEST(PageOfSweep, KeysMayHaveUnitsTablesAndNoNumbers) {
  const PageRun run = page_of(
      "bonds.0,solve.x,particles,bonds,tip,status\n"
      "\"{ law = \"\"a\"\", gap = 1, k = [1, 2] }\",\"\"\"50 GPa\"\"\",2,1,1,done\n"
      "\"{ law = \"\"b\"\", gap = 1, k = [1, 2] }\",\"\"\"50 GPa\"\"\",2,1,2,done\n"
      "\"{ law = \"\"a\"\", gap = 1, k = [1, 2] }\",\"\"\"70 GPa\"\"\",2,1,3,done\n"
      "\"{ law = \"\"b\"\", gap = 1, k = [1, 2] }\",\"\"\"70 GPa\"\"\",2,1,4,done\n");
  const PageSweep& sweep = run.sweep.value();
  const PageSweep::Abscissa& over = sweep.abscissae.at(0);
  EXPECT_EQ(column_of(sweep, over).name, "solve.x");
  EXPECT_EQ(column_of(sweep, over).unit, "GPa");
  EXPECT_THAT(curve(sweep, over, "tip", "bonds.0 = law = \"b\""), ElementsAre(Pair(50, 2), Pair(70, 4)));
  EXPECT_EQ(words(cell(titled(run.tables, "Points of the sweep"), 0, "solve.x")), "50 GPa");
}

TEST(PageOfSweep, OtherTablesAreRefused) {
  EXPECT_THAT(complaint([] { page_of("bonds.0.law,tip\na,1\n"); }),
              HasSubstr("sweep.csv:1:1: the last column is tip where status must be"));
  EXPECT_THAT(complaint([] { page_of("bonds.0.law,tip,status\na,1,done\n"); }),
              HasSubstr("sweep.csv:1:1: there are no columns particles and bonds behind the keys"));
  EXPECT_THAT(complaint([] { page_of("bonds.0.law,particles,bonds,tip,status\na,2,1,one,done\n"); }),
              HasSubstr("sweep.csv:2:7: tip = \"one\" is not a number"));
  EXPECT_THAT(page_of("bonds.0.law,particles,bonds,tip,status\n").notes,
              ElementsAre(HasSubstr("has no points")));
}

}  // namespace

}  // namespace bondstatic::test
