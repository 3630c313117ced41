// [cell] and strain of a case.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bondstatic/statics.hpp"
#include "case/same_model.hpp"
#include "case/sound_case.hpp"

namespace bondstatic::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string cubes =
    "[[particles]]\nlattice = { kind = \"simple-cubic\", count = [3, 3, 3], spacing = 1.0 }\nradius = 0.5\n"
    "[[bonds]]\nlaw = \"generic\"\nkn = 6e6\nks = 2e6\nkt = 1e5\nkb = 1e5\n";
const std::string cell = "[cell]\nsize = [3, 3, 3]\n";

TEST(Cell, GetsUnitStrainsAndOneHeldTranslationByItself) {
  const Case read = read_case_text(cubes + cell);
  EXPECT_EQ(read.model.bonds.size(), 81u);
  EXPECT_THAT(read.model.load_cases, ElementsAre("xx", "yy", "zz", "yz", "xz", "xy"));
  ASSERT_EQ(read.model.supports.size(), 1u);
  const auto solution = solve_statics(read.model, read.solve);
  ASSERT_TRUE(solution.effective);
  EXPECT_NEAR(solution.effective->stiffness(0, 0), 6e6, 1e-6);
  EXPECT_NEAR(solution.effective->stiffness(3, 3), 1e6, 1e-7);
}

TEST(Cell, ResolvedCaseIsTheSameModel) {
  const Case first = read_case_text(cubes + "[cell]\nedges = [[3, 0, 0], [0, 3, 0], [0, 0, 3]]\n");
  const Case again = read_case_text(first.resolved);
  expect_same(first.model, again.model);
}

TEST(Cell, OwnStrainsAreLoadCases) {
  const Case read =
      read_case_text(cubes + cell + "[[loads]]\ncase = \"pull\"\nstrain = { xx = 1e-3, yz = 5e-4 }\n");
  EXPECT_THAT(read.model.load_cases, ElementsAre("pull"));
  const auto result = solve_statics(read.model, read.solve).cases[0];
  EXPECT_NEAR(result.stress(0, 0), 6e3, 1e-8);
  EXPECT_NEAR(result.stress(1, 2), 1e3, 1e-8);  // 2 c44 eps_yz
  EXPECT_NEAR(result.stress(2, 1), 1e3, 1e-8);
}

TEST(Cell, BondFilesTakeTheNearestImage) {
  const std::string text =
      "[[particles]]\nline = { from = [0.5, 0, 0], step = [1, 0, 0], count = 4 }\nradius = 0.5\n"
      "[[bonds]]\nfile = \"b.csv\"\nlaw = \"generic\"\nkn = 6e6\nks = 2e6\nkt = 1e5\nkb = 1e5\n"
      "[cell]\nsize = [4, 2, 2]\nperiodic = [\"x\"]\n";
  const Case read = read_case_text(text, {}, {{"b.csv", "a,b\n1,2\n2,3\n3,4\n1,4\n"}});
  EXPECT_EQ(read.model.bonds[2].branch, Vector3(1, 0, 0));
  EXPECT_EQ(read.model.bonds[3].branch, Vector3(-1, 0, 0));
  const auto faults = faults_of(text, {}, {{"b.csv", "a,b\n1,2\n2,3\n3,4\n1,3\n"}});
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_THAT(faults[0].message, HasSubstr("equally near"));
  EXPECT_EQ(faults[0].place.line, 5);
}

struct BadCell {
  std::string text;
  int line;
  std::string message;
};

TEST(Cell, MistakesAreNamedWhereTheyStand) {
  const std::string strain = "[[loads]]\nstrain = { xx = 1e-3 }\n";
  const std::vector<BadCell> rows{
      {cubes + "[cell]\n", 10, "size"},
      {cubes + "[cell]\nsize = [3, 3]\n", 11, "size"},
      {cubes + "[cell]\nsize = [3, 3, 0]\n", 11, "must be positive"},
      {cubes + "[cell]\nsize = [3, 3, 3]\nedges = [[3, 0, 0], [0, 3, 0], [0, 0, 3]]\n", 12, "exclude"},
      {cubes + "[cell]\nedges = [[3, 0, 0], [0, 3, 0]]\n", 11, "three vectors"},
      {cubes + "[cell]\nedges = [[3, 0, 0], [0, 3, 0], [3, 3, 0]]\n", 11, "lie in a plane"},
      {cubes + cell + "periodic = [\"w\"]\n", 12, "no edge \"w\""},
      {cubes + cell + "periodic = []\n", 12, "periodic is empty"},
      {cubes + cell + "sizes = 3\n", 12, "sizes"},
      {cubes + strain, 11, "no [cell]"},
      {cubes + cell + "[[loads]]\nstrain = { ab = 1e-3 }\n", 13, "ab"},
      {cubes + cell + "periodic = [\"y\", \"z\"]\n" + strain, 14, "not periodic"},
      {"[[particles]]\nline = { from = [0, 0, 0], step = [1, 0, 0], count = 3 }\nradius = 0.5\n"
       "[[bonds]]\nlaw = \"generic\"\nkn = 6e6\nks = 2e6\nkt = 1e5\nkb = 1e5\n[cell]\nsize = [3, 1, 1]\n",
       4, "bonded to its own image"},
      {"[[particles]]\nline = { from = [0, 0, 0], step = [1, 0, 0], count = 3 }\nradius = 500\n"
       "[[bonds]]\nlaw = \"generic\"\nkn = 6e6\nks = 2e6\nkt = 1e5\nkb = 1e5\n[cell]\nsize = [3, 1, 1]\n",
       4, "bonds could be 1000 long, 333 times the cell's 3 along edge x"},
  };
  for (const BadCell& row : rows) {
    const auto faults = faults_of(row.text);
    ASSERT_FALSE(faults.empty()) << row.text;
    EXPECT_THAT(faults[0].message, HasSubstr(row.message));
    EXPECT_EQ(faults[0].place.line, row.line) << faults[0].message;
    EXPECT_FALSE(faults[0].cure.empty());
  }
}

}  // namespace
}  // namespace bondstatic::test
