// The reported forward error must bound the true one, measured against quadruple precision.
#include <gtest/gtest.h>

#include "bondstatic/statics.hpp"
#include "support/models.hpp"
#include "support/quad_reference.hpp"

namespace bondstatic::test {
namespace {

// Chains, packings, and packings of two materials far apart; loads and prescribed motions.
Model random_model(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1), decades(0, 8);
  const auto material = [&](const char* law) {
    return block(law, {{"young", 1e9 * std::pow(10, decades(random) - 4)}, {"poisson", 0.25}});
  };
  Model model;
  const bool slender = random() % 2 == 0;
  if (slender) {
    const Index bonds = 5 + Index(random() % 15);
    const Vector3 end = Vector3(unit(random), unit(random), unit(random)) * 10 + Vector3(0, 0, 15);
    model = chain(material("timoshenko"), Vector3::Zero(), end, bonds, 0.05);
    model.blocks.push_back(material("parallel"));
    for (Bond& bond : model.bonds)
      if (random() % 3 == 0) bond.block = 1;
  } else {
    model = random_packing(random, 2 + int(random() % 2), material("timoshenko"));
    model.blocks.push_back(material("euler-bernoulli"));
    for (Bond& bond : model.bonds)
      if (random() % 3 == 0) bond.block = 2;
    fix_all(model, 0);
  }
  const Index last = Index(model.particles.size()) - 1;
  if (random() % 3 == 0)
    model.supports.push_back(
        {last, {true, false, false, false, true, false}, vector6(1e-3 * unit(random), 0, 0), every_case});
  for (Index p = 1; p <= last; p += 2)
    load(model, p,
         vector6(unit(random), unit(random), unit(random), unit(random), unit(random), unit(random)));
  return model;
}

double largest(const std::vector<Vector6T<long double>>& motion, double length) {
  long double size = 0;
  for (const auto& m : motion)
    size = std::max(
        {size, m.head<3>().lpNorm<Eigen::Infinity>(), length * m.tail<3>().lpNorm<Eigen::Infinity>()});
  return double(size);
}

TEST(ForwardError, BoundsTheTrueErrorOf100RandomModels) {
  std::mt19937_64 random(20221);
  double sharpest = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Model model = random_model(random);
    const auto result = solve_statics(model, {}).cases[0];
    const auto exact = quad_displacement(model);
    const double length = bond_network(model, bond_properties(model)).rotation_length;
    auto difference = exact;
    for (std::size_t p = 0; p < exact.size(); ++p)
      difference[p] -= result.displacement[p].cast<long double>();
    const double error = largest(difference, length) / largest(exact, length);
    EXPECT_LE(error, result.accuracy.forward_error) << "trial " << trial;
    EXPECT_LT(result.accuracy.forward_error, 1e-14) << "trial " << trial;
    sharpest = std::max(sharpest, error / result.accuracy.forward_error);
  }
  // A bound that is never within a factor of ten would say little.
  EXPECT_GT(sharpest, 0.1);
}

}  // namespace
}  // namespace bondstatic::test
