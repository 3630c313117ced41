// Pictures of curves.
#include "results/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace bondstatic {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(PlotScale, HasRoundTicksThatCoverAllAndZero) {
  for (const double largest : {1.0, 1.01, 0.37, 6.0, 7.5, 99.0, 2e-7, 3.3e12}) {
    for (const double least : {0.0, -0.2 * largest, 0.9 * largest}) {
      const PlotScale scale = plot_scale({"load", ""}, least, largest);
      EXPECT_LE(scale.low, std::min(0.0, least) + 1e-12 * largest);
      EXPECT_GE(scale.high, largest * (1 - 1e-12));
      const double ticks = (scale.high - scale.low) / scale.tick;
      EXPECT_NEAR(ticks, std::round(ticks), 1e-9);
      EXPECT_GE(ticks, 2.5);
      EXPECT_LE(ticks, 8.5);
      EXPECT_NEAR(scale.low / scale.tick, std::round(scale.low / scale.tick), 1e-9);
      const double mantissa = scale.tick / std::pow(10, std::floor(std::log10(scale.tick * (1 + 1e-9))));
      EXPECT_TRUE(std::abs(mantissa - 1) < 1e-9 || std::abs(mantissa - 2) < 1e-9 ||
                  std::abs(mantissa - 5) < 1e-9)
          << mantissa;
    }
  }
}

TEST(PlotScale, SaysItsUnits) {
  EXPECT_EQ(plot_scale({"load", "N"}, 0, 12500).label, "load, kN");
  EXPECT_EQ(plot_scale({"displacement", "m"}, 0, 4e-4).label, "displacement, µm");
  EXPECT_EQ(plot_scale({"moment", "N m"}, -3, 2).label, "moment, N m");
  EXPECT_EQ(plot_scale({"load", ""}, 0, 3).label, "load");
  EXPECT_EQ(plot_scale({"load", ""}, 0, 2e-5).label, "load, 1e-6");
  EXPECT_EQ(plot_scale({"load", "N"}, 0, 2e21).label, "load, 1e21 N");
}

TEST(PlotScale, OfNothingIsStillAnAxis) {
  const PlotScale scale = plot_scale({"load", "N"}, 0, 0);
  EXPECT_EQ(scale.low, 0);
  EXPECT_EQ(scale.high, 1);
}

Plot sample() {
  Plot plot;
  plot.title = "a < b & \"c\"";
  plot.x = {"displacement", "m"};
  plot.y = {"load", "N"};
  plot.curve = {{0, 0}, {1e-3, 2e3}, {1e-3, 1e3}};
  plot.dots = {{{1e-3, 2e3}, 4}};
  plot.marks = {{{1e-3, 2e3}, "peak <1>"}};
  return plot;
}

TEST(Plot, EscapesItsWords) {
  const std::string svg = plot_svg(sample());
  EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; &quot;c&quot;"));
  EXPECT_THAT(svg, HasSubstr("peak &lt;1&gt;"));
  EXPECT_THAT(svg, HasSubstr("displacement, mm"));
  EXPECT_THAT(svg, HasSubstr("load, kN"));
}

TEST(Plot, CurveGoesThroughItsPoints) {
  // The frame is 688 by 372 pixels from (86, 438); x ends at 1 mm, y at 2.5 kN.
  EXPECT_THAT(plot_svg(sample()), HasSubstr("d=\"M86.00 438.00L774.00 140.40L774.00 289.20\""));
}

TEST(Plot, IsBrokenWhereNothingIsKnown) {
  Plot plot = sample();
  plot.curve.insert(plot.curve.begin() + 1, {std::numeric_limits<double>::quiet_NaN(), 1});
  plot.dots.push_back({{std::numeric_limits<double>::infinity(), 1}, 2});
  plot.marks.push_back({{std::numeric_limits<double>::infinity(), 1}, "far"});
  const std::string svg = plot_svg(plot);
  EXPECT_THAT(svg, HasSubstr("M86.00 438.00M774.00 140.40L"));
  for (const char* word : {"nan", "inf", "far"}) EXPECT_THAT(svg, Not(HasSubstr(word)));
}

TEST(Plot, OfNothingIsAnEmptyFrame) {
  const std::string svg = plot_svg({});
  EXPECT_THAT(svg, HasSubstr("</svg>"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

}  // namespace
}  // namespace bondstatic
