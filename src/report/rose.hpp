// Bonds by their direction in a plane, in petals of ten degrees about 0, 10, ... 350 degrees.
#pragma once

#include <array>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

inline constexpr int petals = 36;

/// Middle of each petal, in degrees.
std::vector<double> rose_angles();

class Rose {
 public:
  /// A bond without direction in the plane is left out; one that lies between two petals, as bonds of
  /// lattices do, counts half in each. `plane`: the axis to the right, and the one that it turns to.
  void add(const Vector3& branch, std::array<int, 2> plane, double value);

  Index bonds() const { return bonds_; }
  std::vector<double> counts() const { return {counts_.begin(), counts_.end()}; }
  /// Mean value of each petal, NaN where it has no bond.
  std::vector<double> means() const;

 private:
  std::array<double, petals> counts_{}, sums_{};
  Index bonds_ = 0;
};

}  // namespace bondstatic
