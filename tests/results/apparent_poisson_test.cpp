#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "bondstatic/error.hpp"
#include "bondstatic/output.hpp"
#include "model/middle_third.hpp"
#include "support/models.hpp"

namespace bondstatic::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Output poisson(const Vector3& axis, std::vector<Index> base, std::vector<Index> at,
               std::vector<Index> middle = {}) {
  Output output;
  output.name = "nu";
  output.of = "apparent_poisson";
  output.axis = axis;
  output.base = std::move(base);
  output.at = std::move(at);
  output.middle = std::move(middle);
  return output;
}

/// Particles 0 and 1 are the platens, on a line along the axis; the others lie about anywhere between.
struct Cloud {
  Model model;
  State state;
};
Cloud affine_cloud(const Vector3& axis, int between, const Matrix3& gradient) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  Cloud cloud;
  add_particle(cloud.model, -1.5 * axis, 0.1);
  add_particle(cloud.model, 1.7 * axis, 0.1);
  for (int i = 0; i < between; ++i)
    add_particle(cloud.model, Vector3(number(random), number(random), number(random)), 0.1);
  for (const Particle& particle : cloud.model.particles) {
    Vector6 u = Vector6::Zero();
    u.head<3>() = Vector3(0.3, -2, 5) + gradient * particle.position;
    cloud.state.displacement.push_back(u);
    cloud.state.reaction.push_back(Vector6::Zero());
  }
  return cloud;
}

Matrix3 some_gradient() {
  Matrix3 gradient;
  gradient << 0.03, 0.2, -0.1, 0.4, 0.05, 0.3, -0.2, 0.1, -0.2;
  return gradient;
}

// Both strains are those of the gradient, whatever shear and rotation there is, wherever the centres lie; the
// displacement common to all is 100 times as large as what the strains add.
TEST(ApparentPoisson, OfAnAffineMotionIsThatOfItsStrains) {
  for (const Vector3& axis : {Vector3(0, 0, 1), Vector3(0, -1, 0), Vector3(0.6, 0, 0.8)})
    for (const int between : {4, 40}) {
      const Matrix3 g = some_gradient();
      const Cloud cloud = affine_cloud(axis, between, g);
      const double axial = axis.dot(g * axis), lateral = (g.trace() - axial) / 2;
      std::vector<Index> middle;
      for (Index p = 2; p < Index(cloud.model.particles.size()); ++p) middle.push_back(p);
      EXPECT_NEAR(evaluate_output(cloud.model, cloud.state, poisson(3 * axis, {0}, {1}, middle)),
                  -lateral / axial, 2e-13);
      EXPECT_NEAR(evaluate_output(cloud.model, cloud.state, poisson(-axis, {1}, {0}, middle)),
                  -lateral / axial, 2e-13);
    }
}

TEST(ApparentPoisson, MeasuresInTheMiddleThirdUnlessTold) {
  const Vector3 axis(0.6, 0, 0.8);
  Cloud cloud = affine_cloud(axis, 60, some_gradient());
  const std::vector<Index> middle = middle_third(cloud.model, {0}, {1}, axis);
  ASSERT_GT(middle.size(), 5u);
  for (Index p = 0; p < Index(cloud.model.particles.size()); ++p) {
    const double height = axis.dot(cloud.model.particles[std::size_t(p)].position);
    const bool inside = height >= -1.5 + 3.2 / 3 && height <= 1.7 - 3.2 / 3;
    EXPECT_EQ(std::count(middle.begin(), middle.end(), p), inside);
    if (!inside && p > 1) cloud.state.displacement[std::size_t(p)] *= 17;  // does not count
  }
  EXPECT_EQ(evaluate_output(cloud.model, cloud.state, poisson(axis, {0}, {1})),
            evaluate_output(cloud.model, cloud.state, poisson(axis, {0}, {1}, middle)));
}

TEST(MiddleThird, HasWhatLiesOnItsBoundary) {
  Model model;
  for (int i = 0; i <= 6; ++i) add_particle(model, Vector3(5, 0, 0.1 * i), 0.05);
  EXPECT_THAT(middle_third(model, {0}, {6}, Vector3(0, 0, 2)), ElementsAre(2, 3, 4));
  EXPECT_THAT(middle_third(model, {6}, {0}, Vector3(0, 0, 2)), ElementsAre(2, 3, 4));
}

