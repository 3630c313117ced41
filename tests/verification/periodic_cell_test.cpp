// A periodic cell's effective stiffness: closed forms of lattices, and what must hold for any packing.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>

#include "bondstatic/mechanism.hpp"
#include "bondstatic/statics.hpp"
#include "model/cell.hpp"
#include "model/hold_cell.hpp"
#include "support/models.hpp"
#include "support/periodic.hpp"

namespace bondstatic::test {
namespace {

constexpr double length = 0.5;  // of every lattice bond

BondBlock beams() {
  return block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.15}});
}

EffectiveStiffness stiffness_of(const Model& model, const std::string& solver = "cholmod") {
  StaticOptions options;
  options.solver = solver;
  const auto solution = solve_statics(model, options);
  for (const LoadCaseResult& result : solution.cases) {
    EXPECT_LT(result.accuracy.force_balance, 1e-13);
    EXPECT_LT(result.accuracy.energy_balance, 1e-13);
    EXPECT_LT(result.accuracy.moment_balance, 1e-13);
  }
  return solution.effective.value();
}

double apart(const Matrix6& found, const Matrix6& expected) {
  return (found - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

Matrix6 cubic(double c11, double c12, double c44) {
  Matrix6 c = Matrix6::Zero();
  c.topLeftCorner<3, 3>().setConstant(c12);
  c.diagonal() << c11, c11, c11, c44, c44, c44;
  return c;
}

struct CubicCase {
  const char* name;
  double edge;  ///< of the conventional cell
  std::vector<Vector3> basis;
  std::vector<int> cells;  ///< along an edge, of the periodic cell
  std::function<Matrix6(double kn, double ks)> expected;
};

void PrintTo(const CubicCase& chosen, std::ostream* out) {
  *out << chosen.name;
}

class PeriodicLattice : public ::testing::TestWithParam<CubicCase> {};

TEST_P(PeriodicLattice, HasItsClosedFormStiffnessInACellOfAnySize) {
  const CubicCase& lattice = GetParam();
  const BondProperties bond =
      find_bond_law("timoshenko")->evaluate({length, length / 2, length / 2, 1, 2}, beams().parameters);
  const Matrix6 expected = lattice.expected(bond.stiffness.kn, bond.stiffness.ks);
  for (const int cells : lattice.cells) {
    std::vector<Vector3> points;
    for (int x = 0; x < cells; ++x)
      for (int y = 0; y < cells; ++y)
        for (int z = 0; z < cells; ++z)
          for (const Vector3& site : lattice.basis)
            points.push_back(lattice.edge * (Vector3(x, y, z) + site));
    const Cell cell{{0.1, 0.2, 0.3}, cells * lattice.edge * Matrix3::Identity()};
    const EffectiveStiffness found =
        stiffness_of(periodic_model(points, std::vector<double>(points.size(), length / 2), cell, beams()));
    EXPECT_LT(apart(found.stiffness, expected), 1e-13) << cells << " cells\n" << found.stiffness;
    // Every site is a centre of symmetry: nothing moves but with the strain.
    EXPECT_LT(apart(found.voigt, expected), 1e-13);
    EXPECT_LT(found.asymmetry, 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(Verification, PeriodicLattice,
                         ::testing::Values(CubicCase{"SimpleCubic",
                                                     length,
                                                     {{0, 0, 0}},
                                                     {2, 3, 4},
                                                     [](double kn, double ks) {
                                                       return cubic(kn / length, 0, ks / (2 * length));
                                                     }},
                                           CubicCase{"BodyCentred",
                                                     2 * length / std::sqrt(3.0),
                                                     {{0, 0, 0}, {0.5, 0.5, 0.5}},
                                                     {1, 2, 3},
                                                     [](double kn, double ks) {
                                                       const double s = std::sqrt(3.0) * length;
                                                       return cubic((kn + 2 * ks) / s, (kn - ks) / s,
                                                                    (2 * kn + ks) / (2 * s));
                                                     }},
                                           CubicCase{"FaceCentred",
                                                     std::sqrt(2.0) * length,
                                                     {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}},
                                                     {1, 2, 3},
                                                     [](double kn, double ks) {
                                                       const double s = std::sqrt(2.0) / length;
                                                       return cubic(s * (kn + ks), s * (kn - ks) / 2,
                                                                    s * (kn + ks) / 2);
                                                     }}),
                         [](const auto& chosen) { return std::string(chosen.param.name); });

TEST(PeriodicCell, TwoGridsThatDoNotTouchCarryBoth) {
  const auto grid = [](const Vector3& origin) {
    std::vector<Vector3> points;
    for (int n = 0; n < 27; ++n) points.push_back(origin + length * Vector3(n % 3, n / 3 % 3, n / 9));
    return periodic_model(points, std::vector<double>(27, length / 2),
                          {{0, 0, 0}, 3 * length * Matrix3::Identity()}, beams());
  };
  const Model one = grid({0, 0, 0}), other = grid(Vector3::Constant(length / 2));
  Model both = one;
  for (Particle particle : other.particles) {
    particle.id += 27;
    both.particles.push_back(particle);
  }
  for (const Bond& bond : other.bonds)
    both.bonds.push_back({bond.id + 81, bond.a + 27, bond.b + 27, bond.branch, 0, bond.in_block + 81});
  both.supports.clear();
  hold_translation(both);
  EXPECT_LT(apart(stiffness_of(both).stiffness, 2 * stiffness_of(one).stiffness), 1e-13);
}

TEST(PeriodicCell, FaceCentredLatticeInItsTriclinicPrimitiveCell) {
  Cell cell;
  cell.edges << 0.5, 0.5, 0, 0.5, 0, 0.5, 0, 0.5, 0.5;  // columns: the three shortest vectors between sites
  const Matrix3 primitive = std::sqrt(2.0) * length * cell.edges;
  cell.edges = 3 * primitive;
  std::vector<Vector3> points;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) points.push_back(primitive * Vector3(i, j, k));
  const auto found = stiffness_of(periodic_model(points, std::vector<double>(27, length / 2), cell, beams()));
  const BondProperties bond =
      find_bond_law("timoshenko")->evaluate({length, length / 2, length / 2, 1, 2}, beams().parameters);
  const double kn = bond.stiffness.kn, ks = bond.stiffness.ks, s = std::sqrt(2.0) / length;
  EXPECT_LT(apart(found.stiffness, cubic(s * (kn + ks), s * (kn - ks) / 2, s * (kn + ks) / 2)), 1e-13);
}

TEST(PeriodicCell, PackingIsSymmetricPositiveDefiniteAndBelowTheVoigtBound) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::mt19937_64 random(seed);
    const EffectiveStiffness found = stiffness_of(periodic_packing(random, 4, beams()));
    EXPECT_LT(found.asymmetry, 1e-14);
    const double largest = found.stiffness.cwiseAbs().maxCoeff();
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix6>(found.stiffness).eigenvalues()[0], 1e-3 * largest);
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix6>(found.voigt - found.stiffness).eigenvalues()[0],
              1e-3 * largest);
  }
}

