// Supports, loads and strain of one load case, spread over the particles.
#pragma once

#include <vector>

#include "bondstatic/model.hpp"

namespace bondstatic {

struct Boundary {
  std::vector<std::uint8_t> free;   ///< bit i of free[p]: degree of freedom i of particle p is free
  std::vector<Vector6> prescribed;  ///< motion where not free, zero elsewhere
  std::vector<Vector6> load;
  Matrix3 strain = Matrix3::Zero();  ///< of the periodic cell
  /// What rounding `load` to double has left over; empty: nothing. Of loads that were computed, not given.
  std::vector<Vector6> load_tail = {};
};

/// Throws Error (invalid_input) where two supports prescribe one degree of freedom differently.
Boundary boundary_of(const Model& model, Index load_case);

}  // namespace bondstatic
