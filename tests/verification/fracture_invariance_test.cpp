// What a fracture history must not depend on: threads, solver, the order of particles and bonds, which end of
// a bond is called a, the unit system, the orientation. And ties: symmetric models break symmetrically.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "bondstatic/fracture.hpp"
#include "support/strengths.hpp"

namespace bondstatic::test {
namespace {

constexpr Index pull = 0, weight = 1;
constexpr std::array<bool, 6> fixed{true, true, true, true, true, true};

StaticOptions on(int threads, const std::string& solver = "auto") {
  StaticOptions options;
  options.solver = solver;
  options.threads = threads;
  options.yield_cores = false;
  return options;
}

/// A cube on a held floor, its roof pulled up and sheared; strengths scatter, and particles are so heavy that
/// some bonds break by weight alone and chips fall off.
Model torn_cube(int edge) {
  std::mt19937_64 random(23);
  Model model =
      random_packing(random, edge, block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.2}}));
  model.load_cases = {"pull", "weight"};
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    const double z = model.particles[p].position.z();
    if (z < 0.5) fix_all(model, Index(p));
    load(model, Index(p), vector6(0, 0, -1e4), weight);
    if (z < double(edge) - 1.5) continue;
    model.supports.push_back({Index(p), fixed, vector6(0.3, 0, 1), pull});
    model.supports.push_back({Index(p), fixed, Vector6::Zero(), weight});
  }
  model.blocks[0].strength =
      strength("edem-v2", {{"critical_normal_stress", 1e6}, {"critical_shear_stress", 2e6}});
  model.blocks[0].strength->scatter = BondStrength::Scatter::weibull;
  model.blocks[0].strength->spread = {1, 1};
  return model;
}

/// Down to the separated specimen.
Fracture torn(const Model& model, const StaticOptions& solve = on(1)) {
  FractureOptions options;
  options.preload = weight;
  Fracture found = fracture(model, options, solve);
  EXPECT_EQ(found.end, FractureEnd::separated) << found.reason;
  EXPECT_GT(found.events.size(), 50u);
  EXPECT_FALSE(found.separated.empty());
  return found;
}

struct Units {
  double length = 1;
  double force = 1;
};

/// Same bonds, modes, avalanches and separated bodies, by their ids; numbers, those of `expected` in other
/// units, within `tolerance` of themselves (zero: bit for bit).
void expect_same_history(const Model& model, const Fracture& found, const Model& model_expected,
                         const Fracture& expected, double tolerance, Units units = {}) {
  const auto ids = [](const Model& of, const std::vector<BrokenBond>& bonds) {
    std::map<Index, int> modes;
    for (const BrokenBond& broken : bonds) modes[of.bonds[std::size_t(broken.bond)].id] = broken.mode;
    return modes;
  };
  ASSERT_EQ(found.events.size(), expected.events.size());
  // P is made of the preload's reaction, too, and energies are differences.
  double largest_load = 0, largest_factor = 0, largest_energy = 0;
  for (const FractureEvent& event : expected.events) {
    largest_load = std::max(largest_load, units.force * std::abs(event.load));
    largest_factor = std::max(largest_factor, event.factor);
    largest_energy = std::max(largest_energy, event.strain_energy);
  }
  for (std::size_t e = 0; e < expected.events.size(); ++e) {
    const FractureEvent &l = found.events[e], &r = expected.events[e];
    ASSERT_EQ(ids(model, l.bonds), ids(model_expected, r.bonds)) << e;
    ASSERT_EQ(l.avalanche, r.avalanche) << e;
    const double load = units.force * r.load, displacement = units.length * r.displacement;
    const double joule = units.force * units.length, energy = joule * largest_energy;
    const auto expect_near = [&](double number, double wanted, double size) {
      if (std::isnan(number) && std::isnan(wanted)) return;
      ASSERT_LE(std::abs(number - wanted), tolerance * std::abs(size)) << "event " << e << ": " << wanted;
    };
    expect_near(l.factor, r.factor, largest_factor);
    expect_near(l.load, load, largest_load);
    expect_near(l.displacement, displacement, displacement);
    expect_near(l.factor_after, r.factor_after, largest_factor);
    expect_near(l.load_after, units.force * r.load_after, largest_load);
    expect_near(l.displacement_after, units.length * r.displacement_after, displacement);
    expect_near(l.runner_up, r.runner_up, 1);
    expect_near(l.released, joule * r.released, energy);
    expect_near(l.strain_energy, joule * r.strain_energy, energy);
    expect_near(l.work, joule * r.work, energy);
    expect_near(l.dissipated, joule * r.dissipated, energy);
  }
  ASSERT_EQ(found.separated.size(), expected.separated.size());
  const auto bodies = [](const Fracture& of) {
    std::set<std::pair<std::size_t, std::set<Index>>> all;
    for (const SeparatedBody& body : of.separated)
      all.insert({body.event, {body.particles.begin(), body.particles.end()}});
    return all;
  };
  EXPECT_EQ(bodies(found), bodies(expected));
  EXPECT_EQ(found.end, expected.end);
}

TEST(FractureHistory, IsTheSameToTheBitOnAnyNumberOfThreads) {
  const Model model = torn_cube(5);
  const Fracture one = torn(model);
  for (const int threads : {2, 3, 4}) {
    SCOPED_TRACE(threads);
    expect_same_history(model, torn(model, on(threads)), model, one, 0);
  }
}

TEST(FractureHistory, IsTheSameWithAnotherSolver) {
  const Model model = torn_cube(5);
  expect_same_history(model, torn(model, on(1, "eigen")), model, torn(model, on(1, "cholmod")), 1e-12);
}

