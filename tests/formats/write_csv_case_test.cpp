// The case as tables and a case file: solved, it gives the same answer.
#include <gmock/gmock.h>

#include "bondstatic/case_file.hpp"
#include "formats/export_models.hpp"

namespace bondstatic::test {
namespace {

/// Largest difference of displacements over the largest displacement, rotations by radius one.
double difference(const State& left, const State& right) {
  double largest = 0, off = 0;
  for (std::size_t p = 0; p < left.displacement.size(); ++p) {
    largest = std::max(largest, left.displacement[p].cwiseAbs().maxCoeff());
    off = std::max(off, (left.displacement[p] - right.displacement[p]).cwiseAbs().maxCoeff());
  }
  return off / largest;
}

double round_trip(const Model& model) {
  const Exported exported(model, "csv");
  const Case back = read_case(exported.path("case.toml"));
  EXPECT_EQ(back.model.bonds.size(), model.bonds.size());
  const StaticSolution solution = solve_statics(back.model, back.solve);
  double off = 0;
  for (std::size_t c = 0; c < solution.cases.size(); ++c)
    off = std::max(off, difference(exported.solution.cases.at(c), solution.cases[c]));
  return off;
}

TEST(CsvCase, OfGenericBondsGivesTheSameAnswer) {
  EXPECT_LT(round_trip(mixed_model()), 1e-14);
}

TEST(CsvCase, KeepsContactPointsOfEveryBond) {
  Model model = mixed_model();
  model.blocks[0] = block("parallel", {{"young", 1e7}, {"poisson", 0.2}, {"radius_factor", 0.9}});
  EXPECT_LT(round_trip(model), 1e-14);
}

TEST(CsvCase, WritesCoupledBondsAtThePointWhereTheyDoNotCouple) {
  Model model = mixed_model();
  model.blocks[1] = block("two-segment", {{"young", 1e7}, {"poisson", 0.2}, {"radius_factor", 0.9}});
  const Exported exported(model, "csv");
  EXPECT_THAT(joined(exported.notes.remarks), testing::HasSubstr("couple shear and bending"));
  EXPECT_LT(round_trip(model), 1e-14);
}

TEST(CsvCase, KeepsLoadCasesPrescribedMotionsAndRepeatedLoads) {
  Model model = mixed_model();
  model.load_cases = {"push", "twist"};
  for (Load& load : model.loads) load.load_case = 0;
  load(model, 26, vector6(2.0, -1.0 / 3, -10), 0);  // once more the same
  model.loads.push_back({23, vector6(0, 0, 0, 0.1, 0, 0), 1});
  Support moved;
  moved.particle = 17;
  moved.fixed[0] = true;
  moved.value[0] = 1e-4 / 3;
  moved.load_case = 1;
  model.supports.push_back(moved);
  EXPECT_LT(round_trip(model), 1e-14);
}

TEST(CsvCase, SaysThatATableMeansTheNearestImage) {
  EXPECT_THAT(joined(Exported(skewed_pair(), "csv").notes.not_expressed),
              testing::HasSubstr("1 of 1 bonds do not go to the one nearest image"));
}

TEST(CsvCase, ParticlesWithoutDensityStandInATableOfTheirOwn) {
  Model model = mixed_model();
  model.particles[3].density = not_given;
  const Exported exported(model, "csv");
  const Case back = read_case(exported.path("case.toml"));
  EXPECT_EQ(back.model.particles.size(), model.particles.size());
  EXPECT_TRUE(std::isnan(back.model.particles.back().density));
  EXPECT_EQ(back.model.particles.back().id, model.particles[3].id);
}

}  // namespace
}  // namespace bondstatic::test