TEST(PeriodicCell, TurningTheMatterTurnsTheTensor) {
  std::mt19937_64 random(4);
  const Model model = periodic_packing(random, 4, beams());
  const Matrix3 rotation = Eigen::AngleAxisd(0.7, Vector3(1, -2, 3).normalized()).toRotationMatrix();
  const EffectiveStiffness straight = stiffness_of(model), askew = stiffness_of(turned(model, rotation));
  EXPECT_LT(apart(askew.stiffness, turned_stiffness(straight.stiffness, rotation)), 1e-13);
  EXPECT_LT(apart(askew.voigt, turned_stiffness(straight.voigt, rotation)), 1e-13);
  EXPECT_NEAR(askew.isotropic.young / straight.isotropic.young, 1, 1e-13);
  EXPECT_NEAR(askew.isotropic.poisson, straight.isotropic.poisson, 1e-13);
  EXPECT_NEAR(askew.isotropic.misfit, straight.isotropic.misfit, 1e-13);
}

TEST(PeriodicCell, EightCellsAreTheSameMaterialAsOne) {
  std::mt19937_64 random(5);
  const Model model = periodic_packing(random, 3, beams());
  const Model eight = repeated(model, {2, 2, 2});
  ASSERT_EQ(eight.bonds.size(), 8 * model.bonds.size());
  EXPECT_LT(apart(stiffness_of(eight).stiffness, stiffness_of(model).stiffness), 1e-13);
}

