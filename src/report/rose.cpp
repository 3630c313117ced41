#include "report/rose.hpp"

#include <cmath>
#include <numbers>

#include "bondstatic/model.hpp"

namespace bondstatic {

namespace {

constexpr double petal_degrees = 360.0 / petals;

/// Sine of six degrees: what is nearer to the plane's normal has no direction in the plane.
constexpr double no_direction = 0.10452846326765347;

}  // namespace

std::vector<double> rose_angles() {
  std::vector<double> angles;
  for (int petal = 0; petal < petals; ++petal) angles.push_back(petal * petal_degrees);
  return angles;
}

void Rose::add(const Vector3& branch, std::array<int, 2> plane, double value) {
  const double right = branch[plane[0]], up = branch[plane[1]];
  if (!(std::hypot(right, up) > no_direction * branch.stableNorm())) return;
  ++bonds_;
  const double degrees = std::atan2(up, right) * 180 / std::numbers::pi;
  const double place = degrees / petal_degrees + petals;  // positive
  const double rounding = 1e-9;
  const int low = int(std::floor(place + 0.5 - rounding)), high = int(std::floor(place + 0.5 + rounding));
  for (const int petal : {low, high})
    for (const int direction : {petal, petal + petals / 2}) {
      counts_[std::size_t(direction % petals)] += 0.5;
      sums_[std::size_t(direction % petals)] += 0.5 * value;
    }
}

std::vector<double> Rose::means() const {
  std::vector<double> means;
  for (std::size_t i = 0; i < counts_.size(); ++i)
    means.push_back(counts_[i] > 0 ? sums_[i] / counts_[i] : not_given);
  return means;
}

}  // namespace bondstatic
