#include "system/bisection.hpp"

#include <algorithm>
#include <numeric>

namespace bondstatic {

namespace {

int longest_axis(std::span<const Vector3> points, std::span<const Index> chosen) {
  Vector3 low = points[std::size_t(chosen.front())], high = low;
  for (const Index p : chosen) {
    low = low.cwiseMin(points[std::size_t(p)]);
    high = high.cwiseMax(points[std::size_t(p)]);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  return axis;
}

void cut(std::span<const Vector3> points, std::span<Index> chosen, int first_part, int parts,
         std::vector<int>& part) {
  if (parts == 1 || chosen.empty()) {
    for (const Index p : chosen) part[std::size_t(p)] = first_part;
    return;
  }
  const int left_parts = parts / 2;
  const auto left = std::ptrdiff_t(chosen.size()) * left_parts / parts;
  const int axis = longest_axis(points, chosen);
  std::nth_element(chosen.begin(), chosen.begin() + left, chosen.end(), [&](Index p, Index q) {
    const double x = points[std::size_t(p)][axis], y = points[std::size_t(q)][axis];
    return x < y || (x == y && p < q);
  });
  cut(points, chosen.first(std::size_t(left)), first_part, left_parts, part);
  cut(points, chosen.subspan(std::size_t(left)), first_part + left_parts, parts - left_parts, part);
}

}  // namespace

std::vector<int> bisect(std::span<const Vector3> points, int parts) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::vector<int> part(points.size(), 0);
  cut(points, order, 0, parts, part);
  return part;
}

}  // namespace bondstatic
