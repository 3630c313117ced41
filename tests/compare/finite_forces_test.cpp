#include "compare/finite_forces.hpp"

#include <gtest/gtest.h>

#include <random>

#include "model/turning.hpp"
#include "support/models.hpp"
#include "system/incidence.hpp"

namespace bondstatic {

namespace {

using test::block;

struct Packing {
  Model model;
  BondNetwork network;
  BodyVectors<double> motion;  ///< of the order of one
};

Packing packing() {
  std::mt19937_64 random(7);
  Packing p;
  p.model = test::random_packing(
      random, 3,
      block("generic", {{"kn", 1e6}, {"ks", 4e5}, {"kt", 2e4}, {"kb", 3e4}}, {ContactPoint::Kind::gap, 0}));
  p.network = bond_network(p.model, bond_properties(p.model));
  std::uniform_real_distribution<double> any(-1, 1);
  p.motion.resize(p.model.particles.size());
  for (Vector6& u : p.motion)
    for (double& x : u) x = any(random);
  return p;
}

BodyVectors<double> scaled(const BodyVectors<double>& motion, double factor) {
  BodyVectors<double> out = motion;
  for (Vector6& u : out) u *= factor;
  return out;
}

double norm(const BodyVectors<double>& a) {
  double sum = 0;
  for (const Vector6& v : a) sum += v.squaredNorm();
  return std::sqrt(sum);
}

double distance(const BodyVectors<double>& a, BodyVectors<double> b) {
  for (std::size_t i = 0; i < b.size(); ++i) b[i] -= a[i];
  return norm(b);
}

BodyVectors<double> linear(const Packing& p, const BodyVectors<double>& motion, const Matrix3& strain) {
  return gather_forces<double>(p.network, link_incidence(p.network),
                               link_resultants<double>(p.network, motion, 1, strain), 1);
}

TEST(FiniteForces, AreTheLinearOnesToFirstOrder) {
  const Packing p = packing();
  Matrix3 strain;
  strain << 1, 0.2, 0, 0.2, -0.5, 0.3, 0, 0.3, 0.1;
  double before = 0;
  for (const double size : {1e-3, 1e-4, 1e-5}) {
    const auto motion = scaled(p.motion, size);
    const auto exact = linear(p, motion, size * strain);
    const double apart =
        distance(sum_of(finite_forces(p.network, motion, size * strain)), exact) / norm(exact);
    EXPECT_LE(apart, 10 * size);
    if (before > 0) {
      EXPECT_NEAR(before / apart, 10, 0.2);  // quadratic over linear
    }
    before = apart;
  }
  // No digits are lost where motions are tiny: only second order is left, down to rounding.
  const auto tiny = scaled(p.motion, 1e-14);
  const auto exact = linear(p, tiny, Matrix3::Zero());
  EXPECT_LE(distance(sum_of(finite_forces(p.network, tiny, Matrix3::Zero())), exact), 1e-12 * norm(exact));
}

TEST(FiniteForces, VanishInRigidMotionHoweverLarge) {
  Packing p = packing();
  const Vector3 turn(0.4, -1.1, 0.3), shift(2, 3, -1);
  for (std::size_t i = 0; i < p.motion.size(); ++i) {
    p.motion[i].head<3>() = shift + turning(turn, p.model.particles[i].position);
    p.motion[i].tail<3>() = turn;
  }
  // Of 1e6 N/m times a unit of length.
  EXPECT_LE(norm(sum_of(finite_forces(p.network, p.motion, Matrix3::Zero()))), 1e-7);
}

TEST(FiniteForces, BalanceInTheDeformedState) {
  const Packing p = packing();
  const auto motion = scaled(p.motion, 0.05);
  for (const BodyVectors<double>& part : finite_forces(p.network, motion, Matrix3::Zero())) {
    Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Vector3 f = part[i].head<3>(), m = part[i].tail<3>();
      const Vector3 at = p.model.particles[i].position + motion[i].head<3>();
      force += f;
      moment += m + at.cross(f);
    }
    EXPECT_LE(force.norm(), 1e-13 * norm(part));
    EXPECT_LE(moment.norm(), 1e-12 * norm(part));
  }
}

TEST(FiniteForces, PartsAreThoseOfTheirStiffness) {
  Packing p = packing();
  const auto motion = scaled(p.motion, 0.01);
  const PartForces before = finite_forces(p.network, motion, Matrix3::Zero());
  for (Link& link : p.network.links) link.stiffness.ks *= 3;
  const PartForces after = finite_forces(p.network, motion, Matrix3::Zero());
  for (std::size_t part = 0; part < stiffness_parts; ++part)
    EXPECT_LE(distance(after[part], scaled(before[part], part == shear_part ? 3 : 1)),
              1e-13 * norm(after[part]));
}

}  // namespace

}  // namespace bondstatic
