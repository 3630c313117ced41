// Elastic constants of lattices. Every site is a centre of symmetry, so under an affine motion of the
// boundary without rotation the inner particles follow the affine field, and the bonds of one inner particle
// hold twice the energy of its cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "bondstatic/statics.hpp"
#include "support/models.hpp"

namespace bondstatic::test {
namespace {

constexpr double length = 0.5;  // of every bond

struct Lattice {
  std::vector<Vector3> sites;
  double volume_per_site = 1;  ///< area for a sheet of unit thickness
};

Lattice cubic(double edge, const std::vector<Vector3>& basis) {
  Lattice lattice{{}, edge * edge * edge / double(basis.size())};
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 4; ++z)
        for (const Vector3& site : basis) lattice.sites.push_back(edge * (Vector3(x, y, z) + site));
  return lattice;
}

Lattice simple_cubic() {
  return cubic(length, {{0, 0, 0}});
}
Lattice body_centred() {
  return cubic(2 * length / std::sqrt(3.0), {{0, 0, 0}, {0.5, 0.5, 0.5}});
}
Lattice face_centred() {
  return cubic(std::sqrt(2.0) * length, {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}});
}
Lattice triangular_sheet() {
  const double height = std::sqrt(3.0) / 2;
  Lattice lattice{{}, height * length * length};
  for (int row = 0; row < 7; ++row)
    for (int column = 0; column < 7; ++column)
      lattice.sites.push_back(length * Vector3(column + 0.5 * (row % 2), height * row, 0));
  return lattice;
}

// Energy per unit volume under a symmetric strain, from the bonds of one inner particle.
double energy_density(const Lattice& lattice, const BondBlock& law, const Matrix3& strain) {
  Model model;
  model.blocks.push_back(law);
  for (const Vector3& site : lattice.sites) add_particle(model, site, length / 2);
  const std::size_t count = model.particles.size();
  std::vector<int> degree(count, 0);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b) {
      if ((lattice.sites[b] - lattice.sites[a]).norm() > 1.01 * length) continue;
      add_bond(model, Index(a), Index(b));
      ++degree[a], ++degree[b];
    }
  const int inner = *std::max_element(degree.begin(), degree.end());
  for (std::size_t p = 0; p < count; ++p) {
    if (degree[p] == inner) continue;
    Vector6 motion = Vector6::Zero();
    motion.head<3>() = strain * lattice.sites[p];
    fix_all(model, Index(p), motion);
  }
  const auto result = solve_statics(model, {}).cases[0];
  const double scale = strain.norm() * lattice.sites.back().norm();
  Index centre = -1;
  for (std::size_t p = 0; p < count; ++p) {
    if (degree[p] != inner) continue;
    const Vector3 expected = strain * lattice.sites[p];
    EXPECT_LT((result.displacement[p].head<3>() - expected).norm(), 1e-14 * scale);
    EXPECT_LT(result.displacement[p].tail<3>().norm() * length, 1e-14 * scale);
    centre = Index(p);
  }
  double energy = 0;
  for (std::size_t k = 0; k < model.bonds.size(); ++k)
    if (model.bonds[k].a == centre || model.bonds[k].b == centre) energy += result.bonds[k].energy;
  return energy / 2 / lattice.volume_per_site;
}

struct CubicConstants {
  double c11, c12, c44;
};

CubicConstants measured(const Lattice& lattice, const BondBlock& law) {
  Matrix3 axial = Matrix3::Zero(), biaxial = Matrix3::Zero(), shear = Matrix3::Zero();
  axial(0, 0) = 1;
  biaxial(0, 0) = biaxial(1, 1) = 1;
  shear(0, 1) = shear(1, 0) = 0.5;
  const double c11 = 2 * energy_density(lattice, law, axial);
  return {c11, energy_density(lattice, law, biaxial) - c11, 2 * energy_density(lattice, law, shear)};
}

struct LatticeCase {
  const char* name;
  Lattice lattice;
  std::function<CubicConstants(double kn, double ks)> expected;
};

void PrintTo(const LatticeCase& chosen, std::ostream* out) {
  *out << chosen.name;
}

class CubicLattice : public ::testing::TestWithParam<LatticeCase> {};

TEST_P(CubicLattice, HasTheElasticConstantsOfItsBonds) {
  const BondBlock law = block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.15}});
  const BondProperties bond =
      find_bond_law("timoshenko")->evaluate({length, length / 2, length / 2, 1, 2}, law.parameters);
  const CubicConstants expected = GetParam().expected(bond.stiffness.kn, bond.stiffness.ks);
  const CubicConstants found = measured(GetParam().lattice, law);
  EXPECT_NEAR(found.c11 / expected.c11, 1, 1e-13);
  EXPECT_NEAR((found.c12 - expected.c12) / expected.c11, 0, 1e-13);
  EXPECT_NEAR(found.c44 / expected.c44, 1, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(
    Verification, CubicLattice,
    ::testing::Values(
        LatticeCase{"SimpleCubic", simple_cubic(),
                    [](double kn, double ks) {
                      return CubicConstants{kn / length, 0, ks / (2 * length)};
                    }},
        LatticeCase{"BodyCentred", body_centred(),
                    [](double kn, double ks) {
                      const double s = std::sqrt(3.0) * length;
                      return CubicConstants{(kn + 2 * ks) / s, (kn - ks) / s, (2 * kn + ks) / (2 * s)};
                    }},
        LatticeCase{"FaceCentred", face_centred(),
                    [](double kn, double ks) {
                      const double s = std::sqrt(2.0) / length;
                      return CubicConstants{s * (kn + ks), s * (kn - ks) / 2, s * (kn + ks) / 2};
                    }}),
    [](const auto& chosen) { return std::string(chosen.param.name); });

TEST(TriangularSheet, HasTheYoungAndPoissonOfItsBonds) {
  const double kn = 3e6, ks = 1e6;
  const BondBlock law = block("generic", {{"kn", kn}, {"ks", ks}, {"kt", 2e3}, {"kb", 1e3}});
  const CubicConstants found =
      measured(triangular_sheet(), law);  // plane stress: the sheet has no third direction
  const double young = (found.c11 * found.c11 - found.c12 * found.c12) / found.c11,
               poisson = found.c12 / found.c11;
  EXPECT_NEAR(young / (2 * std::sqrt(3.0) * kn * (kn + ks) / (3 * kn + ks)), 1, 1e-13);
  EXPECT_NEAR(poisson / ((kn - ks) / (3 * kn + ks)), 1, 1e-13);
  EXPECT_NEAR(found.c44 / ((found.c11 - found.c12) / 2), 1, 1e-13);  // isotropic in its plane
}

}  // namespace
}  // namespace bondstatic::test
