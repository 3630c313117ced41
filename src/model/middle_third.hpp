// Where a specimen between two platens is measured when nobody says where.
#pragma once

#include <vector>

#include "bondstatic/model.hpp"

namespace bondstatic {

/// Ascending positions of the particles whose centres lie in the middle third between the mean centres of
/// `base` and `at`, along the axis (of any length); boundaries are inside.
std::vector<Index> middle_third(const Model& model, const std::vector<Index>& base,
                                const std::vector<Index>& at, const Vector3& axis);

}  // namespace bondstatic
