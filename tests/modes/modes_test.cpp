// Frequencies against dense solves and closed forms, up to the sizes where Lanczos takes over.
#include "bondstatic/modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bondstatic/error.hpp"
#include "modes/problem.hpp"

namespace bondstatic::test {
namespace {

constexpr std::uint8_t all_free = 0x3f;

BondBlock beam() {
  return block("timoshenko", {{"young", 5e9}, {"poisson", 0.2}});
}

// A few bodies held, one partly.
VibrationProblem packing(int edge, const BondBlock& law = beam()) {
  std::mt19937_64 random(7);
  Model model = random_packing(random, edge, law);
  std::vector<std::uint8_t> free(model.particles.size(), all_free);
  for (int p = 0; p < edge; ++p) free[std::size_t(p)] = 0;
  free.back() = 0b101101;
  return {std::move(model), std::move(free)};
}

// A bar along z of equal spheres on a cubic lattice, its foot held.
VibrationProblem lattice(int wide, int high) {
  Model model;
  model.blocks = {beam()};
  std::vector<std::uint8_t> free;
  const auto at = [&](int x, int y, int z) { return Index((z * wide + y) * wide + x); };
  for (int z = 0; z < high; ++z)
    for (int y = 0; y < wide; ++y)
      for (int x = 0; x < wide; ++x) {
        add_particle(model, Vector3(x, y, z), 0.5);
        model.particles.back().density = 2000;
        free.push_back(z == 0 ? 0 : all_free);
        if (x > 0) add_bond(model, at(x - 1, y, z), at(x, y, z));
        if (y > 0) add_bond(model, at(x, y - 1, z), at(x, y, z));
        if (z > 0) add_bond(model, at(x, y, z - 1), at(x, y, z));
      }
  return {std::move(model), std::move(free)};
}

void expect_lowest(const std::vector<Mode>& modes, const Eigen::VectorXd& exact) {
  for (std::size_t i = 0; i < modes.size(); ++i)
    EXPECT_NEAR(modes[i].frequency / exact[Index(i)], 1, 1e-10) << "mode " << i;
}

void expect_orthonormal(const VibrationProblem& problem, const std::vector<Mode>& modes) {
  for (std::size_t i = 0; i < modes.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double product = 0;
      for (std::size_t p = 0; p < problem.masses.mass.size(); ++p) {
        const Vector6 &a = modes[i].shape[p], &b = modes[j].shape[p];
        product += problem.masses.mass[p] * a.head<3>().dot(b.head<3>()) +
                   problem.masses.inertia[p] * a.tail<3>().dot(b.tail<3>());
      }
      EXPECT_NEAR(product, i == j ? 1 : 0, 1e-11) << i << ", " << j;
    }
}

TEST(Modes, OfRandomPackingsAreThoseOfADenseSolve) {
  const BondBlock stepped = block("two-segment", {{"young", 5e9}, {"poisson", 0.2}});
  for (const int edge : {2, 3, 5}) {
    const VibrationProblem problem = packing(edge, edge == 3 ? stepped : beam());
    const Eigen::VectorXd exact = problem.dense_frequencies<double>();
    const std::vector<Mode> modes = problem.lowest(12);
    ASSERT_EQ(modes.size(), 12u);
    expect_lowest(modes, exact);
    expect_orthonormal(problem, modes);
    const double highest = highest_frequency(problem.network, problem.dofs, problem.masses, 2);
    EXPECT_NEAR(highest / exact[exact.size() - 1], 1, 1e-10) << edge;
    EXPECT_GT(highest, exact[exact.size() - 1] * (1 - 1e-13));
  }
}

// What an iterative solver leaves is solved for once more, and a frequency's error is that of its mode
// squared.
TEST(Modes, ComeFromAnIterativeSolverAsWell) {
  std::mt19937_64 random(9);
  const Model model = random_packing(random, 6, block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}}));
  std::vector<std::uint8_t> free(model.particles.size(), 0x3f);
  std::fill_n(free.begin(), 36, std::uint8_t(0));
  const VibrationProblem problem(model, free);
  const auto direct = problem.lowest(6), iterative = problem.lowest(6, "multigrid");
  ASSERT_EQ(iterative.size(), direct.size());
  for (std::size_t i = 0; i < direct.size(); ++i)
    EXPECT_LT(std::abs(iterative[i].frequency / direct[i].frequency - 1), 1e-11) << i;
}

