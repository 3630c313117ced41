// B^T C B against the 12x12 of [Chen2022] Eq. 14-25 written out, its eigenvalues, and its symmetries.
#include <Eigen/Eigenvalues>
#include <numbers>

#include "bond/bond_fixture.hpp"

namespace bondstatic {
namespace {

using std::numbers::pi;
using Real = long double;
using Matrix12L = Eigen::Matrix<Real, 12, 12>;

/// Eq. 14-25 in the bond's own axes; entry (2,2) is +k2 (the print's minus breaks symmetry).
Matrix12L chen_local(Real young, Real poisson, Real r, Real l) {
  const Real p = std::numbers::pi_v<Real>, area = p * r * r, i = p * r * r * r * r / 4;
  const Real phi = 20 * r * r * (1 + poisson) / (3 * l * l);
  const Real k1 = young * area / l, k2 = 12 * young * i / (l * l * l * (1 + phi)), k3 = l * k2 / 2;
  const Real k4 = young * i / (l * (1 + poisson)), k5 = young * i / l * (4 + phi) / (1 + phi);
  const Real k6 = young * i / l * (2 - phi) / (1 + phi);
  Matrix12L k;
  k << k1, 0, 0, 0, 0, 0, -k1, 0, 0, 0, 0, 0,     //
      0, k2, 0, 0, 0, k3, 0, -k2, 0, 0, 0, k3,    //
      0, 0, k2, 0, -k3, 0, 0, 0, -k2, 0, -k3, 0,  //
      0, 0, 0, k4, 0, 0, 0, 0, 0, -k4, 0, 0,      //
      0, 0, -k3, 0, k5, 0, 0, 0, k3, 0, k6, 0,    //
      0, k3, 0, 0, 0, k5, 0, -k3, 0, 0, 0, k6,    //
      -k1, 0, 0, 0, 0, 0, k1, 0, 0, 0, 0, 0,      //
      0, -k2, 0, 0, 0, -k3, 0, k2, 0, 0, 0, -k3,  //
      0, 0, -k2, 0, k3, 0, 0, 0, k2, 0, k3, 0,    //
      0, 0, 0, -k4, 0, 0, 0, 0, 0, k4, 0, 0,      //
      0, 0, -k3, 0, k6, 0, 0, 0, k3, 0, k5, 0,    //
      0, k3, 0, 0, 0, k6, 0, -k3, 0, 0, 0, k5;
  return k;
}

/// Rows e_x, e_y, e_z: from global to bond axes, for all four vectors.
Matrix12L rotation(const Vector3& axis) {
  const Vector3T<Real> x = axis.cast<Real>().normalized();
  const Vector3T<Real> y = x.unitOrthogonal(), z = x.cross(y);
  Matrix12L t = Matrix12L::Zero();
  for (int block = 0; block < 4; ++block) {
    t.block<1, 3>(3 * block, 3 * block) = x.transpose();
    t.block<1, 3>(3 * block + 1, 3 * block) = y.transpose();
    t.block<1, 3>(3 * block + 2, 3 * block) = z.transpose();
  }
  return t;
}

// As slender as the paper's thinnest bond, L/2r = 10: the rounding of kn in moments grows with L/r.
TEST(StiffnessMatrix, EqualsChenEq14ForRandomBonds) {
  RandomBonds random;
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    const double young = std::pow(10.0, random.uniform(6, 12)), poisson = random.uniform(-0.9, 0.5);
    const double l = std::pow(10.0, random.uniform(-4, 2)), r = l * std::pow(10.0, random.uniform(-1.3, 0));
    const Vector3 branch = l * random.direction();
    const BondProperties p = evaluate("timoshenko", {{"young", young}, {"poisson", poisson}, {"radius", r}},
                                      site(branch.norm(), random.uniform(0.1, 1), 0.3));
    const Matrix12L t = rotation(branch);
    const Matrix12L chen = t.transpose() * chen_local(young, poisson, r, branch.cast<Real>().norm()) * t;
    worst = std::max(worst, scaled_difference(stiffness_matrix(link(p, branch)).cast<Real>(), chen));
  }
  EXPECT_LT(worst, 1e-14);
}

// The two ways to the same matrix; C as a dense matrix spreads kn's rounding, so only for stocky bonds this
// tightly.
TEST(StiffnessMatrix, IsBTransposedCB) {
  RandomBonds random;
  for (const auto& [name, inputs] : typical_inputs()) {
    const BondSite here = random.gapped_site();
    const Link bond = link(evaluate(name, inputs, here), here.length * random.direction());
    const Matrix6x12 b = relative_motion_matrix(bond);
    const Matrix12 product = b.transpose() * constitutive_matrix(bond.stiffness, bond_axis<double>(bond)) * b;
    EXPECT_LT(scaled_difference(stiffness_matrix(bond), product), 1e-14) << name;
  }
}

const double young = 2.1e11, poisson = 0.3, r = 0.05, l = 0.4;

Matrix12 printed_bond() {
  const BondProperties p =
      evaluate("timoshenko", {{"young", young}, {"poisson", poisson}, {"radius", r}}, site(l, 0.2, 0.2));
  return stiffness_matrix(link(p, {l, 0, 0}));
}

TEST(StiffnessMatrix, ConstitutiveMatrixAnswersAsResultantsDo) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 100; ++trial) {
    const Vector3 axis = Vector3(number(random), number(random), number(random)).normalized();
    const SectionStiffness c{1 + number(random), 1e6 * (1 + number(random)), 1 + number(random),
                             1e-6 * (1 + number(random)), number(random)};
    const Matrix6 matrix = constitutive_matrix(c, axis);
    for (int j = 0; j < 6; ++j) EXPECT_EQ(matrix.col(j), resultants<double>(c, axis, Vector6::Unit(j)));
  }
}

