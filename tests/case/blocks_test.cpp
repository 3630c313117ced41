// What the blocks of a case mean, one by one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "bondstatic/bond_law.hpp"
#include "case/sound_case.hpp"

namespace bondstatic::test {
namespace {

using Files = std::vector<std::pair<std::string, std::string>>;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Index> ids(const Model& model) {
  std::vector<Index> list;
  for (const Particle& particle : model.particles) list.push_back(particle.id);
  return list;
}

TEST(Particles, IdsGoOnOverBlocksAndFiles) {
  const std::string line =
      "[[particles]]\nline = { from = [0, 0, 0], step = [1, 0, 0], count = 2 }\nradius = 0.1\n";
  const std::string file = "[[particles]]\nfile = \"p.csv\"\n";
  const Files files{{"p.csv", "id,x,y,z,r\n40,0,1,0,0.1\n7,0,2,0,0.1\n"}};
  EXPECT_THAT(ids(read_case_text(line + file + line, {}, files).model), ElementsAre(1, 2, 40, 7, 41, 42));
  EXPECT_EQ(faults_of(file + line + file, {}, files).size(), 1u);
}

TEST(Particles, ZeroIsAnId) {
  const Files files{{"p.csv", "id,x,y,z,r\n0,0,1,0,0.1\n"}};
  EXPECT_THAT(ids(read_case_text("[[particles]]\nfile = \"p.csv\"", {}, files).model), ElementsAre(0));
}

TEST(Particles, FileColumnsInAnyOrderWithAliases) {
  const Files files{{"p.csv",
                     "\xEF\xBB\xBF# from somewhere\r\n\"Pos_Z\";Diameter;pos_x;vx;POS_Y;rho;Group\r\n"
                     "3;0.4;1;9;2;2500;\"a;b\"\r\n\r\n6;0.8;4;9;5;2600;c # behind\r\n"}};
  const Case c = read_case_text(
      "[[particles]]\nfile = \"p.csv\"\n[[outputs]]\nname = \"s\"\nof = \"ux\"\nat = { group = \"a;b\" }", {},
      files);
  ASSERT_EQ(c.model.particles.size(), 2u);
  EXPECT_EQ(c.model.particles[1].position, Vector3(4, 5, 6));
  EXPECT_EQ(c.model.particles[1].radius, 0.4);
  EXPECT_EQ(c.model.particles[1].density, 2600);
  EXPECT_THAT(c.outputs.at(0).at, ElementsAre(0));
  ASSERT_EQ(c.warnings.size(), 1u);
  EXPECT_THAT(c.warnings[0], HasSubstr("columns not used: vx"));
}

TEST(Particles, JitterAndRemovalFollowTheSeed) {
  const auto packing = [](const std::string& more) {
    return read_case_text(
               "[[particles]]\nlattice = { kind = \"simple-cubic\", count = [5, 5, 4], spacing = 1 }\n"
               "radius = 0.4\n" +
               more)
        .model.particles;
  };
  const auto still = packing(""), moved = packing("jitter = 0.5\nseed = 3"),
             again = packing("jitter = 0.5\nseed = 3");
  const auto other = packing("jitter = 0.5\nseed = 4"), fewer = packing("removal = 0.25");
  double largest = 0;
  for (std::size_t i = 0; i < still.size(); ++i) {
    EXPECT_EQ(moved[i].position, again[i].position);
    EXPECT_NE(moved[i].position, other[i].position);
    largest = std::max(largest, (moved[i].position - still[i].position).cwiseAbs().maxCoeff());
  }
  EXPECT_LE(largest, 0.2);
  EXPECT_GT(largest, 0.19);  // of 300 uniform numbers
  EXPECT_EQ(fewer.size(), 75u);
  EXPECT_EQ(fewer.back().id, 75);
}

/// Positions that a selector selects among eleven particles at x = 0, 0.4 .. 4; those with x > 2.5 are the
/// group "far".
std::vector<Index> selected(const std::string& at) {
  return read_case_text(sound_case({{18, "at = { " + at +
                                             " }\nreduce = \"mean\"\n[[groups]]\nname = \"far\"\n"
                                             "at = { plane = { point = [2.5, 0, 0], normal = \"x\" } }"}}))
      .outputs.at(0)
      .at;
}

TEST(Selector, SelectsByEachKey) {
  EXPECT_THAT(selected("id = 3"), ElementsAre(2));
  EXPECT_THAT(selected("id = [5, 3, 5]"), ElementsAre(2, 4));
  EXPECT_THAT(selected("group = \"far\""), ElementsAre(7, 8, 9, 10));
  EXPECT_THAT(selected("group = [\"far\"]"), ElementsAre(7, 8, 9, 10));
  EXPECT_THAT(selected("box = { min = [1, -1, -1], max = [1.9, 1, 1] }"), ElementsAre(3, 4));
  EXPECT_THAT(selected("box = { max = [0.5, inf, inf] }"), ElementsAre(0, 1));
  EXPECT_THAT(selected("box = { min = [-inf, 0, -inf], max = [0.5, 0, inf] }"), ElementsAre(0, 1));
  EXPECT_THAT(selected("sphere = { centre = [2, 0.1, 0], radius = 0.5 }"), ElementsAre(4, 5, 6));
  EXPECT_THAT(selected("plane = { point = [0.5, 0, 0], normal = [-2, 0, 0] }"), ElementsAre(0, 1));
  EXPECT_THAT(selected("lowest = { axis = \"x\", within = 0.5 }"), ElementsAre(0, 1));
  EXPECT_THAT(selected("highest = { axis = \"x\", within = 0 }"), ElementsAre(10));
  EXPECT_THAT(selected("highest = { axis = [-1, 0, 0], within = 0.5 }"), ElementsAre(0, 1));
  EXPECT_EQ(selected("all = true").size(), 11u);
}

TEST(Selector, KeysIntersect) {
  EXPECT_THAT(selected("group = \"far\", box = { max = [3, 1, 1] }"), ElementsAre(7));
  EXPECT_THAT(selected("id = [1, 8], group = \"far\", all = true"), ElementsAre(7));
}

TEST(Selector, BoundariesAreInsideInSpiteOfRounding) {
  // 3 x 0.4 is 1.2000000000000002 in double.
  EXPECT_THAT(selected("box = { min = [1.2, 0, 0], max = [1.2, 0, 0] }"), ElementsAre(3));
  EXPECT_THAT(selected("lowest = { axis = \"x\", within = 1.2 }"), ElementsAre(0, 1, 2, 3));
}

/// Pairs of particle ids.
std::vector<std::pair<Index, Index>> pairs(const Model& model) {
  std::vector<std::pair<Index, Index>> list;
  for (const Bond& bond : model.bonds)
    list.emplace_back(model.particles[std::size_t(bond.a)].id, model.particles[std::size_t(bond.b)].id);
  return list;
}

using Pair = std::pair<Index, Index>;

TEST(Bonds, BetweenGroupsAndSeveralLaws) {
  const std::string more = R"(
[[groups]]
name = "left"
at = { id = [1, 2, 3] }
[[groups]]
name = "right"
at = { id = [4, 5] }
)";
  const auto read = [&](const std::string& lines) {
    return read_case_text(sound_case({{7, "poisson = 0.3\n" + lines}, {19, more}})).model;
  };
  EXPECT_THAT(pairs(read("between = \"left\"")), ElementsAre(Pair(1, 2), Pair(2, 3)));
  EXPECT_THAT(pairs(read("between = [\"left\", \"right\"]")), ElementsAre(Pair(3, 4)));
  EXPECT_THAT(pairs(read("between = [\"right\", \"left\"]")), ElementsAre(Pair(3, 4)));
  const Model two =
      read("between = \"left\"\n[[bonds]]\nlaw = \"contact\"\nkn = 1\nks = 1\nexisting = \"skip\"\n#");
  EXPECT_EQ(two.bonds.size(), 10u);
}

TEST(Bonds, RunFromTheSmallerIdAndAreNumberedByIds) {
  const Files files{{"p.csv", "id,x,y,z,r\n9,0,0,0,0.5\n4,1,0,0,0.5\n6,2,0,0,0.5\n2,2,1,0,0.5\n"}};
  const Case c = read_case_text(
      "[[particles]]\nfile = \"p.csv\"\n[[bonds]]\nlaw = \"contact\"\nkn = 1\nks = 1", {}, files);
  EXPECT_THAT(pairs(c.model), ElementsAre(Pair(2, 6), Pair(4, 6), Pair(4, 9)));
  EXPECT_EQ(c.model.bonds[2].branch, Vector3(-1, 0, 0));
  EXPECT_EQ(c.model.bonds[2].id, 3);
}

TEST(Bonds, ExistingPairsAreFaultsSkippedOrAdded) {
  const auto with = [](const std::string& existing) {
    return sound_case(
        {{8, "radius = 0.2\n[[bonds]]\nlaw = \"contact\"\nkn = 1\nks = 1\ngap = 0.4" + existing}});
  };
  const auto faults = faults_of(with(""));
  ASSERT_EQ(faults.size(), 1u);  // not one a pair
  EXPECT_THAT(faults[0].message, HasSubstr("particles 1 and 2 are bonded already"));
  const Model skipped = read_case_text(with("\nexisting = \"skip\"")).model;
  EXPECT_EQ(skipped.bonds.size(), 10u + 9u);
  EXPECT_EQ(skipped.bonds.back().block, 1);
  EXPECT_EQ(skipped.bonds.back().in_block, 8);
  EXPECT_EQ(skipped.bonds.back().id, 19);
  EXPECT_EQ(read_case_text(with("\nexisting = \"add\"")).model.bonds.size(), 10u + 19u);
}

TEST(Bonds, FileKeepsDirectionAndOwnParameters) {
  const Files files{{"bonds.csv", "b,a,id,radius,note\n1,2,20,0.1,x\n3,2,10,,y\n4,3,30,0.3,z\n"}};
  const Case c = read_case_text(sound_case({{8, "radius_factor = 0.5\nfile = \"bonds.csv\""}}), {}, files);
  EXPECT_THAT(pairs(c.model), ElementsAre(Pair(2, 1), Pair(2, 3), Pair(3, 4)));
  EXPECT_EQ(c.model.bonds[1].id, 10);
  ASSERT_EQ(c.warnings.size(), 1u);
  const std::vector<BondProperties> properties = bond_properties(c.model);
  EXPECT_EQ(properties[0].radius, 0.1);
  EXPECT_EQ(properties[1].radius, 0.5 * 0.2);  // the block's, where the file leaves it empty
  EXPECT_EQ(properties[2].radius, 0.3);
}

TEST(Bonds, ContactPointOfTheUsersChoice) {
  const auto point = [](const std::string& line) {
    return read_case_text(sound_case({{8, "radius = 0.2\n" + line}})).model.blocks.at(0).contact_point;
  };
  using Kind = ContactPoint::Kind;
  EXPECT_EQ(point("").kind, Kind::of_law);
  EXPECT_EQ(point("contact_point = \"gap\"").kind, Kind::gap);
  EXPECT_EQ(point("contact_point = \"beam\"").kind, Kind::beam);
  EXPECT_EQ(point("contact_point = 0.25").kind, Kind::fraction);
  EXPECT_EQ(point("contact_point = 0.25").value, 0.25);
  EXPECT_EQ(point("contact_point = \"contact-radii\"\ncontact_radius_factor = 1.1").kind,
            Kind::contact_radii);
  EXPECT_EQ(point("contact_point = \"contact-radii\"\ncontact_radius_factor = 1.1\ngap = 0").value, 1.1);
}

TEST(Supports, FixAndValues) {
  const Case c = read_case_text(
      sound_case({{11, "fix = \"all\"\nvalues = { z = \"-1 mm\", ry = \"180 deg\" }"},
                  {19,
                   "[[supports]]\nat = { id = 11 }\nfix = [\"y\", \"rx\"]\n[[supports]]\nat = { id = 11 }\n"
                   "fix = \"y\""}}));
  ASSERT_EQ(c.model.supports.size(), 3u);
  const Support& moved = c.model.supports[0];
  EXPECT_EQ(moved.value, (Vector6() << 0, 0, -1e-3, 0, std::numbers::pi, 0).finished());
  EXPECT_EQ(c.model.supports[1].fixed, (std::array<bool, 6>{false, true, false, true, false, false}));
  EXPECT_EQ(c.model.supports[1].load_case, every_case);
}

TEST(Supports, ContradictOnlyWithinALoadCase) {
  const auto two = [](const std::string& first, const std::string& second) {
    return sound_case({{19, "[[supports]]\nat = { id = 11 }\nvalues = { y = 1 }\n" + first +
                                "\n[[supports]]\nat = { id = 11 }\nvalues = { y = 2 }\n" + second},
                       {16, "name = \"tip\"\ncase = \"a\""},
                       {14, "force = [1, 0, 0]\ncase = \"a\""}});
  };
  EXPECT_TRUE(faults_of(two("case = \"a\"", "case = \"b\"")).empty());
  EXPECT_EQ(faults_of(two("case = \"a\"", "case = \"a\"")).size(), 1u);
  EXPECT_EQ(faults_of(two("", "case = \"a\"")).size(), 1u);
}

TEST(Loads, TotalsAreSharedAndCasesNumbered) {
  const Case c = read_case_text(
      sound_case({{13, "at = { id = [2, 3, 4, 5] }"},
                  {14, "total_force = [8, 0, \"4 kN\"]\nmoment = [0, 0, 2]\ncase = \"b\""},
                  {18, "at = { id = 2 }\ncase = \"a\""},
                  {19,
                   "[[loads]]\nat = { id = 2 }\nforce = [1, 0, 0]\n[[loads]]\nat = { id = 2 }\ntotal_moment "
                   "= [1, 0, 0]\n"
                   "case = \"a\"\n[[supports]]\nat = { id = 1 }\nfix = \"x\"\ncase = \"c\""}}));
  EXPECT_EQ(c.model.load_cases, (std::vector<std::string>{"b", "a", "c"}));
  ASSERT_EQ(c.model.loads.size(), 6u);
  EXPECT_EQ(c.model.loads[3].force, (Vector6() << 2, 0, 1000, 0, 0, 2).finished());
  EXPECT_EQ(c.model.loads[3].load_case, 0);
  EXPECT_EQ(c.model.loads[4].load_case, every_case);
  EXPECT_EQ(c.model.loads[5].load_case, 1);
  EXPECT_EQ(c.model.supports.back().load_case, 2);
}

TEST(Loads, GravityPullsWhatHasADensity) {
  const Case c = read_case_text(sound_case({{3,
                                             "radius = 0.2\ndensity = 2500\n[[particles]]\nline = { from = "
                                             "[0, 1, 0], step = [1, 0, 0], count = 2 }\n"
                                             "radius = 0.1"},
                                            {19, "[[loads]]\ngravity = [0, 0, -9.81]"}}));
  ASSERT_EQ(c.model.loads.size(), 1u + 11u);
  const double weight = 4.0 / 3 * std::numbers::pi * 0.2 * 0.2 * 0.2 * 2500 * -9.81;
  EXPECT_NEAR(c.model.loads.back().force[2], weight, 4e-16 * 821);
}

TEST(Outputs, AskForBondsParticlesAndTheModel) {
  const Case c = read_case_text(sound_case({{19, R"(
[[outputs]]
name = "bond"
of = "sigma"
at = { bond = [2, 10] }
reduce = "max"
[[outputs]]
name = "bonds"
of = "energy"
at = { all = true }
reduce = "sum"
[[outputs]]
name = "model"
of = "energy"
scale = 2
[[outputs]]
name = "E"
of = "apparent_young"
at = { id = 11 }
base = { id = [1, 2] }
axis = "x"
expected = 3
tolerance = 0.1
source = "guess"
[[outputs]]
name = "nu"
of = "apparent_poisson"
at = { id = 11 }
base = { id = 1 }
axis = "x"
[[outputs]]
name = "nu of some"
of = "apparent_poisson"
at = { id = 11 }
base = { id = 1 }
axis = "x"
middle = { id = [7, 3] }
)"}}));
  ASSERT_EQ(c.outputs.size(), 7u);
  EXPECT_THAT(c.outputs[1].at, ElementsAre(1, 9));
  EXPECT_EQ(c.outputs[1].reduce, Output::Reduce::max);
  EXPECT_EQ(c.outputs[2].at.size(), 10u);
  EXPECT_TRUE(c.outputs[3].at.empty());
  EXPECT_EQ(c.outputs[3].scale, 2);
  EXPECT_THAT(c.outputs[4].base, ElementsAre(0, 1));
  EXPECT_EQ(c.outputs[4].axis, Vector3(1, 0, 0));
  EXPECT_EQ(c.outputs[4].expected, 3);
  EXPECT_EQ(c.outputs[4].tolerance, 0.1);
  EXPECT_EQ(c.outputs[4].source, "guess");
  EXPECT_THAT(c.outputs[5].middle, ElementsAre(4, 5, 6));
  EXPECT_EQ(c.outputs[5].axis, Vector3(1, 0, 0));
  EXPECT_THAT(c.outputs[6].middle, ElementsAre(2, 6));
}

TEST(Outputs, NeedACaseWhereThereAreSeveral) {
  const auto with = [](const std::string& line) {
    return sound_case({{14, "force = [1, 0, 0]\ncase = \"a\""},
                       {18, "at = { id = 11 }\n" + line},
                       {19, "[[loads]]\nat = { id = 2 }\nforce = [1, 0, 0]\ncase = \"b\""}});
  };
  EXPECT_EQ(read_case_text(with("case = \"b\"")).outputs.at(0).load_case, "b");
  const auto faults = faults_of(with(""));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_THAT(faults[0].cure, HasSubstr("a, b"));
}

TEST(Outputs, TakeTheOnlyCase) {
  EXPECT_EQ(read_case_text(sound_case({{14, "force = [1, 0, 0]\ncase = \"a\""}})).outputs.at(0).load_case,
            "a");
}

}  // namespace
}  // namespace bondstatic::test