TEST(Modes, SatisfyTheirEquation) {
  const VibrationProblem problem = packing(4);
  const Eigen::MatrixXd a = problem.scaled_stiffness<double>(problem.network);
  const Eigen::VectorXd root = problem.mass_diagonal().cwiseSqrt();
  for (const Mode& mode : problem.lowest(5)) {
    Eigen::VectorXd y(root.size());
    Index unknown = 0;
    for (std::size_t p = 0; p < mode.shape.size(); ++p)
      for (int i = 0; i < 6; ++i)
        if (problem.dofs.is_free(Index(p), i)) {
          y[unknown] = root[unknown] * mode.shape[p][i];
          ++unknown;
        } else {
          EXPECT_EQ(mode.shape[p][i], 0);
        }
    const double square = mode.frequency * mode.frequency;
    EXPECT_LT((a * y - square * y).norm(), 1e-9 * square);
    Index largest = 0;
    y.cwiseAbs().maxCoeff(&largest);
    EXPECT_GT(y[largest], 0);
  }
}

TEST(Modes, OfASpringChainFollowTheClosedForm) {
  const double k = 3e-7, m = 2e4;  // frequencies far from one: thresholds are relative
  for (const Index n : {1, 2, 50, 400}) {
    const VibrationProblem chain = spring_chain(n, k, m);
    const auto exact = [&](Index j) {
      return 2 * std::sqrt(k / m) * std::sin(double(2 * j - 1) * std::numbers::pi / double(2 * (2 * n + 1)));
    };
    const std::vector<Mode> modes = chain.lowest(10);
    ASSERT_EQ(Index(modes.size()), std::min<Index>(10, n));
    for (std::size_t j = 0; j < modes.size(); ++j)
      EXPECT_NEAR(modes[j].frequency / exact(Index(j) + 1), 1, 1e-10) << n << ": " << j;
    EXPECT_NEAR(highest_frequency(chain.network, chain.dofs, chain.masses, 1) / exact(n), 1, 1e-10) << n;
  }
}

TEST(Modes, HighestIsAnUpperBoundWhereTheSpectrumIsDense) {
  const Index n = 3000;
  const VibrationProblem chain = spring_chain(n, 1, 1);
  const double exact = 2 * std::sin(double(2 * n - 1) * std::numbers::pi / double(2 * (2 * n + 1)));
  const double highest = highest_frequency(chain.network, chain.dofs, chain.masses, 1);
  EXPECT_GT(highest, exact * (1 - 1e-8));
  EXPECT_LT(highest, exact * (1 + 1e-4));
}

TEST(Modes, OfASlenderCantileverComeInPairsAndKeepTheirDigits) {
  const VibrationProblem problem = lattice(1, 80);
  const std::vector<Mode> modes = problem.lowest(8);
  expect_lowest(modes, problem.dense_frequencies<long double>());
  expect_orthonormal(problem, modes);
  EXPECT_NEAR(modes[1].frequency / modes[0].frequency, 1, 1e-10);
}

TEST(Modes, OfALatticeBlockComeAsOftenAsTheyOccur) {
  const VibrationProblem problem = lattice(5, 6);
  const Eigen::VectorXd exact = problem.dense_frequencies<double>();
  for (const Index count : {1, 2, 3, 20}) {
    const std::vector<Mode> modes = problem.lowest(count);
    ASSERT_EQ(Index(modes.size()), count);
    expect_lowest(modes, exact);
    expect_orthonormal(problem, modes);
  }
  EXPECT_NEAR(highest_frequency(problem.network, problem.dofs, problem.masses, 1) / exact[exact.size() - 1],
              1, 1e-10);
  // Less asked for is still an upper bound.
  const double rough = highest_frequency(problem.network, problem.dofs, problem.masses, 1, 1e-4);
  EXPECT_GE(rough, exact[exact.size() - 1] * (1 - 1e-10));
  EXPECT_LE(rough, exact[exact.size() - 1] * (1 + 1e-4));
}