TEST(StiffnessMatrix, HasTheEntriesOfTheReferenceBond) {
  const Matrix12 k = printed_bond();
  const auto expect = [&](int i, int j, double value) {
    EXPECT_NEAR(k(i - 1, j - 1), value, 1e-14 * std::abs(value)) << i << "," << j;
  };
  expect(1, 1, 4123340357.836604);
  expect(2, 2, 170229647.80059373);
  expect(2, 6, 34045929.56011875);
  expect(6, 6, 9386273.63567163);
  expect(6, 12, 4232098.1883758735);
  expect(4, 4, 1982375.1720368292);
}

TEST(StiffnessMatrix, HasSixKnownEigenvaluesAndSixZeros) {
  const double area = pi * r * r, i = area * r * r / 4, g = young / (2 * (1 + poisson));
  const double ks = 12 * young * i / (l * l * l * (1 + 20 * r * r * (1 + poisson) / (3 * l * l)));
  std::vector<double> expected(6, 0.0);
  for (const double value : {2 * young * area / l, 2 * g * 2 * i / l, 2 * young * i / l, 2 * young * i / l,
                             ks * (2 + l * l / 2), ks * (2 + l * l / 2)})
    expected.push_back(value);
  std::sort(expected.begin(), expected.end());
  const Vector12 found = Eigen::SelfAdjointEigenSolver<Matrix12>(printed_bond()).eigenvalues();
  // Eigenvalues of a symmetric matrix are found to rounding of the largest.
  for (int k = 0; k < 12; ++k) EXPECT_NEAR(found[k], expected[std::size_t(k)], 1e-14 * expected.back()) << k;
}

Vector12 rigid_motion(const Vector3& x_a, const Vector3& x_b, const Vector3& shift, const Vector3& turn) {
  Vector12 u;
  u << shift + turn.cross(x_a), turn, shift + turn.cross(x_b), turn;
  return u;
}

TEST(EveryLaw, HasASymmetricMatrixThatRigidMotionsDoNotFeel) {
  RandomBonds random;
  for (const auto& [name, inputs] : typical_inputs()) {
    for (int k = 0; k < 100; ++k) {
      const BondSite here = random.gapped_site();
      const Vector3 branch = here.length * random.direction(), x_a = random.direction(), x_b = x_a + branch;
      const Matrix12 matrix = stiffness_matrix(link(evaluate(name, inputs, here), branch));
      const Vector12 u = rigid_motion(x_a, x_b, random.direction(), random.direction());
      const Vector12 size = matrix.cwiseAbs() * u.cwiseAbs();
      EXPECT_LT(scaled_difference(matrix.transpose(), matrix), 1e-14) << name;
      EXPECT_LT(((matrix * u).array() / size.array()).abs().maxCoeff(), 4e-15) << name;
    }
  }
}

TEST(EveryLaw, GivesTheSameBondFromEitherEnd) {
  RandomBonds random;
  for (const auto& [name, inputs] : typical_inputs()) {
    for (int k = 0; k < 100; ++k) {
      const BondSite here = random.gapped_site();
      BondSite there = here;
      std::swap(there.radius_a, there.radius_b);
      std::swap(there.id_a, there.id_b);
      const Vector3 branch = here.length * random.direction();
      const Matrix12 forth = stiffness_matrix(link(evaluate(name, inputs, here), branch));
      const Matrix12 back = stiffness_matrix(link(evaluate(name, inputs, there), -branch));
      Matrix12 swapped;
      swapped << back.bottomRightCorner<6, 6>(), back.bottomLeftCorner<6, 6>(), back.topRightCorner<6, 6>(),
          back.topLeftCorner<6, 6>();
      EXPECT_LT(scaled_difference(swapped, forth), 1e-14) << name;
    }
  }
}

TEST(EveryLaw, HasNoNegativeEigenvalue) {
  RandomBonds random;
  for (const auto& [name, inputs] : typical_inputs()) {
    const BondSite here = random.gapped_site();
    const Matrix12 matrix =
        stiffness_matrix(link(evaluate(name, inputs, here), here.length * random.direction()));
    const Vector12 values = Eigen::SelfAdjointEigenSolver<Matrix12>(matrix).eigenvalues();
    EXPECT_GT(values[0], -1e-14 * values[11]) << name;
    const bool full = evaluate(name, inputs, here).stiffness.full_rank();
    EXPECT_EQ(full, name != "contact");
    EXPECT_EQ((values.array() > 1e-9 * values[11]).count(), full ? 6 : 3) << name;
  }
}

}  // namespace
}  // namespace bondstatic