TEST(PeriodicCell, WhichImageOfAParticleIsGivenDoesNotMatter) {
  std::mt19937_64 random(6);
  const Model model = periodic_packing(random, 3, beams());
  std::vector<Vector3> points;
  std::vector<double> radii;
  for (const Particle& particle : model.particles) {
    points.push_back(particle.position + shift_of(*model.cell, {int(random() % 5) - 2, int(random() % 5) - 2,
                                                                int(random() % 5) - 2}));
    radii.push_back(particle.radius);
  }
  const Model scattered = periodic_model(points, radii, *model.cell, beams(), 1.4);
  ASSERT_EQ(scattered.bonds.size(), model.bonds.size());
  EXPECT_LT(apart(stiffness_of(scattered).stiffness, stiffness_of(model).stiffness), 1e-13);
}

// The independent route: a dense matrix of the 12x12 of the bonds, the strain as motion of the far ends of
// bonds that leave the cell (not of all bonds), solved by a full-rank least-squares decomposition.
TEST(PeriodicCell, DenseSolutionWithMovedImagesIsTheSame) {
  std::mt19937_64 random(7);
  const Model model = periodic_packing(random, 3, beams());
  const auto properties = bond_properties(model);
  const BondNetwork network = bond_network(model, properties);
  const Index n = 6 * network.bodies;
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
  for (const Link& link : network.links) {
    const Matrix12 of_link = stiffness_matrix(link);
    const Index at[2] = {6 * link.a, 6 * link.b};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) k.block<6, 6>(at[i], at[j]) += of_link.block<6, 6>(6 * i, 6 * j);
  }
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(k);
  EXPECT_EQ(solver.rank(), n - 3);  // translations are free, rotations are not
  Matrix6 stiffness;
  for (int c = 0; c < 6; ++c) {
    const Matrix3& strain = unit_strains()[std::size_t(c)].value;
    const auto shift = [&](const Link& link) {
      return Vector3(link.branch - (model.particles[std::size_t(link.b)].position -
                                    model.particles[std::size_t(link.a)].position));
    };
    const auto at_ends = [&](const Link& link, const Eigen::VectorXd& u) {
      Vector12 ends;
      ends << u.segment<6>(6 * link.a), u.segment<6>(6 * link.b);
      ends.segment<3>(6) += strain * shift(link);
      return ends;
    };
    Eigen::VectorXd f = Eigen::VectorXd::Zero(n);
    for (const Link& link : network.links) {
      const Vector12 force = stiffness_matrix(link) * at_ends(link, Eigen::VectorXd::Zero(n));
      f.segment<6>(6 * link.a) -= force.head<6>();
      f.segment<6>(6 * link.b) -= force.tail<6>();
    }
    const Eigen::VectorXd u = solver.solve(f);
    Matrix3 stress = Matrix3::Zero();
    for (const Link& link : network.links) {
      const Vector12 force = stiffness_matrix(link) * at_ends(link, u);
      stress += force.segment<3>(6) * link.branch.transpose() / volume(*model.cell);
    }
    stiffness.col(c) = voigt_of_stress(0.5 * (stress + stress.transpose()));
  }
  EXPECT_LT(apart(stiffness_of(model).stiffness, stiffness), 1e-12);
}

TEST(PeriodicCell, MultigridGivesTheSameInAsManyIterationsAsWithoutPeriods) {
  std::mt19937_64 random(8);
  const Model model = periodic_packing(random, 12, beams());
  EXPECT_LT(apart(stiffness_of(model, "multigrid").stiffness, stiffness_of(model).stiffness), 1e-13);
  StaticOptions options;
  options.solver = "multigrid";
  EXPECT_LT(solve_statics(model, options).report.iterations, 60);
}

