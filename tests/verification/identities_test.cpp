// What holds for any model under any law: 200 random polydisperse packings each.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "bondstatic/statics.hpp"
#include "support/models.hpp"
#include "system/assemble.hpp"

namespace bondstatic::test {
namespace {

constexpr int packings = 200;

struct LawCase {
  const char* name;
  const char* law;
  Values values;
  double smallest_radius = 0.3;  // 0.1 leaves gaps everywhere
};

void PrintTo(const LawCase& chosen, std::ostream* out) {
  *out << chosen.law;
}

const LawCase law_cases[] = {
    {"Parallel", "parallel", {{"young", 5e9}, {"poisson", 0.2}, {"radius_factor", 0.8}}},
    {"PfcParallel", "pfc-parallel", {{"normal_stiffness", 5e9}, {"shear_stiffness", 2e9}}},
    {"EulerBernoulli", "euler-bernoulli", {{"young", 5e9}, {"poisson", 0.2}}},
    {"Timoshenko", "timoshenko", {{"young", 5e9}, {"poisson", 0.3}}},
    {"Obermayr", "obermayr", {{"young", 5e9}, {"poisson", 0.3}}},
    {"EdemV2",
     "edem-v2",
     {{"normal_stiffness", 5e9}, {"shear_stiffness", 2e9}, {"normal_range", 1e9}, {"torque_feedback", 1}}},
    {"EdemV2WithoutFeedback",
     "edem-v2",
     {{"normal_stiffness", 5e9}, {"shear_stiffness", 2e9}, {"torque_feedback", 0}}},
    {"Contact", "contact", {{"kn", 5e8}, {"ks", 2e8}}},
    {"TwoSegment", "two-segment", {{"young", 5e9}, {"poisson", 0.2}, {"radius_factor", 0.8}}},
    {"ConcaveEnd", "concave-end", {{"young", 5e9}, {"poisson", 0.2}, {"radius_factor", 0.7}}, 0.1},
    {"Generic", "generic", {{"kn", 5e8}, {"ks", 2e8}, {"kt", 1e7}, {"kb", 2e7}}},
};

Model loaded_packing(std::mt19937_64& random, const LawCase& chosen) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Model model =
      random_packing(random, 2 + int(random() % 2), block(chosen.law, chosen.values), chosen.smallest_radius);
  const Index last = Index(model.particles.size()) - 1;
  fix_all(model, 0);
  const auto motion = [&] {
    return vector6(unit(random), unit(random), unit(random), unit(random), unit(random), unit(random));
  };
  model.supports.push_back({last, {false, true, false, false, false, true}, 1e-4 * motion(), every_case});
  model.load_cases = {"first", "second", "both"};
  for (Index p = 1; p < last; ++p) {
    const Vector6 first = 1e3 * motion(), second = 1e3 * motion();
    load(model, p, first, 0);
    load(model, p, second, 1);
    load(model, p, first + second, 2);
  }
  return model;
}

double largest(const std::vector<Vector6>& values) {
  double size = 0;
  for (const Vector6& v : values) size = std::max(size, v.lpNorm<Eigen::Infinity>());
  return size;
}

void expect_near(const std::vector<Vector6>& found, const std::vector<Vector6>& expected, double tolerance) {
  const double scale = largest(expected);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t p = 0; p < found.size(); ++p)
    ASSERT_LE((found[p] - expected[p]).lpNorm<Eigen::Infinity>(), tolerance * scale) << "particle " << p;
}

void prescribe_nothing(Model& model) {
  for (Support& support : model.supports) support.value.setZero();
}

class EveryLaw : public ::testing::TestWithParam<LawCase> {
 protected:
  std::mt19937_64 random{1729};

  template <class Check>
  void for_each_packing(Check check) {
    for (int trial = 0; trial < packings && !HasFatalFailure(); ++trial) {
      SCOPED_TRACE("packing " + std::to_string(trial));
      check(loaded_packing(random, GetParam()));
    }
  }
};