/// Particles, bonds and supports in another order, a and b of some bonds swapped; ids kept.
Model renumbered(const Model& model, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<std::size_t> order(model.particles.size()), place(order.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  Model other = model;
  for (std::size_t i = 0; i < order.size(); ++i) {
    other.particles[i] = model.particles[order[i]];
    place[order[i]] = i;
  }
  for (Bond& bond : other.bonds) {
    bond.a = Index(place[std::size_t(bond.a)]);
    bond.b = Index(place[std::size_t(bond.b)]);
    if (random() % 2) continue;
    std::swap(bond.a, bond.b);
    bond.branch = -bond.branch;
  }
  for (Support& support : other.supports) support.particle = Index(place[std::size_t(support.particle)]);
  for (Load& load : other.loads) load.particle = Index(place[std::size_t(load.particle)]);
  std::shuffle(other.bonds.begin(), other.bonds.end(), random);
  std::shuffle(other.supports.begin(), other.supports.end(), random);
  std::shuffle(other.loads.begin(), other.loads.end(), random);
  return other;
}

TEST(FractureHistory, DoesNotDependOnNumbersAndEnds) {
  const Model model = torn_cube(5);
  const Fracture one = torn(model);
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Model other = renumbered(model, seed);
    expect_same_history(other, torn(other), model, one, 1e-13);
  }
}

TEST(FractureHistory, ScalesWithTheUnitsToTheBit) {
  const Model model = torn_cube(5);
  const Units units{0x1p-7, 0x1p11};
  const double stress = units.force / (units.length * units.length);
  Model other = model;
  for (Particle& particle : other.particles) {
    particle.position *= units.length;
    particle.radius *= units.length;
  }
  for (Bond& bond : other.bonds) bond.branch *= units.length;
  for (Support& support : other.supports) support.value.head<3>() *= units.length;
  for (Load& load : other.loads) load.force *= units.force;
  const BondLaw& law = *find_bond_law("timoshenko");
  other.blocks[0].parameters[std::size_t(law.find("young"))] *= stress;
  other.blocks[0].parameters[std::size_t(law.find("radius"))] *= units.length;
  for (double& critical : other.blocks[0].strength->parameters) critical *= stress;
  expect_same_history(other, torn(other), model, torn(model), 0, units);
}

TEST(FractureHistory, TurnsWithTheModel) {
  const Model model = torn_cube(5);
  Matrix3 third;
  third << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // of a turn, about (1, 1, 1)
  Matrix3 quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  for (const Matrix3& rotation :
       {quarter, third, Eigen::AngleAxisd(0.7, Vector3(1, -2, 3).normalized()).toRotationMatrix()}) {
    Model other = model;
    for (Particle& particle : other.particles) particle.position = rotation * particle.position;
    for (Bond& bond : other.bonds) bond.branch = rotation * bond.branch;
    for (Support& support : other.supports) support.value.head<3>() = rotation * support.value.head<3>();
    for (Load& load : other.loads) load.force.head<3>() = rotation * load.force.head<3>();
    expect_same_history(other, torn(other), model, torn(model), 1e-13);
  }
}

/// A cube of 5^3 nodes, bonded along edges and face diagonals, without its middle node; floor held, roof
/// pulled straight up, all strengths equal. It is its own image under each of the 8 symmetries of a square
/// prism about its axis, and by rigid motion under up and down.
Model symmetric_block() {
  Model model;
  model.blocks.push_back(block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius", 0.2}}));
  for (int n = 0; n < 125; ++n)
    if (n != 62) add_particle(model, Vector3(n % 5 - 2, n / 5 % 5 - 2, n / 25 - 2), 0.5);
  bond_within(model, 1.5);
  const Index count = Index(model.particles.size());
  for (Index p = 0; p < count; ++p) {
    const double z = model.particles[std::size_t(p)].position.z();
    if (z < -1.5) fix_all(model, p);
    if (z > 1.5) fix_all(model, p, vector6(0, 0, 1));
  }
  model.blocks[0].strength =
      strength("edem-v2", {{"critical_normal_stress", 1e6}, {"critical_shear_stress", 2e6}});
  return model;
}

/// Middles of the bonds of one event, doubled: whole numbers.
using Middles = std::set<std::array<int, 3>>;

std::vector<Middles> middles(const Model& model, const Fracture& found) {
  std::vector<Middles> of_events;
  for (const FractureEvent& event : found.events) {
    Middles& middles = of_events.emplace_back();
    for (const BrokenBond& broken : event.bonds) {
      const Bond& bond = model.bonds[std::size_t(broken.bond)];
      const Vector3 sum =
          model.particles[std::size_t(bond.a)].position + model.particles[std::size_t(bond.b)].position;
      middles.insert({int(std::lround(sum[0])), int(std::lround(sum[1])), int(std::lround(sum[2]))});
    }
  }
  return of_events;
}

TEST(FractureTies, ASymmetricModelBreaksSymmetricallyWhateverItsNumbers) {
  const Model model = symmetric_block();
  const std::vector<Middles> one = middles(model, fracture(model, {}, on(1)));
  ASSERT_GT(one.size(), 3u);
  for (const Middles& event : one)
    for (const auto& [x, y, z] : event)
      for (const std::array<int, 3>& image : {std::array{-x, y, z}, {x, -y, z}, {y, x, z}, {x, y, -z}})
        EXPECT_TRUE(event.contains(image)) << x << " " << y << " " << z;
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const Model other = renumbered(model, seed);
    EXPECT_EQ(middles(other, fracture(other, {}, on(1))), one) << seed;
  }
}

}  // namespace
}  // namespace bondstatic::test
