// Generated models: the count of free motions against a brute-force SVD, and the campaign of planted defects.
// BONDSTATIC_FULL=1 runs ten times as many.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <set>

#include "mechanism/constraint_rows.hpp"
#include "mechanism/mechanism_models.hpp"

namespace bondstatic {
namespace {

using namespace test;
using Random = std::mt19937_64;
using Kind = Mechanism::Kind;

bool full_run() {
  const char* full = std::getenv("BONDSTATIC_FULL");
  return full != nullptr && std::string(full) == "1";
}

double uniform(Random& random, double low = 0, double high = 1) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
Index pick(Random& random, Index count) {
  return std::uniform_int_distribution<Index>(0, count - 1)(random);
}
Vector3 direction(Random& random) {
  std::normal_distribution<double> normal;
  return Vector3(normal(random), normal(random), normal(random)).normalized();
}

// Random places in a box that holds `density` of them per unit volume; pairs closer than 1.2 are neighbours.
Net random_packing(Random& random, Index count, double density) {
  Net net;
  const double side = std::cbrt(double(count) / density);
  for (int tries = 0; net.count() < count && tries < 10000; ++tries) {
    const Vector3 place(uniform(random, 0, side), uniform(random, 0, side), uniform(random, 0, side));
    bool clear = true;
    for (Index p = 0; p < net.count(); ++p) clear = clear && (net.at(p) - place).norm() > 0.6;
    if (clear) net.particle(place, 0.3);
  }
  return net;
}

template <class Law>
void bond_neighbours(Net& net, double reach, Law law) {
  for (Index a = 0; a < net.count(); ++a)
    for (Index b = a + 1; b < net.count(); ++b)
      if ((net.at(b) - net.at(a)).norm() < reach) law(a, b);
}

std::vector<bool> held_particles(const Net& net) {
  std::vector<bool> held(std::size_t(net.count()));
  for (Index p = 0; p < net.count(); ++p) held[std::size_t(p)] = net.free[std::size_t(p)] != 0x3f;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Link& link : net.network.links)
      if (held[std::size_t(link.a)] != held[std::size_t(link.b)])
        held[std::size_t(link.a)] = held[std::size_t(link.b)] = changed = true;
  }
  return held;
}

class RandomNetwork : public ::testing::TestWithParam<int> {};

// Laws of every kind of deficiency, supports of every kind of dof. Twenty models a test.
TEST_P(RandomNetwork, HasAsManyFreeMotionsAsBruteForceFinds) {
  const int models = full_run() ? 200 : 20;
  Index singular = 0;
  for (int m = 0; m < models; ++m) {
    const std::uint64_t seed = std::uint64_t(GetParam()) * 1000 + std::uint64_t(m);
    Random random(seed);
    Net net = random_packing(random, 1 + pick(random, 30), uniform(random, 0.6, 2.2));
    const double reach = uniform(random, 0.9, 1.7), deficient = uniform(random), friction = uniform(random);
    bond_neighbours(net, reach, [&](Index a, Index b) {
      SectionStiffness law = beam;
      if (uniform(random) < deficient) {
        law = uniform(random) < friction ? contact : frictionless;
        if (uniform(random) < 0.2)
          law = {double(pick(random, 2)), double(pick(random, 2)), double(pick(random, 2)),
                 double(pick(random, 2)), 0};
      }
      net.bond(a, b, law, uniform(random) < 0.5 ? 0.5 : uniform(random));
    });
    for (Index p = 0; p < net.count(); ++p) {
      if (uniform(random) < 0.12) net.hold(p);
      if (uniform(random) < 0.1) net.free[std::size_t(p)] &= std::uint8_t(pick(random, 64));
    }
    const auto held = held_particles(net);
    double gap = 0;
    const Eigen::MatrixXd expected = brute_force_motions(net, held, gap);
    ASSERT_GT(gap, 1e-8) << "seed " << seed << " is not clear-cut, choose another";
    std::set<Index> moving, reported;
    for (Index p = 0; p < net.count(); ++p)
      if (expected.cols() > 0 && expected.middleRows(6 * p, 6).norm() > 1e-7) moving.insert(p);
    Index count = 0;
    for (const Mechanism& mechanism : net.mechanisms()) {
      const bool is_held = held[std::size_t(mechanism.particles.front())];
      EXPECT_EQ(is_held, mechanism.kind == Kind::underconstrained || mechanism.kind == Kind::internal);
      if (!is_held) continue;
      count += Index(mechanism.motions.size());
      reported.insert(mechanism.particles.begin(), mechanism.particles.end());
    }
    EXPECT_EQ(count, expected.cols()) << "seed " << seed << ", smallest strain of the rest " << gap;
    EXPECT_EQ(reported, moving) << "seed " << seed;
    singular += count > 0;
  }
  EXPECT_GT(singular, models / 5);
  EXPECT_LT(singular, models);
}

