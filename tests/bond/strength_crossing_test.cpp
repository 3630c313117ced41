// Utilisations along a line of resultants, and where they reach 1.
#include "bond/strength/resultants.hpp"
#include "bond/strength_fixture.hpp"

namespace bondstatic {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double eps = std::numeric_limits<double>::epsilon();

/// A bond with a criterion, held and scaled resultants.
struct Loaded {
  BondSection bond;
  std::vector<FailureMode> modes;
  SectionVector held, scaled;

  double at(double factor) const { return utilisation_of(modes, bond, along(held, scaled, factor)); }
  Crossing crossing(double from = 0) const {
    return first_crossing(modes, bond.length, bond.fraction, held, scaled, from);
  }
};

Loaded random_load(RandomResultants& random, const std::string& name, double held) {
  Loaded out;
  out.bond = random.section();
  out.modes = failure_modes(name, typical_strengths().at(name), out.bond);
  out.held = random.resultants(held);
  out.scaled = random.resultants();
  return out;
}

using Long = long double;

/// A mode's sum at a factor, the sum of its terms' magnitudes, in long double, by components.
std::pair<Long, Long> long_sum(const Loaded& load, const FailureMode& mode, Long factor) {
  const Long arm = (Long(load.bond.fraction) - mode.at) * load.bond.length;
  const auto both = [&](Long held, Long scaled) { return held + factor * scaled; };
  const SectionVector &h = load.held, &s = load.scaled;
  const Long sy = both(h.shear.x(), s.shear.x()), sz = both(h.shear.y(), s.shear.y());
  const Long my = both(h.bending.x(), s.bending.x()) - arm * sz,
             mz = both(h.bending.y(), s.bending.y()) + arm * sy;
  const Long terms[] = {mode.normal * both(h.normal, s.normal), mode.shear * std::sqrt(sy * sy + sz * sz),
                        mode.twisting * std::abs(both(h.twisting, s.twisting)),
                        mode.bending * std::sqrt(my * my + mz * mz)};
  Long sum = 0;
  for (const Long term : terms) sum += term;
  const Long size = std::abs(mode.normal) * (std::abs(Long(h.normal)) + factor * std::abs(Long(s.normal))) +
                    mode.shear * (h.shear.norm() + factor * s.shear.norm()) +
                    mode.twisting * (std::abs(h.twisting) + factor * std::abs(s.twisting)) +
                    mode.bending * (h.bending.norm() + factor * s.bending.norm() +
                                    std::abs(arm) * (h.shear.norm() + factor * s.shear.norm()));
  return {sum, size};
}

/// By bisection; infinite where the sum is below 1 at 1e6 still.
Long bisected(const Loaded& load, const FailureMode& mode) {
  Long low = 0, high = 1e6;
  if (long_sum(load, mode, high).first < 1) return inf;
  for (int k = 0; k < 110; ++k) {
    const Long middle = (low + high) / 2;
    (long_sum(load, mode, middle).first < 1 ? low : high) = middle;
  }
  return high;
}

TEST(FirstCrossing, IsTheBisectionsToRounding) {
  RandomResultants random;
  int found = 0, never = 0;
  double worst = 0;
  for (const StrengthCriterion& criterion : strength_criteria())
    for (int k = 0; k < 1500; ++k) {
      Loaded load = random_load(random, criterion.name, 0.7);
      if (k % 10 == 0) load.scaled = {-1, 0, {0, 0}, {0, 0}};  // pressed together: most never break
      if (load.at(0) >= 1) continue;
      Long expected = inf;
      const FailureMode* first = nullptr;
      for (const FailureMode& mode : load.modes)
        if (const Long factor = bisected(load, mode); factor < expected) expected = factor, first = &mode;
      const Crossing crossing = load.crossing();
      if (!first) {
        EXPECT_GT(crossing.factor, 0.99e6) << criterion.name;
        ++never;
        continue;
      }
      ASSERT_EQ(crossing.mode, first->name) << criterion.name;
      // What rounding of the terms makes of the root: their size over the slope.
      const Long step = 1e-6L * expected;
      const Long slope =
          (long_sum(load, *first, expected + step).first - long_sum(load, *first, expected - step).first) /
          (2 * step);
      const Long rounding = eps * (1 + long_sum(load, *first, expected).second) / slope;
      const double error = double(std::abs(crossing.factor - expected));
      ASSERT_LT(error, 4 * rounding) << criterion.name << " " << double(expected);
      if (rounding < 10 * eps * expected) {
        ++found;
        worst = std::max(worst, error / double(expected));
      }
    }
  EXPECT_GT(found, 2500);
  EXPECT_GT(never, 300);
  EXPECT_LT(worst, 1e-14);
}

TEST(FirstCrossing, WithNothingHeldIsTheReciprocalOfTheUtilisation) {
  RandomResultants random;
  for (const StrengthCriterion& criterion : strength_criteria())
    for (int k = 0; k < 2000; ++k) {
      const Loaded load = random_load(random, criterion.name, 0);
      const Utilisation u = utilisation(load.modes, load.bond.length, load.bond.fraction, load.scaled);
      const Crossing crossing = load.crossing();
      EXPECT_EQ(crossing.mode, u.mode);
      if (u.value == 0)
        EXPECT_EQ(crossing.factor, inf);
      else
        EXPECT_NEAR(crossing.factor * u.value, 1, 2 * eps) << criterion.name;
    }
}

TEST(FirstCrossing, LeavesNothingBefore) {
  RandomResultants random;
  for (const StrengthCriterion& criterion : strength_criteria())
    for (int k = 0; k < 500; ++k) {
      const Loaded load = random_load(random, criterion.name, 0.7);
      const double from = random.uniform(-1, 2);
      const Crossing crossing = load.crossing(from);
      EXPECT_GE(crossing.factor, from);
      if (load.at(from) >= 1) {
        EXPECT_EQ(crossing.factor, from);
        continue;
      }
      const double last = std::min(crossing.factor, 1e3);
      for (int part = 1; part < 20; ++part) EXPECT_LT(load.at(from + (last - from) * part / 20), 1);
      if (crossing.factor < 1e3) {
        EXPECT_NEAR(load.at(crossing.factor), 1, 1e-13);
      }
    }
}

TEST(FirstCrossing, OfWhatIsBrokenAtTheStartIsTheStart) {
  const Loaded load{
      {0.5, 1, 0.5},
      failure_modes("contact-bond", {{"critical_tensile_force", 1}, {"critical_shear_force", 4}}, {}),
      {3, 0, {0, 0}, {0, 0}},
      {-1, 0, {0, 1}, {0, 0}}};
  EXPECT_EQ(load.crossing(0).factor, 0);
  EXPECT_EQ(load.crossing(0).mode, 0);
  EXPECT_EQ(load.crossing(1.5).factor, 1.5);
  EXPECT_EQ(load.crossing(2).factor, 2);  // exactly 1
  EXPECT_EQ(load.crossing(2.5).factor, 4);
  EXPECT_EQ(load.crossing(2.5).mode, 1);
}

TEST(FirstCrossing, OfNothingIsNever) {
  const SectionVector none;
  for (const auto& [name, inputs] : typical_strengths()) {
    const Loaded load{{0.5, 1, 0.5}, failure_modes(name, inputs, {0.5, 1, 0.5}), none, none};
    EXPECT_EQ(load.crossing().factor, inf) << name;
    EXPECT_EQ(load.crossing().mode, -1) << name;
    EXPECT_EQ(load.at(0), 0) << name;
    Loaded constant = load;
    constant.held.shear.x() = 1e-3;
    EXPECT_EQ(constant.crossing().factor, inf) << name;
  }
  EXPECT_EQ(first_crossing({}, 1, 0.5, none, none, 0).factor, inf);
  EXPECT_EQ(utilisation({}, 1, 0.5, none).mode, -1);
}

TEST(FirstCrossing, MayBeNegative) {
  // 5 + 3 x + |x| is 1 at -2, and more at -1.
  const std::vector<FailureMode> modes{{.name = 0, .normal = 1, .shear = 1}};
  const SectionVector held{5, 0, {0, 0}, {0, 0}}, scaled{3, 0, {1, 0}, {0, 0}};
  EXPECT_EQ(first_crossing(modes, 1, 0.5, held, scaled, -9).factor, -2);
  EXPECT_EQ(first_crossing(modes, 1, 0.5, held, scaled, -1).factor, -1);
}

TEST(FirstCrossing, PassesThroughKinks) {
  // |T| falls to zero at factor 1 and grows from there; N is against it.
  const std::vector<FailureMode> modes{{.name = 0, .normal = 1, .twisting = 2}};
  const SectionVector held{0.25, 0.25, {0, 0}, {0, 0}}, scaled{-0.25, -0.25, {0, 0}, {0, 0}};
  // 0.25 (1 - x) + 0.5 |1 - x| = 1: x = 5 (x = -1/3 on the other side)
  EXPECT_NEAR(first_crossing(modes, 1, 0.5, held, scaled, 0).factor, 5, 5 * eps);
  // Parallel to the line at infinity: rises, and never gets there.
  const std::vector<FailureMode> balanced{{.name = 0, .normal = 1, .bending = 1}};
  const SectionVector across{-1, 0, {0, 0}, {0, 1}}, down{-1, 0, {0, 0}, {1, 0}};
  EXPECT_EQ(first_crossing(balanced, 1, 0.5, across, down, 0).factor, inf);
}

TEST(FirstCrossing, IsTheSameInAnyUnits) {
  RandomResultants random;
  for (int k = 0; k < 200; ++k) {
    const Loaded load = random_load(random, "bpm-rotational", 0.5);
    Loaded large = load;
    const double unit = std::ldexp(1, 60);
    for (SectionVector* q : {&large.held, &large.scaled}) *q = along({}, *q, unit);
    for (FailureMode& mode : large.modes)
      mode.normal /= unit, mode.shear /= unit, mode.twisting /= unit, mode.bending /= unit;
    EXPECT_EQ(large.crossing().factor, load.crossing().factor);
  }
}

TEST(Utilisation, IsConvexAndScalesWithTheLoad) {
  RandomResultants random;
  for (const StrengthCriterion& criterion : strength_criteria())
    for (int k = 0; k < 1000; ++k) {
      const Loaded load = random_load(random, criterion.name, 1);
      const double x = random.uniform(-3, 3), y = random.uniform(-3, 3), t = random.uniform(0, 1);
      EXPECT_LE(load.at(t * x + (1 - t) * y), t * load.at(x) + (1 - t) * load.at(y) + 1e-13);
      const double factor = random.uniform(0, 10);
      EXPECT_NEAR(utilisation_of(load.modes, load.bond, along({}, load.scaled, factor)),
                  factor * utilisation_of(load.modes, load.bond, load.scaled), 1e-13);
    }
}

TEST(SectionVector, KeepsWhatTheBondCarries) {
  RandomResultants random;
  for (int k = 0; k < 200; ++k) {
    const Vector3 branch = random.uniform(0.1, 10) * random.direction();
    Vector6 q;
    for (int i = 0; i < 6; ++i) q[i] = random.uniform(-1, 1);
    const SectionVector v = section_vector(branch, q);
    const Vector3 x = branch.normalized(), force = q.head<3>(), moment = q.tail<3>();
    EXPECT_NEAR(v.normal, x.dot(force), 1e-15);
    EXPECT_NEAR(v.twisting, x.dot(moment), 1e-15);
    EXPECT_NEAR(v.shear.norm(), x.cross(force).norm(), 1e-15);
    EXPECT_NEAR(v.bending.norm(), x.cross(moment).norm(), 1e-15);
    // The same axes for both: e_x . (S x M) and S . M.
    EXPECT_NEAR(v.shear.x() * v.bending.y() - v.shear.y() * v.bending.x(), x.dot(force.cross(moment)), 1e-15);
  }
}

TEST(SectionVector, GivesTheMomentsAtTheCentresThatTheParticlesFeel) {
  RandomResultants random;
  for (int k = 0; k < 200; ++k) {
    Link link;
    link.branch = random.uniform(0.1, 10) * random.direction();
    link.fraction = random.uniform(-0.2, 1.2);
    Vector6 q;
    for (int i = 0; i < 6; ++i) q[i] = random.uniform(-1, 1);
    const SectionVector v = section_vector(link.branch, q);
    const Vector3 x = bond_axis<double>(link);
    const Vector3 at_a = force_on_a<double>(link, q).tail<3>(), at_b = force_on_b<double>(link, q).tail<3>();
    const double length = link.branch.norm();
    EXPECT_NEAR(bending_at(0, length, link.fraction, v).norm(), x.cross(at_a).norm(), 1e-13);
    EXPECT_NEAR(bending_at(1, length, link.fraction, v).norm(), x.cross(at_b).norm(), 1e-13);
    EXPECT_EQ(bending_at(link.fraction, length, link.fraction, v), v.bending);
  }
}

}  // namespace
}  // namespace bondstatic
