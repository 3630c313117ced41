// The step of central differences with dashpots that lag half a step.
#include <gtest/gtest.h>

#include <cmath>

#include "modes/problem.hpp"

namespace bondstatic::test {
namespace {

double step_of(const VibrationProblem& problem, const BondNetwork* dashpots, int threads = 1) {
  return critical_time_step(problem.network, dashpots, problem.dofs, problem.masses, threads);
}

VibrationProblem packing(int edge) {
  std::mt19937_64 random(5);
  Model model = random_packing(random, edge, block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}}));
  std::vector<std::uint8_t> free(model.particles.size(), 0x3f);
  free[0] = 0;
  return {std::move(model), std::move(free)};
}

// Coefficients of every size beside the stiffness, in no proportion to it.
BondNetwork random_dashpots(const VibrationProblem& problem, double most) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> share(0, most);
  const double step = step_of(problem, nullptr);
  BondNetwork dashpots = problem.network;
  for (Link& link : dashpots.links) {
    const SectionStiffness k = link.stiffness;
    link.stiffness = {share(random) * step * k.kn, share(random) * step * k.ks, share(random) * step * k.kt,
                      share(random) * step * k.kb, 0};
  }
  return dashpots;
}

// Bisection of lambda_max(M^-1 (2 dt D + dt^2 K)) = 4 by dense solves.
double dense_step(const VibrationProblem& problem, const BondNetwork& dashpots) {
  const Eigen::MatrixXd k = problem.scaled_stiffness<double>(problem.network);
  const Eigen::MatrixXd d = problem.scaled_stiffness<double>(dashpots);
  double stable = 0, unstable = 2 / problem.dense_frequencies<double>().maxCoeff();
  for (int i = 0; i < 55; ++i) {
    const double dt = (stable + unstable) / 2;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(2 * dt * d + dt * dt * k,
                                                                Eigen::EigenvaluesOnly);
    (solver.eigenvalues().maxCoeff() <= 4 ? stable : unstable) = dt;
  }
  return stable;
}

TEST(CriticalTimeStep, OfOneMassFollowsTheClosedForm) {
  const double k = 4e6, m = 0.01, w = std::sqrt(k / m);
  const VibrationProblem one = spring_chain(1, k, m);
  EXPECT_NEAR(step_of(one, nullptr) * w / 2, 1, 1e-10);
  for (const double zeta : {0.0, 1e-3, 0.3, 1.0, 50.0}) {
    BondNetwork dashpots = one.network;
    dashpots.links[0].stiffness = {2 * zeta * std::sqrt(k * m), 0, 0, 0, 0};
    const double exact = 2 / w / (std::sqrt(1 + zeta * zeta) + zeta);
    EXPECT_NEAR(step_of(one, &dashpots) / exact, 1, 1e-9) << zeta;
  }
}

TEST(CriticalTimeStep, IsTwoOverTheHighestFrequencyWithoutDamping) {
  const VibrationProblem problem = packing(4);
  const double step = 2 / highest_frequency(problem.network, problem.dofs, problem.masses, 1);
  EXPECT_DOUBLE_EQ(step_of(problem, nullptr), step);
  BondNetwork none = problem.network;
  for (Link& link : none.links) link.stiffness = {};
  EXPECT_NEAR(step_of(problem, &none) / step, 1, 1e-9);
}

TEST(CriticalTimeStep, OfAPackingIsWhereTheDenseEigenvalueReachesFour) {
  const VibrationProblem problem = packing(4);
  for (const double most : {0.05, 1.0, 100.0}) {
    const BondNetwork dashpots = random_dashpots(problem, most);
    const double exact = dense_step(problem, dashpots), found = step_of(problem, &dashpots);
    EXPECT_NEAR(found / exact, 1, 1e-9) << most;
    EXPECT_LT(found, exact * (1 + 1e-12)) << most;
  }
}

TEST(CriticalTimeStep, OfDashpotsAloneIsTheirs) {
  VibrationProblem one = spring_chain(1, 0, 3);
  BondNetwork dashpots = one.network;
  dashpots.links[0].stiffness.kn = 12;
  EXPECT_NEAR(step_of(one, &dashpots), 0.5, 1e-10);
}

// The scheme itself: bounded just below the step, growing just above.
TEST(CriticalTimeStep, SeparatesBoundedFromGrowingMotion) {
  const VibrationProblem chain = spring_chain(5, 2, 1);
  BondNetwork dashpots = chain.network;
  for (std::size_t i = 0; i < dashpots.links.size(); ++i)
    dashpots.links[i].stiffness.kn = 0.2 + 0.1 * double(i);
  const Eigen::MatrixXd k = chain.scaled_stiffness<double>(chain.network);
  const Eigen::MatrixXd d = chain.scaled_stiffness<double>(dashpots);
  const auto amplitude = [&](double dt) {
    Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(5, 1, -1), v = Eigen::VectorXd::Zero(5);
    for (int i = 0; i < 20000; ++i) {
      v -= dt * (k * u + d * v);
      u += dt * v;
    }
    return u.norm();
  };
  const double step = step_of(chain, &dashpots);
  EXPECT_LT(amplitude(0.999 * step), 10);
  EXPECT_GT(amplitude(1.001 * step), 1e3);
}

TEST(CriticalTimeStep, HasTheSameBitsOnAnyNumberOfThreads) {
  const VibrationProblem problem = packing(17);
  const BondNetwork dashpots = random_dashpots(problem, 0.5);
  EXPECT_EQ(step_of(problem, &dashpots, 1), step_of(problem, &dashpots, 4));
}

TEST(CriticalTimeStep, RefusesDashpotsOfOtherLinks) {
  const VibrationProblem one = spring_chain(1, 1, 1), two = spring_chain(2, 1, 1);
  EXPECT_THROW(step_of(one, &two.network), std::invalid_argument);
}

}  // namespace
}  // namespace bondstatic::test