// Bodies that all hang alike from one: no frequency occurs less than 300 times.
TEST(Modes, MayAllBeEqual) {
  VibrationProblem star = spring_chain(300, 0, 2);
  for (Link& link : star.network.links) {
    link.a = 0;
    link.stiffness.kn = 8;
  }
  const std::vector<Mode> modes = star.lowest(7);
  ASSERT_EQ(modes.size(), 7u);
  for (const Mode& mode : modes) EXPECT_NEAR(mode.frequency, 2, 1e-12);
  expect_orthonormal(star, modes);
  EXPECT_NEAR(highest_frequency(star.network, star.dofs, star.masses, 1), 2, 1e-10);
}

TEST(Modes, OfTinySystems) {
  const VibrationProblem all = packing(2);
  const Eigen::VectorXd exact = all.dense_frequencies<double>();
  const std::vector<Mode> modes = all.lowest(1000);
  ASSERT_EQ(Index(modes.size()), all.dofs.unknowns());
  expect_lowest(modes, exact);

  VibrationProblem held = packing(2);
  held.dofs = number_free_dofs(std::vector<std::uint8_t>(std::size_t(held.network.bodies), 0));
  const std::unique_ptr<LinearSolver> solver = make_solver("auto", 1);
  EXPECT_TRUE(lowest_modes(held.network, held.dofs, held.masses, *solver, 3).empty());
  EXPECT_EQ(highest_frequency(held.network, held.dofs, held.masses, 1), 0);
  EXPECT_TRUE(std::isinf(critical_time_step(held.network, nullptr, held.dofs, held.masses, 1)));

  VibrationProblem loose = packing(7);  // beyond the dense solve, too
  loose.network.links.clear();
  EXPECT_EQ(highest_frequency(loose.network, loose.dofs, loose.masses, 1), 0);
  EXPECT_TRUE(std::isinf(critical_time_step(loose.network, &loose.network, loose.dofs, loose.masses, 1)));
}

TEST(Modes, OfAFreeBodyHaveAHighestFrequency) {
  VibrationProblem problem = packing(3);
  problem.dofs = number_free_dofs(std::vector<std::uint8_t>(std::size_t(problem.network.bodies), all_free));
  const Eigen::MatrixXd a = problem.scaled_stiffness<double>(problem.network);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> dense(a, Eigen::EigenvaluesOnly);
  EXPECT_NEAR(highest_frequency(problem.network, problem.dofs, problem.masses, 1) /
                  std::sqrt(dense.eigenvalues().tail<1>()[0]),
              1, 1e-10);
}

TEST(Modes, NeedMasses) {
  VibrationProblem problem = packing(2);
  problem.masses.mass[0] = not_given;  // held: nobody asks
  EXPECT_GT(highest_frequency(problem.network, problem.dofs, problem.masses, 1), 0);
  problem.masses.inertia[5] = not_given;
  try {
    highest_frequency(problem.network, problem.dofs, problem.masses, 1);
    FAIL() << "took a body without inertia";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_NE(std::string(error.what()).find("moment of inertia of body 5"), std::string::npos);
  }
}

TEST(Modes, OfParticlesWeighSpheres) {
  Model model;
  add_particle(model, Vector3::Zero(), 0.5);
  add_particle(model, Vector3::UnitX(), 0.5);
  model.particles[0].density = 6 / std::numbers::pi;
  const BodyMasses masses = body_masses(model);
  EXPECT_NEAR(masses.mass[0], 1, 1e-15);
  EXPECT_NEAR(masses.inertia[0], 0.1, 1e-16);
  EXPECT_TRUE(std::isnan(masses.mass[1]) && std::isnan(masses.inertia[1]));
}

TEST(Modes, HaveTheSameBitsOnAnyNumberOfThreads) {
  const VibrationProblem problem = packing(17);  // loops long enough to be shared out
  const double one = highest_frequency(problem.network, problem.dofs, problem.masses, 1);
  for (const int threads : {2, 4})
    EXPECT_EQ(one, highest_frequency(problem.network, problem.dofs, problem.masses, threads));
  const VibrationProblem small = packing(6);
  const std::vector<Mode> a = small.lowest(2), b = small.lowest(2);
  EXPECT_EQ(a[1].frequency, b[1].frequency);
  EXPECT_EQ(a[1].shape, b[1].shape);
}

}  // namespace
}  // namespace bondstatic::test
