// [Chen2022]'s explicit runs: case 1 by the protocol of section 3 for its three models, and where cases 2 to
// 5 begin and end. The state of rest must be the static answer or, with finite kinematics, what the chain's
// own equilibrium says.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "bondstatic/case_file.hpp"
#include "bondstatic/check.hpp"
#include "bondstatic/relaxation.hpp"
#include "bondstatic/statics.hpp"
#include "support/models.hpp"

namespace bondstatic::test {
namespace {

constexpr double length = 4, force = 100e3, young = 200e9, radius = 0.2;
constexpr Index bonds = 10;

bool full_run() {
  const char* full = std::getenv("BONDSTATIC_FULL");
  return full != nullptr && std::string(full) == "1";
}

Model case_1(const std::string& law) {
  Model model = chain(block(law, {{"young", young}, {"poisson", 0.3}, {"radius", radius}}), Vector3::Zero(),
                      Vector3(length, 0, 0), bonds, radius);
  for (Particle& particle : model.particles) particle.density = 7850;
  load(model, bonds, vector6(0, -force, 0));
  return model;
}

/// 100 kN/s for a second, then held; at rest below 1e-9 m/s.
RelaxOptions protocol(Kinematics kinematics, double particle_damping) {
  RelaxOptions options;
  options.kinematics = kinematics;
  options.particle_damping = particle_damping;
  options.ramp_time = 1;
  options.velocity_limit = 1e-9;
  options.force_limit = 1e-8;
  return options;
}

StaticOptions one_thread() {
  StaticOptions options;
  options.threads = 1;
  return options;
}

/// What is left of the slowest mode's swing when its speed stays below the limit for a period. A look may
/// miss the fastest moment by half of a sixteenth of it.
double last_swing(const RelaxedCase& run) {
  const double missed = std::cos(std::numbers::pi / 16);
  return 1e-9 / (run.plan.lowest.front() * missed);
}

class PaperProtocol : public ::testing::TestWithParam<const char*> {
 protected:
  RelaxedCase run(Kinematics kinematics, double particle_damping) {
    RelaxedCase ended =
        relax(case_1(GetParam()), protocol(kinematics, particle_damping), one_thread()).cases.at(0);
    EXPECT_EQ(ended.end, RunEnd::at_rest);
    RecordProperty("steps", std::to_string(ended.steps));
    RecordProperty("seconds", std::to_string(ended.seconds));
    return ended;
  }

  const State statics = solve_statics(case_1(GetParam()), one_thread()).cases.at(0);
};

TEST_P(PaperProtocol, EndsAtTheStaticAnswerWithSmallKinematics) {
  const RelaxedCase ended = run(Kinematics::small, 0.001);
  EXPECT_GT(ended.steps, 5'000'000);  // millions, so hardly is it damped
  const double swing = last_swing(ended);
  ASSERT_LT(swing, 1e-8 * std::abs(statics.displacement.back()[1]));
  for (std::size_t p = 0; p < statics.displacement.size(); ++p) {
    const Vector6 apart = ended.state.displacement[p] - statics.displacement[p];
    EXPECT_LE(apart.head<3>().norm(), swing) << "particle " << p;
    EXPECT_LE(apart.tail<3>().norm(), swing)
        << "particle " << p;  // the mode turns the tip by 1.4/L of its swing
  }
  EXPECT_LE(ended.energies.balance(), 1e-13);
}

// The chain bent in its plane, without any approximation but that of the bond's laws: at a bond's contact
// point, halfway, the moment turns its two particles against each other, the force across the bond shears it,
// and the force along stretches it. Angles are downward.
struct BentChain {
  std::vector<double> x{0}, y{0};  // of the particles