TEST(ApparentPoisson, LeftOutParticlesDoNotCount) {
  Cloud cloud = affine_cloud(Vector3::UnitZ(), 6, some_gradient());
  Cloud less = affine_cloud(Vector3::UnitZ(), 6, some_gradient());
  for (const std::size_t p : {3u, 4u, 5u})
    cloud.state.displacement[p].x() *= 1.1, less.state.displacement[p].x() *= 1.1;
  cloud.state.displacement[6].setConstant(not_given);
  EXPECT_EQ(evaluate_output(cloud.model, cloud.state, poisson({0, 0, 1}, {0, 6}, {1}, {2, 3, 4, 5, 6, 7})),
            evaluate_output(less.model, less.state, poisson({0, 0, 1}, {0}, {1}, {2, 3, 4, 5, 7})));
  cloud.state.displacement[0].setConstant(not_given);
  EXPECT_TRUE(
      std::isnan(evaluate_output(cloud.model, cloud.state, poisson({0, 0, 1}, {0}, {1}, {2, 3, 4, 5, 7}))));
}

void expect_refusal(const Cloud& cloud, const Output& output, const std::string& reason) {
  try {
    evaluate_output(cloud.model, cloud.state, output);
    ADD_FAILURE() << reason;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_THAT(error.what(), HasSubstr("output \"nu\""));
    EXPECT_THAT(error.what(), HasSubstr(reason));
    EXPECT_THAT(error.what(), HasSubstr("cure:"));
  }
}

TEST(ApparentPoisson, NeedsCentresThatTellBothLateralStrains) {
  Cloud cloud = affine_cloud(Vector3::UnitZ(), 9, some_gradient());
  expect_refusal(cloud, poisson({0, 0, 1}, {0}, {1}, {2, 3}), "measured at 2 particles");
  const std::vector<Index> middle{2, 3, 4, 5, 6, 7};
  for (std::size_t p = 2; p < 8; ++p) cloud.model.particles[p].position.y() = 0.7;
  expect_refusal(cloud, poisson({0, 0, 1}, {0}, {1}, middle), "one plane");
  // A plane across the axis tells them; a tilted one, or a line in it, does not.
  EXPECT_TRUE(std::isfinite(evaluate_output(cloud.model, cloud.state, poisson({0, 1, 0}, {0}, {8}, middle))));
  expect_refusal(cloud, poisson({0, 1, 1e-3}, {0}, {1}, middle), "one plane");
  for (std::size_t p = 2; p < 8; ++p) cloud.model.particles[p].position.z() = 0.1;
  expect_refusal(cloud, poisson({0, 1, 0}, {0}, {1}, middle), "on one line");
}

// An octahedron between frictionless platens: apices at (0, 0, +-h), a ring of four at distance a from the
// axis, bonds from each apex to the ring (length L, L^2 = a^2 + h^2) and round the ring. Pressed by w at each
// apex it bulges by u; by symmetry nothing turns. With the bonds' motions, apex to ring (a u - h w) / L along
// and (h u + a w) / L across, and along the ring sqrt(2) u, twice the energy
//
//     8 kn ((a u - h w) / L)^2 + 8 ks ((h u + a w) / L)^2 + 4 kn 2 u^2
//
// is least at u = w a h (kn - ks) / (kn a^2 + ks h^2 + kn L^2), and nu = (u / a) / (w / h).
TEST(ApparentPoisson, OfAnOctahedronInClosedForm) {
  const double a = 0.7, h = 1.1, kn = 5e6, ks = 1e6, w = 1e-3;
  Model model;
  model.blocks.push_back(block("generic", {{"kn", kn}, {"ks", ks}, {"kt", 3e5}, {"kb", 2e5}}));
  add_particle(model, {0, 0, -h}, 0.1);
  add_particle(model, {0, 0, h}, 0.1);
  for (const auto& [x, y] : {std::pair{a, 0.0}, {0.0, a}, {-a, 0.0}, {0.0, -a}})
    add_particle(model, {x, y, 0}, 0.1);
  for (Index i = 0; i < 4; ++i) {
    add_bond(model, 0, 2 + i);
    add_bond(model, 2 + i, 1);
    add_bond(model, 2 + i, 2 + (i + 1) % 4);
  }
  for (const Index apex : {0, 1})
    model.supports.push_back(
        {apex, {true, true, true, false, false, true}, vector6(0, 0, apex == 0 ? w : -w)});
  const StaticSolution solution = solve_statics(model, {});
  const double found = evaluate_output(model, solution.cases[0], poisson({0, 0, 1}, {0}, {1}));
  EXPECT_NEAR(found, h * h * (kn - ks) / (kn * a * a + ks * h * h + kn * (a * a + h * h)), 1e-15);
}

}  // namespace
}  // namespace bondstatic::test