INSTANTIATE_TEST_SUITE_P(Mechanism, RandomNetwork, ::testing::Range(0, 24));

class LargeContactPacking : public ::testing::TestWithParam<int> {};

// Growth and patches only make the null space smaller to find: taken of the single particles it has as many
// vectors.
TEST_P(LargeContactPacking, IsCountedTheSameWithoutReduction) {
  Random random(std::uint64_t(GetParam()) + 90);
  Net net = random_packing(random, 450, 1.9);
  const double friction = GetParam() % 3 == 0 ? 1 : 0.97;
  bond_neighbours(net, 1.35, [&](Index a, Index b) {
    net.bond(a, b, uniform(random) < friction ? contact : frictionless);
  });
  if (GetParam() % 2) {
    net.hold(7);
  } else {
    for (Index p = 0; p < net.count(); ++p)
      if (net.at(p)[2] < 0.7) net.hold(p);
  }
  const auto held = held_particles(net);
  std::vector<Constraint> constraints;
  for (const Link& link : net.network.links)
    if (held[std::size_t(link.a)])
      append_constraints(constraints, link, link.a, link.b, net.at(link.a), net.at(link.b));
  std::vector<std::vector<Index>> single;
  std::vector<Vector3> places;
  for (Index p = 0; p < net.count(); ++p) {
    append_support(constraints, p, net.at(p),
                   held[std::size_t(p)] ? net.free[std::size_t(p)] : std::uint8_t(0));
    single.push_back({p});
    places.push_back(net.at(p));
  }
  const auto rows = constraint_rows(make_bodies(net.model, single, constraints), constraints);
  std::vector<Mechanism> found = net.mechanisms();
  std::erase_if(found, [&](const Mechanism& m) { return !held[std::size_t(m.particles.front())]; });
  EXPECT_EQ(motions_in_all(found), Index(null_space(places, rows).size()));
}

INSTANTIATE_TEST_SUITE_P(Mechanism, LargeContactPacking, ::testing::Range(0, 6));

// A sound model: a lattice or a disordered packing of beams, among them some contact bonds where the rest
// holds anyway, stiffnesses over eight decades, any unit of length, turned and away from the origin.
struct Sound {
  Net net;
  double spacing = 1;
  Matrix3 turn;
  Vector3 origin;

  Vector3 place(const Vector3& local) const { return origin + spacing * (turn * local); }
};

SectionStiffness scattered(Random& random, SectionStiffness law) {
  for (double* k : {&law.kn, &law.ks, &law.kt, &law.kb}) *k *= std::pow(10, uniform(random, -4, 4));
  return law;
}

Sound sound_model(Random& random) {
  Sound sound;
  sound.spacing = std::pow(10, uniform(random, -6, 3));
  sound.turn = Eigen::AngleAxisd(uniform(random, 0, 3), direction(random)).toRotationMatrix();
  sound.origin = sound.spacing * uniform(random, 0, 20) * direction(random);
  Net& net = sound.net;
  const Index side = 2 + pick(random, 4);
  const double jitter = pick(random, 2) ? 0.15 : 0;
  for (Index k = 0; k < side; ++k)
    for (Index j = 0; j < side; ++j)
      for (Index i = 0; i < side; ++i)
        net.particle(sound.place(Vector3(double(i), double(j), double(k)) + jitter * direction(random)),
                     0.5 * sound.spacing);
  // Beams join each particle to an earlier one; of the bonds beyond this tree some have no moments.
  const Index rows[3] = {1, side, side * side};
  for (Index p = 1; p < net.count(); ++p) {
    bool joined = false;
    for (int axis = 0; axis < 3; ++axis) {
      if (p / rows[axis] % side == 0) continue;
      const bool hinge = joined && pick(random, 3) == 0;
      net.bond(p - rows[axis], p, scattered(random, hinge ? contact : beam));
      joined = true;
    }
  }
  return sound;
}

void hold_well(Random& random, Net& net) {
  if (pick(random, 2)) return net.hold(pick(random, net.count()));
  // Three corners of the lattice's bottom, far from a line.
  const Index side = Index(std::lround(std::cbrt(double(net.count()))));
  for (const Index p : {Index(0), side - 1, side * (side - 1)}) net.hold(p, "xyz");
}