TEST(PeriodicCell, MultigridKnowsThatAThinCellCannotTurn) {
  std::mt19937_64 random(9);
  const Model model = repeated(periodic_packing(random, 3, beams()), {30, 1, 1});
  EXPECT_LT(apart(stiffness_of(model, "multigrid").stiffness, stiffness_of(model).stiffness), 1e-13);
}

TEST(PeriodicCell, MomentFreeCubicLatticeIsAMechanism) {
  std::vector<Vector3> points;
  for (int i = 0; i < 27; ++i) points.push_back(length * Vector3(i % 3, i / 3 % 3, i / 9));
  const Cell cell{{0, 0, 0}, 3 * length * Matrix3::Identity()};
  const BondBlock pins = block("contact", {{"kn", 1e6}, {"ks", 0}});
  EXPECT_THROW(solve_statics(periodic_model(points, std::vector<double>(27, length / 2), cell, pins), {}),
               MechanismError);
}

TEST(PeriodicCell, SheetUnderStrainInItsPlaneHasTheYoungAndPoissonOfItsBonds) {
  const double kn = 3e6, ks = 1e6, height = std::sqrt(3.0) / 2;
  Model model;
  std::vector<Vector3> points;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      points.push_back(length * Vector3(column + 0.5 * (row % 2), height * row, 0));
  Cell cell{{0, 0, 0}, Vector3(4 * length, 4 * height * length, 1).asDiagonal(), {true, true, false}};
  model = periodic_model(points, std::vector<double>(16, length / 2), cell,
                         block("generic", {{"kn", kn}, {"ks", ks}, {"kt", 2e3}, {"kb", 1e3}}));
  model.load_cases = {"xx"};
  model.strains.resize(1);
  const auto result = solve_statics(model, {}).cases[0];
  const double c11 = result.stress(0, 0), c12 = result.stress(1, 1);
  EXPECT_NEAR((c11 * c11 - c12 * c12) / c11 / (2 * std::sqrt(3.0) * kn * (kn + ks) / (3 * kn + ks)), 1,
              1e-13);
  EXPECT_NEAR(c12 / c11 / ((kn - ks) / (3 * kn + ks)), 1, 1e-13);
  // The strain is in the displacements.
  const Vector6 moved = result.displacement[7] - result.displacement[4];
  EXPECT_NEAR(moved[0] / (points[7] - points[4]).x(), 1, 1e-13);
}

TEST(PeriodicCell, StrainAndLoadsSuperpose) {
  std::mt19937_64 random(10);
  Model model = periodic_packing(random, 3, beams());
  const Vector6 force = vector6(1e3, -2e3, 3e3, 10, 20, -30);
  model.load_cases = {"strain", "force", "both"};
  model.strains = {{1e-3 * unit_strains()[5].value, 0}, {1e-3 * unit_strains()[5].value, 2}};
  load(model, 11, force, 1);
  load(model, 11, force, 2);
  const auto solution = solve_statics(model, {});
  EXPECT_FALSE(solution.effective);
  double size = 0, off = 0;
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    const Vector6 sum = solution.cases[0].displacement[p] + solution.cases[1].displacement[p];
    off = std::max(off, (solution.cases[2].displacement[p] - sum).cwiseAbs().maxCoeff());
    size = std::max(size, sum.cwiseAbs().maxCoeff());
  }
  EXPECT_LT(off, 1e-14 * size);
  for (const LoadCaseResult& result : solution.cases) {
    EXPECT_LT(result.accuracy.energy_balance, 1e-13) << result.name;
    EXPECT_LT(result.accuracy.moment_balance, 1e-13) << result.name;
  }
}

TEST(IsotropicFit, FindsTheConstantsOfAnIsotropicMaterial) {
  const double young = 70e9, poisson = 0.31, shear = young / (2 + 2 * poisson),
               lame = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
  const IsotropicFit fit = isotropic_fit(cubic(lame + 2 * shear, lame, shear));
  EXPECT_NEAR(fit.young / young, 1, 1e-14);
  EXPECT_NEAR(fit.poisson, poisson, 1e-14);
  EXPECT_LT(fit.misfit, 1e-15);
}

}  // namespace
}  // namespace bondstatic::test
