#include "results/lateral_strain.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>

#include "results/output_values.hpp"

namespace bondstatic {

namespace {

struct Spread {
  double count = 0;
  Vector3 centre = Vector3::Zero();
  Matrix3 second_moment = Matrix3::Zero();  ///< sum of d d^T, d from the centre
};

Spread spread_of(const std::vector<SpecimenParticle>& particles) {
  Spread spread;
  for (const SpecimenParticle& particle : particles) {
    if (particle.left_out()) continue;
    spread.centre += particle.position;
    ++spread.count;
  }
  spread.centre /= spread.count;
  for (const SpecimenParticle& particle : particles) {
    if (particle.left_out()) continue;
    const Vector3 d = particle.position - spread.centre;
    spread.second_moment += d * d.transpose();
  }
  return spread;
}

/// M w = direction, for the gradient along it; nothing where a plane (thinner than a millionth of its
/// extent) or a line of centres does not tell it.
std::optional<Vector3> along(const Matrix3& second_moment, const Vector3& direction) {
  constexpr double thin = 1e-6;
  const Eigen::SelfAdjointEigenSolver<Matrix3> spectrum(second_moment);
  Vector3 w = Vector3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vector3 axis = spectrum.eigenvectors().col(i);
    const double extent = spectrum.eigenvalues()[i];
    if (extent > thin * thin * spectrum.eigenvalues()[2])
      w += axis.dot(direction) / extent * axis;
    else if (std::abs(axis.dot(direction)) > thin)
      return std::nullopt;
  }
  return w;
}

}  // namespace

std::vector<Vector3> lateral_strain_weights(const Output& output,
                                            const std::vector<SpecimenParticle>& particles) {
  const Spread spread = spread_of(particles);
  if (spread.count < 3)
    refuse(output, fmt::format("the sides are measured at {} particles", spread.count),
           "select three or more in middle, the more the better");
  std::vector<Vector3> weights(particles.size(), Vector3::Zero());
  for (const Vector3& direction : lateral_directions(output.axis.normalized())) {
    const auto w = along(spread.second_moment, direction);
    if (!w)
      refuse(
          output,
          fmt::format("all {} centres where the sides are measured lie in one plane, or on one line, and do "
                      "not tell the strain along ({:.3g}, {:.3g}, {:.3g})",
                      spread.count, direction.x(), direction.y(), direction.z()),
          "select particles in middle that lie apart in both directions across the axis");
    for (std::size_t p = 0; p < particles.size(); ++p)
      if (!particles[p].left_out())
        weights[p] += 0.5 * (particles[p].position - spread.centre).dot(*w) * direction;
  }
  return weights;
}

}  // namespace bondstatic