enum Defect {
  lone,
  pair,
  on_one_contact,
  on_two_contacts,
  body_on_line,
  missing_support,
  frictionless_cup,
  defects
};

// Plants the defect and returns one particle of it.
Index plant(Random& random, Sound& sound, Defect defect) {
  Net& net = sound.net;
  const Index count = net.count(), root = pick(random, count);
  const double s = sound.spacing;
  if (defect != missing_support) hold_well(random, net);
  const Vector3 outside = net.at(root) + 1.1 * s * direction(random);
  switch (defect) {
    case lone:
      return net.particle(outside, 0.4 * s);
    case pair: {
      const Index a = net.particle(outside, 0.4 * s),
                  b = net.particle(outside + s * direction(random), 0.4 * s);
      net.bond(a, b, scattered(random, beam));
      return b;
    }
    case on_one_contact: {
      const Index p = net.particle(outside, 0.4 * s);
      net.bond(p, root, scattered(random, contact), uniform(random));
      return p;
    }
    case on_two_contacts: {
      const Index other = (root + 1) % count, p = net.particle((net.at(root) + net.at(other)) / 2, 0.1 * s);
      net.bond(root, p, scattered(random, contact));
      net.bond(p, other, scattered(random, contact));
      return p;
    }
    case body_on_line: {
      // Three particles stand over three of a lattice row, each on one contact bond.
      Net& n = net;
      const Vector3 x = direction(random), up = x.unitOrthogonal();
      Index below = root, last = -1;
      for (int i = 0; i < 3; ++i) {
        if (i > 0) {
          const Index next = n.particle(net.at(below) + s * x, 0.5 * s);
          n.bond(below, next, scattered(random, beam));
          below = next;
        }
        const Index over = n.particle(net.at(below) + s * up, 0.5 * s);
        n.bond(below, over, scattered(random, contact));
        if (last >= 0) n.bond(last, over, scattered(random, beam));
        last = over;
      }
      return last;
    }
    case missing_support: {
      const char* const lacking[] = {"yzuvw", "xzuvw", "xyuvw", "xyzvw", "xyzuw", "xyzuv", "xyz", "uvw", "z"};
      net.hold(root, lacking[pick(random, 9)]);
      return root;
    }
    case frictionless_cup: {
      const Index p = net.particle(outside, 0.4 * s);
      for (int i = 0; i < 5; ++i) net.bond(pick(random, count), p, scattered(random, frictionless));
      return p;
    }
    case defects:
      break;
  }
  return -1;
}

class MechanismCampaign : public ::testing::TestWithParam<int> {
 protected:
  int models_ = full_run() ? 100 : 10;
  std::uint64_t seed(int m) const { return 7000000 + std::uint64_t(GetParam()) * 1000 + std::uint64_t(m); }
};

TEST_P(MechanismCampaign, FindsThePlantedParticle) {
  for (int m = 0; m < models_; ++m) {
    Random random(seed(m));
    Sound sound = sound_model(random);
    const auto defect = Defect(m % defects);
    const Index planted = plant(random, sound, defect);
    const auto found = sound.net.mechanisms();
    bool named = false;
    for (const Mechanism& mechanism : found) {
      named = named || std::count(mechanism.particles.begin(), mechanism.particles.end(), planted) > 0;
      EXPECT_FALSE(mechanism.motions.empty());
      EXPECT_FALSE(describe(sound.net.model, mechanism).empty());
    }
    EXPECT_TRUE(named) << "seed " << seed(m) << " defect " << defect;
    EXPECT_EQ(found.size(), 1u) << "seed " << seed(m) << " defect " << defect;
  }
}

TEST_P(MechanismCampaign, RaisesNoFalseAlarm) {
  for (int m = 0; m < models_; ++m) {
    Random random(seed(m) + 500);
    Sound sound = sound_model(random);
    hold_well(random, sound.net);
    // The same additions as the defects, one bond or more to the good.
    const Index count = sound.net.count(), root = pick(random, count - 1);
    const Index p = sound.net.particle(sound.net.at(root) + 1.1 * sound.spacing * direction(random));
    if (m % 2)
      sound.net.bond(root, p, scattered(random, beam));
    else
      for (const Index foot : {Index(0), Index(1), count - 1})
        sound.net.bond(foot, p, scattered(random, contact));
    const auto found = sound.net.mechanisms();
    EXPECT_THAT(found, ::testing::IsEmpty()) << "seed " << seed(m);
  }
}

INSTANTIATE_TEST_SUITE_P(Mechanism, MechanismCampaign, ::testing::Range(0, 10));

}  // namespace
}  // namespace bondstatic
