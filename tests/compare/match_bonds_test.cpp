#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/match.hpp"
#include "compare/runs.hpp"

namespace bondstatic {

namespace {

using testing::HasSubstr;

/// Every other bond with its particles in the other order; forces as they act on the particle that is named
/// second, or first.
struct Written {
  Model model = test::packing();
  State statics = test::static_state(model);
  RunState run = test::ended_in(statics);
  BondState bonds;
  std::vector<Fault> faults;

  explicit Written(bool on_second, bool along = false, bool times_length = false) {
    for (std::size_t k = 0; k < model.bonds.size(); ++k) {
      const Bond& bond = model.bonds[k];
      const Index a = model.particles[std::size_t(bond.a)].id, b = model.particles[std::size_t(bond.b)].id;
      const bool turned = k % 2 == 1;
      bonds.a.push_back(turned ? b : a);
      bonds.b.push_back(turned ? a : b);
      Vector6 force = statics.bonds[k].force;
      if (along) force.head<3>() = -statics.bonds[k].normal_force * bond.branch.normalized();
      if (times_length) force *= bond.branch.norm();
      if (turned == on_second) force = -force;
      const char* names[] = {"fx", "fy", "fz", "mx", "my", "mz"};
      for (int i = 0; i < (along ? 3 : 6); ++i) bonds.columns[names[i]].push_back(force[i]);
    }
  }
  void match(const BondForceColumns& columns = {}) {
    match_bonds(model, statics, bonds, columns, "bonds", run, faults);
  }
  std::string note() const { return run.notes.empty() ? "" : run.notes.back(); }
};

TEST(MatchBonds, ForcesOnTheSecondParticleAreTakenAsTheyAre) {
  Written written(true);
  written.match();
  ASSERT_TRUE(written.faults.empty());
  EXPECT_THAT(written.note(), HasSubstr("second particle"));
  EXPECT_FALSE(written.run.normal_force_only);
  for (std::size_t k = 0; k < written.model.bonds.size(); ++k)
    EXPECT_EQ(written.run.bond_force[k], written.statics.bonds[k].force) << k;
}

TEST(MatchBonds, ForcesOnTheFirstParticleAreTurned) {
  Written written(false);
  written.match();
  EXPECT_THAT(written.note(), HasSubstr("first particle"));
  for (std::size_t k = 0; k < written.model.bonds.size(); ++k)
    EXPECT_EQ(written.run.bond_force[k], written.statics.bonds[k].force) << k;
}

TEST(MatchBonds, NormalForcesTimesLengthAreRecognised) {
  Written written(false, true, true);
  written.match();
  EXPECT_TRUE(written.run.normal_force_only);
  EXPECT_THAT(written.note(), HasSubstr("the length is divided out"));
  for (std::size_t k = 0; k < written.model.bonds.size(); ++k) {
    const Vector3 axis = written.model.bonds[k].branch.normalized();
    // Lengths are those of the run's state, longer by strains of 1e-6.
    EXPECT_NEAR(-axis.dot(written.run.bond_force[k].head<3>()), written.statics.bonds[k].normal_force, 1e-4);
  }
}

TEST(MatchBonds, BondsThatTheFileLacksAreLeftOut) {
  Written written(true);
  written.bonds.a.resize(100);
  written.bonds.b.resize(100);
  written.match();
  ASSERT_TRUE(written.faults.empty());
  EXPECT_THAT(written.run.notes.front(), HasSubstr("100 of the case's"));
  EXPECT_TRUE(std::isnan(written.run.bond_force.back()[0]));
}

TEST(MatchBonds, MissingColumnsAreNamed) {
  Written written(true);
  written.match({{"c_1[1]", "c_1[2]", "c_1[3]"}, {}});
  ASSERT_EQ(written.faults.size(), 1u);
  EXPECT_THAT(written.faults[0].message, HasSubstr("no columns c_1[1], c_1[2], c_1[3]"));
  EXPECT_THAT(written.faults[0].message, HasSubstr("fx, fy, fz"));
}

TEST(MatchBonds, AnotherPackingsBondsAreRefused) {
  Written written(true);
  for (Index& id : written.bonds.a) id += 1000;
  written.match();
  ASSERT_EQ(written.faults.size(), 1u);
  EXPECT_THAT(written.faults[0].message, HasSubstr("only 0 of the case's"));
}

}  // namespace

}  // namespace bondstatic
