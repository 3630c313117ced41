// Rows over time: names, spacing, thinning, probes.
#include "relax/history.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "relax/relax_models.hpp"

namespace bondstatic::test {
namespace {

using testing::ElementsAre;

std::vector<std::string> names(const RelaxedCase& of) {
  std::vector<std::string> result;
  for (const HistoryColumn& c : of.history) result.push_back(c.name);
  return result;
}

TEST(History, HasTheColumnsPromisedAndThoseOfTheProbe) {
  const Model model = loaded_cantilever();
  RelaxHooks hooks;
  hooks.probe = [](const State& state) {
    return Probes{{"tip y", state.displacement.back()[1]}, {"root force", state.reaction.front()[1]}};
  };
  const RelaxedCase found = relaxed(model, small_kinematics(), hooks);
  EXPECT_THAT(names(found),
              ElementsAre("step", "time", "load_factor", "kinetic", "strain", "work", "dissipated", "balance",
                          "fastest", "unbalanced", "tip y", "root force"));
  const std::size_t rows = column(found, "step").size();
  for (const HistoryColumn& c : found.history) EXPECT_EQ(c.values.size(), rows) << c.name;
  EXPECT_EQ(column(found, "step").front(), 0);
  EXPECT_EQ(column(found, "step").back(), double(found.steps));
  EXPECT_EQ(column(found, "time").back(), found.time);
  EXPECT_EQ(column(found, "tip y").back(), found.state.displacement.back()[1]);
  EXPECT_EQ(column(found, "root force").back(), found.state.reaction.front()[1]);
  EXPECT_EQ(column(found, "strain").back(), found.energies.strain);
  EXPECT_EQ(column(found, "work").back(), found.energies.work);
  EXPECT_EQ(column(found, "fastest").back(), found.unrest.fastest);
  for (std::size_t i = 0; i < rows; ++i) {
    EXPECT_LT(column(found, "balance")[i], 1e-13);
    EXPECT_NEAR(column(found, "load_factor")[i],
                std::min(1.0, column(found, "time")[i] / found.plan.ramp_time), 1e-15);
  }
}

TEST(History, RowsAreARecordIntervalApart) {
  RelaxOptions options = small_kinematics();
  options.record_interval = 0.02;
  const RelaxedCase found = relaxed(loaded_cantilever(), options);
  const std::vector<double>& step = column(found, "step");
  const double stretch = std::floor(0.02 / found.plan.time_step);
  for (std::size_t i = 1; i + 1 < step.size(); ++i) EXPECT_EQ(step[i], stretch * double(i));
  EXPECT_LE(step.back() - step[step.size() - 2], stretch);
}

// However wide the rows, rest is looked for more often than it has to hold.
TEST(History, IntervalBeyondTheHoldTimeIsCutToAQuarterOfIt) {
  RelaxOptions options = small_kinematics();
  options.record_interval = 1e6;
  const RelaxedCase found = relaxed(loaded_cantilever(), options);
  EXPECT_EQ(column(found, "step")[1], std::floor(found.plan.hold_time / 4 / found.plan.time_step));
}

TEST(History, OfALongRunIsThinnedToSomeThousandEvenRows) {
  RelaxOptions options = small_kinematics();
  options.particle_damping = 0;
  options.record_interval = 1e-9;  // every step
  options.max_steps = 20000;
  const RelaxedCase found = relaxed(loaded_cantilever(1), options);
  const std::vector<double>& step = column(found, "step");
  ASSERT_EQ(found.steps, 20000);
  EXPECT_LE(step.size(), 4097u);
  EXPECT_GE(step.size(), 2048u);
  for (std::size_t i = 0; i + 1 < step.size(); ++i) EXPECT_EQ(step[i], 8.0 * double(i));
  EXPECT_EQ(step.back(), 20000);
  for (const HistoryColumn& c : found.history) EXPECT_EQ(c.values.size(), step.size());
}

TEST(History, KeepsEverySecondRowWhereTheyBecomeTooMany) {
  History history;
  Index rows = 0;
  for (Index look = 0; look <= 16384; ++look) {
    if (!history.wants(look)) continue;
    history.add({{"look", double(look)}});
    ++rows;
    ASSERT_LE(history.columns()[0].values.size(), 4096u);
  }
  const std::vector<double>& looks = history.columns()[0].values;
  EXPECT_EQ(rows, 4097 + 2 * 2048);
  ASSERT_EQ(looks.size(), 2049u);
  for (std::size_t i = 0; i < looks.size(); ++i) EXPECT_EQ(looks[i], 8.0 * double(i));
}

}  // namespace
}  // namespace bondstatic::test
