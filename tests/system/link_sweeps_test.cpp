// Four links at a time against one link after another.
#include "system/link_sweeps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace bondstatic::test {
namespace {

constexpr double few_roundings = 0x1p-98;  // of the sum of the magnitudes, in Extended

/// Links of all kinds between any bodies; one in three couples shear and bending.
struct Tangle {
  BondNetwork network;
  Incidence incidence;
  BodyVectors<Extended> motion, other;
  Matrix3 strain;

  Tangle(Index bodies, Index links) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> any(-1, 1), decades(-6, 6);
    const auto number = [&] { return Extended(any(random), 0x1p-54 * any(random)); };
    network.bodies = bodies;
    for (Index k = 0; k < links; ++k) {
      Link link;
      link.a = std::uniform_int_distribution<Index>(0, bodies - 2)(random);
      link.b = std::uniform_int_distribution<Index>(link.a + 1, bodies - 1)(random);
      link.branch = {any(random), any(random), any(random)};
      link.fraction = 0.5 + 0.4 * any(random);
      auto& [kn, ks, kt, kb, coupling] = link.stiffness;
      for (double* c : {&kn, &ks, &kt, &kb}) *c = std::pow(10, decades(random));
      if (k % 3 == 0) coupling = any(random) * std::sqrt(ks * kb);
      network.links.push_back(link);
    }
    incidence = link_incidence(network);
    for (auto* of_bodies : {&motion, &other})
      for (Index p = 0; p < bodies; ++p) {
        Vector6T<Extended>& u = of_bodies->emplace_back();
        for (int i = 0; i < 6; ++i) u[i] = number();
      }
    for (int i = 0; i < 9; ++i) strain.data()[i] = any(random);
  }
};

// A pack that is not full, more links than one thread takes, more than are swept at once.
TEST(LinkSweeps, ForcesAreThoseOfOneLinkAfterAnother) {
  for (const Index links : {1, 5, 1001, 40003}) {
    const Tangle tangle(Index(2) + links / 3, links);
    for (const Matrix3& strain : {Matrix3(Matrix3::Zero()), tangle.strain}) {
      const auto q = link_resultants<Extended>(tangle.network, tangle.motion, 1, strain);
      const auto expected = gather_forces<Extended>(tangle.network, tangle.incidence, q, 1);
      const auto carried = [&](int threads) {
        BodyVectors<Extended> left(std::size_t(tangle.network.bodies), Vector6T<Extended>::Zero());
        subtract_carried_forces(tangle.network, tangle.motion, strain, threads, left);
        return left;
      };
      const auto found = carried(1);
      EXPECT_EQ(found, carried(3));
      const auto magnitude =
          force_magnitudes(tangle.network, tangle.incidence, converted<double>(tangle.motion), 1, strain);
      double worst = 0;  // of what one link can carry in all directions, as a rotated sum rounds
      for (std::size_t p = 0; p < found.size(); ++p)
        for (int i = 0; i < 6; ++i)
          worst = std::max(worst, to_double(abs(found[p][i] + expected[p][i])) /
                                      std::max(1e-300, magnitude[p].maxCoeff()));
      EXPECT_LE(worst, few_roundings);
    }
  }
}

TEST(LinkSweeps, StatesAreThoseOfOneLinkAfterAnother) {
  const Tangle tangle(40, 103);
  const BondNetwork& network = tangle.network;
  std::vector<LinkState> found(50);
  link_states(network, tangle.motion, tangle.strain, 53, 103, found.data());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Link& link = network.links[53 + k];
    const auto delta = link_motion<Extended>(link, tangle.motion, tangle.strain);
    const auto q = resultants<Extended>(link.stiffness, bond_axis<Extended>(link), delta);
    const Vector6 moved = motion_magnitude(link, tangle.motion[std::size_t(link.a)].cast<double>(),
                                           tangle.motion[std::size_t(link.b)].cast<double>(), tangle.strain);
    const Vector6 carried =
        resultant_magnitude(link.stiffness, bond_axis<double>(link), Vector6::Constant(moved.maxCoeff()));
    for (int i = 0; i < 6; ++i) {
      EXPECT_LE(to_double(abs(found[k].delta[i] - delta[i])), few_roundings * moved.maxCoeff());
      EXPECT_LE(to_double(abs(found[k].q[i] - q[i])), few_roundings * carried.maxCoeff());
    }
  }
}

// q is linear in each number of C: epsilon . (dC/dc) delta is epsilon . q where that number alone is 1.
TEST(LinkSweeps, ProductsAreThoseOfTheLaw) {
  const Tangle tangle(30, 71);
  const BondNetwork& network = tangle.network;
  std::vector<double> of_motion, kept;
  BodyVectors<double> own;
  for (Index k = 0; k < 71; ++k) {
    of_motion.push_back(0.25 * double(k % 4));
    kept.push_back(k % 5 == 0 ? 0 : 1);
    own.push_back(k % 2 == 0 ? Vector6(Vector6::Zero()) : Vector6(Vector6::LinSpaced(-1, double(k) / 10)));
  }
  const auto found =
      stiffness_products(network, tangle.motion, tangle.strain, {tangle.other, of_motion, own, kept}, 1);
  double SectionStiffness::*const numbers[] = {&SectionStiffness::kn, &SectionStiffness::ks,
                                               &SectionStiffness::kt, &SectionStiffness::kb,
                                               &SectionStiffness::coupling};
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Link& link = network.links[k];
    const auto delta = link_motion<Extended>(link, tangle.motion, tangle.strain);
    const Vector6T<Extended> felt =
        link_motion<Extended>(link, tangle.other, Matrix3::Zero()) + Extended(of_motion[k]) * delta;
    for (const auto number : numbers) {
      SectionStiffness unit;
      unit.*number = 1;
      const bool of_moments = number == &SectionStiffness::kt || number == &SectionStiffness::kb;
      const auto q = resultants<Extended>(unit, bond_axis<Extended>(link), delta);
      Vector6T<Extended> epsilon = own[k].cast<Extended>();
      if (!of_moments || kept[k] != 0) epsilon += felt;
      const double size = q.cast<double>().norm() * (felt.cast<double>().norm() + own[k].norm());
      EXPECT_NEAR(found[k].*number, to_double(epsilon.dot(q)), 0x1p-52 * size);
    }
  }
}

}  // namespace
}  // namespace bondstatic::test
