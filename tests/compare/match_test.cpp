#include "compare/match.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/turning.hpp"
#include "support/models.hpp"

namespace bondstatic {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A row of particles, one apart, that have moved by 1e-3 times their number along y.
struct Dumped {
  Model model = test::chain(test::block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.2}}),
                            {0, 0, 0}, {9, 0, 0}, 9, 0.5);
  State statics;
  ParticleState state;
  std::vector<Fault> faults;

  Dumped() {
    statics.displacement.assign(10, Vector6::Zero());
    for (std::size_t p = 0; p < 10; ++p) {
      state.id.push_back(model.particles[p].id);
      state.position.push_back(model.particles[p].position + Vector3(0, 1e-3 * double(p), 0));
      statics.displacement[p].y() = 1e-3 * double(p);
    }
  }
  std::optional<RunState> match() { return match_particles(model, statics, state, "dump", faults); }
  std::string fault() {
    EXPECT_FALSE(match());
    EXPECT_EQ(faults.size(), 1u);
    return faults.empty() ? "" : to_string(faults.front());
  }
};

TEST(MatchParticles, DisplacementsGoById) {
  Dumped run;
  std::swap(run.state.id[2], run.state.id[7]);
  std::swap(run.state.position[2], run.state.position[7]);
  const auto found = run.match();
  ASSERT_TRUE(found);
  for (std::size_t p = 0; p < 10; ++p) EXPECT_NEAR(found->displacement[p].y(), 1e-3 * double(p), 1e-18) << p;
  EXPECT_FALSE(found->has_rotations);
  EXPECT_TRUE(std::isnan(found->displacement[3][4]));
  EXPECT_THAT(found->missing, IsEmpty());
}

TEST(MatchParticles, RotationsComeFromQuaternions) {
  Dumped run;
  for (std::size_t p = 0; p < 10; ++p)
    run.state.orientation.push_back(quaternion(Vector3(0, 0, 1e-8 * double(p))));
  const auto found = run.match();
  ASSERT_TRUE(found && found->has_rotations);
  EXPECT_NEAR(found->displacement[9][5], 9e-8, 1e-22);
}

TEST(MatchParticles, MissingAndUnknownOnesAreListed) {
  Dumped run;
  run.state.id[4] = 77;
  const auto found = run.match();
  ASSERT_TRUE(found);
  EXPECT_THAT(found->missing, ElementsAre(5));
  EXPECT_THAT(found->unknown, ElementsAre(77));
  EXPECT_TRUE(std::isnan(found->displacement[4].x()));
}

TEST(MatchParticles, TooFewAreAnotherPacking) {
  Dumped run;
  for (Index& id : run.state.id) id += 6;
  EXPECT_THAT(run.fault(), HasSubstr("only 4 of the case's 10 particles are in the run"));
}

TEST(MatchParticles, AnIdMayComeOnlyOnce) {
  Dumped run;
  run.state.id[3] = 1;
  EXPECT_THAT(run.fault(), HasSubstr("particle 1 comes twice"));
}

TEST(MatchParticles, OtherUnitsAreRecognised) {
  Dumped run;
  for (Vector3& x : run.state.position) x *= 1000;
  EXPECT_THAT(run.fault(), HasSubstr("positions are 1000 times the case's"));
}

TEST(MatchParticles, AnotherOriginIsRecognised) {
  Dumped run;
  for (Vector3& x : run.state.position) x += Vector3(0.5, 0, -1);
  EXPECT_THAT(run.fault(), HasSubstr("shifted by (0.5, 0, -1)"));
}

TEST(MatchParticles, OtherIdsAreRecognised) {
  Dumped run;
  std::swap(run.state.position[0], run.state.position[6]);
  std::swap(run.state.position[3], run.state.position[8]);
  EXPECT_THAT(run.fault(), HasSubstr("another packing"));
}

TEST(MatchParticles, AcrossAPeriodicFaceTheNearestImageCounts) {
  Dumped run;
  Cell cell;
  cell.edges = Vector3(10, 10, 10).asDiagonal();
  cell.periodic = {true, false, false};
  run.state.cell = cell;
  run.state.position[0].x() += 10 - 0.01;
  const auto found = run.match();
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->displacement[0].x(), -0.01, 1e-14);
}

// So far away some particles come back on the other side.
TEST(MatchParticles, WhereOneParticleHoldsACellTheRunMayLieElsewhere) {
  Dumped run;
  run.model.cell = Cell{{0, 0, 0}, Vector3(10, 10, 10).asDiagonal()};
  for (std::size_t p = 0; p < 10; ++p) {
    run.state.position[p] += Vector3(4, -2, 0.5);
    if (run.state.position[p].x() > 10) run.state.position[p].x() -= 10;
  }
  Support held;
  held.particle = 3;
  held.fixed = {true, true, true, false, false, false};
  run.model.supports = {held};
  auto found = run.match();
  ASSERT_TRUE(found) << to_string(run.faults.at(0));
  for (std::size_t p = 0; p < 10; ++p)
    EXPECT_LT((found->displacement[p] - run.statics.displacement[p]).head<3>().norm(), 1e-14) << p;
  ASSERT_EQ(found->notes.size(), 1u);
  EXPECT_THAT(found->notes[0], HasSubstr("shifted by (-4, 2, -0.5)"));
  EXPECT_THAT(found->notes[0], HasSubstr("particle 4"));

  // Two places that are held tell where the cell is.
  held.particle = 5;
  run.model.supports.push_back(held);
  EXPECT_THAT(run.fault(), HasSubstr("all particles are shifted"));
}

TEST(MatchParticles, RadiiThatDifferAreNoted) {
  Dumped run;
  run.state.radius.assign(10, 0.5);
  run.state.radius[6] = 0.505;
  const auto found = run.match();
  ASSERT_TRUE(found);
  ASSERT_EQ(found->notes.size(), 1u);
  EXPECT_THAT(found->notes[0], HasSubstr("particle 7, by 0.01"));
}

}  // namespace

}  // namespace bondstatic