TEST_P(EveryLaw, StiffnessIsSymmetricAndKnowsRigidModesAndRank) {
  for_each_packing([&](const Model& model) {
    const auto properties = bond_properties(model);
    BondNetwork network = bond_network(model, properties);
    network.rotation_length = 0.5;
    const Index n = 6 * network.bodies;
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n);
    bool full_rank = true;
    for (const Link& link : network.links) {
      const Matrix12 e = stiffness_matrix(link);
      ASSERT_LE((e - e.transpose()).lpNorm<Eigen::Infinity>(), 1e-15 * e.lpNorm<Eigen::Infinity>());
      full_rank = full_rank && link.stiffness.full_rank();
      const Index at[2] = {6 * link.a, 6 * link.b};
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) k.block<6, 6>(at[i], at[j]) += e.block<6, 6>(6 * i, 6 * j);
    }
    // Rotations in half units of the pitch, as in the assembled matrix.
    for (Index i = 0; i < n; ++i)
      if (i % 6 >= 3) k.row(i) /= 0.5, k.col(i) /= 0.5;

    const FreeDofs all = number_free_dofs(std::vector<std::uint8_t>(model.particles.size(), 0x3f));
    const Incidence incidence = link_incidence(network);
    const BodyGraph graph = body_graph(network, incidence);
    SparseMatrix sparse = stiffness_pattern(graph, all);
    assemble(network, incidence, graph, all, 1, sparse);
    const Eigen::MatrixXd lower(sparse), assembled = lower.selfadjointView<Eigen::Lower>();
    ASSERT_LE((assembled - k).lpNorm<Eigen::Infinity>(), 1e-14 * k.lpNorm<Eigen::Infinity>());

    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(assembled);
    const double stiffest = modes.eigenvalues()[n - 1];
    ASSERT_LE(modes.eigenvalues().head<6>().cwiseAbs().maxCoeff(), 1e-13 * stiffest);
    if (full_rank) {
      ASSERT_GE(modes.eigenvalues()[6], 1e-9 * stiffest);
    }
    for (int mode = 0; mode < 6; ++mode) {
      Eigen::VectorXd rigid(n);
      for (Index p = 0; p < network.bodies; ++p) {
        const Vector6 unit = Vector6::Unit(mode);
        const Vector3 translation = unit.head<3>(), rotation = unit.tail<3>();
        rigid.segment<3>(6 * p) = translation + rotation.cross(model.particles[std::size_t(p)].position);
        rigid.segment<3>(6 * p + 3) = 0.5 * rotation;
      }
      ASSERT_LE((assembled * rigid).lpNorm<Eigen::Infinity>(), 1e-14 * stiffest * rigid.norm());
    }
  });
}

TEST_P(EveryLaw, BalancesLoadsReactionsAndEnergy) {
  for_each_packing([&](const Model& model) {
    for (const auto& result : solve_statics(model, {}).cases) {
      ASSERT_LE(result.accuracy.backward_error, 1e-14);
      ASSERT_LE(result.accuracy.force_balance, 1e-14);
      ASSERT_LE(result.accuracy.moment_balance, 1e-14);
      ASSERT_LE(result.accuracy.energy_balance, 1e-14);
      double energy = 0;
      for (const BondResult& bond : result.bonds) energy += bond.energy;
      ASSERT_NEAR(energy / result.energy, 1, 1e-13);
    }
  });
}

TEST_P(EveryLaw, ObeysBettiAndSuperposition) {
  for_each_packing([&](Model model) {
    prescribe_nothing(model);
    const auto cases = solve_statics(model, {}).cases;
    auto sum = cases[0].displacement;
    for (std::size_t p = 0; p < sum.size(); ++p) sum[p] += cases[1].displacement[p];
    expect_near(cases[2].displacement, sum, 1e-14);
    // Work of the first loads through the second motion, and the other way round.
    double work[2] = {0, 0}, size = 0;
    for (const Load& load : model.loads) {
      if (load.load_case == 2) continue;
      const double part =
          load.force.dot(cases[std::size_t(1 - load.load_case)].displacement[std::size_t(load.particle)]);
      work[load.load_case] += part;
      size += std::abs(part);
    }
    ASSERT_NEAR(work[0], work[1], 1e-14 * size);
  });
}

