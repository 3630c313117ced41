#include "model/generators.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace bondstatic {
namespace {

/// Uniform in [0, 1), the same on every platform (the standard's distributions are not).
double uniform(std::mt19937_64& random) {
  return double(random() >> 11) * 0x1p-53;
}

/// Part of `direction` normal to a unit `axis`.
Vector3 normal_part(const Vector3& direction, const Vector3& axis) {
  return direction - direction.dot(axis) * axis;
}

Vector3 any_normal(const Vector3& axis) {
  Eigen::Index least = 0;
  axis.cwiseAbs().minCoeff(&least);
  return normal_part(Vector3::Unit(least), axis).normalized();
}

}  // namespace

std::vector<Vector3> line_points(const Vector3& from, const Vector3& to, Index count) {
  std::vector<Vector3> points(static_cast<std::size_t>(count));
  const double last = double(count - 1);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = ((last - double(i)) * from + double(i) * to) / last;
  points.front() = from;
  points.back() = to;
  return points;
}

std::vector<Vector3> stepped_points(const Vector3& from, const Vector3& step, Index count) {
  std::vector<Vector3> points(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = from + double(i) * step;
  return points;
}

bool Arc::closed() const {
  return pitch == 0 && std::abs(std::abs(angle) - 2 * std::numbers::pi) < 1e-12;
}

bool Arc::start_along_axis() const {
  return !start.isZero(0) && normal_part(start.stableNormalized(), axis).norm() < 1e-9;
}

std::vector<Vector3> arc_points(const Arc& arc) {
  const Vector3 e1 = arc.start.isZero(0) ? any_normal(arc.axis)
                                         : normal_part(arc.start.stableNormalized(), arc.axis).normalized();
  const Vector3 e2 = arc.axis.cross(e1);
  const double steps = double(arc.closed() ? arc.count : arc.count - 1);
  std::vector<Vector3> points(static_cast<std::size_t>(arc.count));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double angle = steps > 0 ? arc.angle * double(i) / steps : 0;
    points[i] = arc.centre + arc.radius * (std::cos(angle) * e1 + std::sin(angle) * e2) +
                arc.pitch * (angle / (2 * std::numbers::pi)) * arc.axis;
  }
  return points;
}

namespace {

std::span<const Vector3> cell_points(LatticeKind kind) {
  static const std::array<Vector3, 2> bcc{Vector3(0, 0, 0), Vector3(.5, .5, .5)};
  static const std::array<Vector3, 4> fcc{Vector3(0, 0, 0), Vector3(.5, .5, 0), Vector3(.5, 0, .5),
                                          Vector3(0, .5, .5)};
  if (kind == LatticeKind::fcc) return fcc;
  return std::span<const Vector3>(bcc).first(kind == LatticeKind::bcc ? 2 : 1);
}

}  // namespace

Index points_per_cell(LatticeKind kind) {
  return Index(cell_points(kind).size());
}

std::vector<Vector3> lattice_points(LatticeKind kind, const std::array<Index, 3>& count, double spacing,
                                    const Vector3& origin) {
  const auto cell = cell_points(kind);
  std::vector<Vector3> points;
  points.reserve(std::size_t(count[0] * count[1] * count[2]) * cell.size());
  for (Index k = 0; k < count[2]; ++k)
    for (Index j = 0; j < count[1]; ++j)
      for (Index i = 0; i < count[0]; ++i)
        for (const Vector3& point : cell)
          points.push_back(origin + spacing * (Vector3(double(i), double(j), double(k)) + point));
  return points;
}

void jitter(std::span<Vector3> points, std::span<const double> most, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) points[i][axis] += most[i] * (2 * uniform(random) - 1);
}

std::vector<Index> survivors(Index count, double fraction, std::uint64_t seed) {
  // Selection sampling (Knuth 3.4.2, algorithm S): every subset of that size is equally likely.
  std::mt19937_64 random(seed ^ 0x9e3779b97f4a7c15u);  // apart from jitter's numbers
  Index to_remove = std::llround(fraction * double(count));
  std::vector<Index> stay;
  stay.reserve(std::size_t(count - to_remove));
  for (Index i = 0; i < count; ++i)
    if (uniform(random) * double(count - i) < double(to_remove))
      --to_remove;
    else
      stay.push_back(i);
  return stay;
}

}  // namespace bondstatic