  BentChain(const SectionStiffness& c, double force_down) {
    const double h = length / double(bonds);
    std::vector<double> middle;  // of each bond, along
    for (Index k = 0; k < bonds; ++k) middle.push_back((double(k) + 0.5) * h);
    double tip = length;
    for (int iteration = 0; iteration < 100; ++iteration) {
      x.assign(1, 0), y.assign(1, 0);
      double turned = 0;
      for (std::size_t k = 0; k < middle.size(); ++k) {
        const double by = force_down * (tip - middle[k]) / c.kb, mean = turned + by / 2;
        turned += by;
        double chord = mean;
        for (int i = 0; i < 50; ++i) chord = mean + force_down * std::cos(chord) / (c.ks * h);
        const double along = h + force_down * std::sin(chord) / c.kn;
        x.push_back(x.back() + along * std::cos(chord));
        y.push_back(y.back() + along * std::sin(chord));
      }
      for (std::size_t k = 0; k < middle.size(); ++k) middle[k] = (x[k] + x[k + 1]) / 2;
      tip = x.back();
    }
  }
};

TEST_P(PaperProtocol, EndsAtTheBentChainWithFiniteKinematics) {
  const RelaxedCase ended = run(Kinematics::finite, full_run() ? 0.001 : 0.7);
  const BentChain bent(bond_properties(case_1(GetParam())).front().stiffness, force);
  const double swing = last_swing(ended);
  for (std::size_t p = 0; p < bent.x.size(); ++p) {
    const double x = double(p) * length / double(bonds);
    EXPECT_NEAR(-ended.state.displacement[p][1], bent.y[p], swing) << "particle " << p;
    EXPECT_NEAR(ended.state.displacement[p][0], bent.x[p] - x, swing) << "particle " << p;
  }
}

// The elastica's series for a = F L^2 / EI: along -a^2 L / 15, across L a / 3 (1 - 4 a^2 / 35), from
// EI theta'' = -F cos(theta) with theta = a (s - s^2 / 2) + third order. Stretch by the force along gives F w
// / EA back. Ten bonds and shear change either by less than a hundredth.
TEST_P(PaperProtocol, IsOffTheLinearAnswerAtSecondOrderAlongAndThirdAcross) {
  const RelaxedCase ended = run(Kinematics::finite, 0.7);
  const Vector6 tip = ended.state.displacement.back(), linear = statics.displacement.back();
  const double area = std::numbers::pi * radius * radius;
  const double a = 4 * force * length * length / (young * area * radius * radius);
  const double stretch = force * std::abs(linear[1]) / (young * area);
  EXPECT_NEAR(tip[0] / (stretch - a * a * length / 15), 1, 0.01);
  EXPECT_NEAR((tip[1] / linear[1] - 1) / (-4 * a * a / 35), 1, 0.01);
  RecordProperty("along", fmt::format("{:.6g}", tip[0]));
  RecordProperty("across", fmt::format("{:.6g}", tip[1] / linear[1] - 1));
}

struct EndPoint {
  const char* name;
  const char* file;
  std::vector<std::string> settings;
};

void PrintTo(const EndPoint& point, std::ostream* out) {
  *out << point.name;
}

// As in the headers of the case files.
const std::vector<std::string> beams{"bonds.0.law=timoshenko", "bonds.0.law=euler-bernoulli",
                                     "bonds.0.law=parallel"};
const std::vector<std::string> beams_of_case_5{
    R"(bonds.0={ law = "timoshenko", young = 200e9, poisson = 0.3, radius = 0.2, gap = 1.6 })",
    R"(bonds.0={ law = "euler-bernoulli", young = 200e9, poisson = 0.3, radius = 0.2, gap = 1.6 })",
    R"(bonds.0={ law = "parallel", young = 200e9, kappa = 33.333333333333336, radius = 0.2, gap = 1.6 })"};

const EndPoint end_points[] = {
    {"Case2Shortest", "case2", {"particles.0.line.count=2"}},
    {"Case2Longest", "case2", {"particles.0.line.count=11"}},
    {"Case3OneBond", "case3", {"particles.0.line.count=2", "bonds.0.gap=3.6"}},
    {"Case3TenBonds", "case3", {"particles.0.line.count=11", "bonds.0.gap=0"}},
    {"Case4OneBond", "case4", {"particles.0.line.count=2", "particles.0.radius=2"}},
    {"Case4TenBonds", "case4", {"particles.0.line.count=11", "particles.0.radius=0.2"}},
    {"Case5EqualRadii", "case5", {"particles.1.radius=0.2"}},
    {"Case5LargestMiddle", "case5", {"particles.1.radius=0.8"}},
};

class PaperEndPoint : public ::testing::TestWithParam<EndPoint> {};

// All fields, not only the tip. The paper's 1e-9 m/s leave the slowest mode a swing of at most 1e-8 of its
// tip.
TEST_P(PaperEndPoint, EndsAtTheStaticAnswer) {
  const EndPoint& point = GetParam();
  for (const std::string& law : std::string(point.file) == "case5" ? beams_of_case_5 : beams) {
    SCOPED_TRACE(law);
    std::vector<std::string> settings = point.settings;
    settings.insert(settings.end(), {law, "dynamics.particle_damping=0.7", "dynamics.kinematics=small",
                                     "check.tolerance=1e-6"});
    const Case given = read_case(BONDSTATIC_SOURCE_DIR "/cases/chen2022/" + std::string(point.file) + ".toml",
                                 settings, "", Purpose::dynamics);
    const Certificate certificate = check(given.model, one_thread(), given.relax);
    EXPECT_TRUE(certificate.agrees());
    const CaseCertificate& only = certificate.cases.at(0);
    EXPECT_EQ(only.run.end, RunEnd::at_rest);
    for (const FieldDifference& field : only.fields) EXPECT_LE(field.largest, 1e-6) << field.field;
    EXPECT_LE(only.fields.front().largest, 1e-8) << only.fields.front().field;
  }
}

INSTANTIATE_TEST_SUITE_P(Verification, PaperEndPoint, ::testing::ValuesIn(end_points),
                         [](const auto& point) { return std::string(point.param.name); });

INSTANTIATE_TEST_SUITE_P(Verification, PaperProtocol,
                         ::testing::Values("parallel", "euler-bernoulli", "timoshenko"), [](const auto& law) {
                           std::string name = law.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace bondstatic::test