TEST_P(EveryLaw, IsTurnedWithTheModel) {
  for_each_packing([&](const Model& model) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(unit(random), unit(random), unit(random), unit(random)).normalized();
    const Matrix3 r = turn.toRotationMatrix();
    const auto turned = [&r](const Vector6& v) {
      Vector6 w;
      w << r * v.head<3>(), r * v.tail<3>();
      return w;
    };
    Model other = model;
    // A support of single directions does not turn; hold the last particle as a whole instead.
    Model straight = model;
    for (Model* m : {&straight, &other}) m->supports[1].fixed = {true, true, true, true, true, true};
    for (Particle& particle : other.particles) particle.position = r * particle.position;
    for (Bond& bond : other.bonds) bond.branch = r * bond.branch;
    for (Load& load : other.loads) load.force = turned(load.force);
    for (Support& support : other.supports) support.value = turned(support.value);
    auto expected = solve_statics(straight, {}).cases[0].displacement;
    for (Vector6& u : expected) u = turned(u);
    expect_near(solve_statics(other, {}).cases[0].displacement, expected,
                1e-12);  // of the turned input's rounding
  });
}

TEST_P(EveryLaw, DoesNotCareForNumbersOrEnds) {
  for_each_packing([&](const Model& model) {
    const std::size_t count = model.particles.size();
    std::vector<Index> place(count);
    std::iota(place.begin(), place.end(), Index(0));
    std::shuffle(place.begin(), place.end(), random);
    Model other = model;
    for (std::size_t p = 0; p < count; ++p) other.particles[std::size_t(place[p])] = model.particles[p];
    for (Bond& bond : other.bonds) {
      bond.a = place[std::size_t(bond.a)];
      bond.b = place[std::size_t(bond.b)];
      if (random() % 2 == 0) {
        std::swap(bond.a, bond.b);
        bond.branch = -bond.branch;
      }
    }
    for (Load& load : other.loads) load.particle = place[std::size_t(load.particle)];
    for (Support& support : other.supports) support.particle = place[std::size_t(support.particle)];
    const auto expected = solve_statics(model, {}).cases[0].displacement;
    const auto found = solve_statics(other, {}).cases[0].displacement;
    std::vector<Vector6> back(count);
    for (std::size_t p = 0; p < count; ++p) back[p] = found[std::size_t(place[p])];
    expect_near(back, expected, 1e-14);
  });
}

INSTANTIATE_TEST_SUITE_P(Identities, EveryLaw, ::testing::ValuesIn(law_cases),
                         [](const auto& chosen) { return std::string(chosen.param.name); });

// All stiffnesses times four: every step of the solve scales without rounding, so displacements are a quarter
// to the last bit. The generic law takes stiffnesses as they are.
TEST(Scaling, ByPowersOfFourIsBitwise) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < packings; ++trial) {
    Model model =
        loaded_packing(random, {"", "generic", {{"kn", 5e8}, {"ks", 2e8}, {"kt", 1e7}, {"kb", 2e7}}});
    prescribe_nothing(model);
    Model stiff = model;
    const int power = int(random() % 9) - 4;
    const double factor = std::pow(4.0, power);
    for (double& parameter : stiff.blocks[0].parameters) parameter *= factor;  // NaN where not given stays
    const auto soft_cases = solve_statics(model, {}).cases, stiff_cases = solve_statics(stiff, {}).cases;
    for (std::size_t c = 0; c < soft_cases.size(); ++c)
      for (std::size_t p = 0; p < model.particles.size(); ++p)
        ASSERT_EQ(Vector6(stiff_cases[c].displacement[p] * factor), soft_cases[c].displacement[p]);
  }
}

}  // namespace
}  // namespace bondstatic::test
