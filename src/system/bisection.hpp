// Recursive coordinate bisection (Berger, Bokhari, IEEE Trans. Comput. C-36 (1987) 570): points are cut in
// two across their longest extent, each half again, until there are as many parts as asked for. Any number of
// parts, not only powers of two; parts differ by at most one point for each level of cuts.
#pragma once

#include <span>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

/// The part of each point, 0 ... parts - 1. The same on every machine: points of equal coordinate go by their
/// number.
std::vector<int> bisect(std::span<const Vector3> points, int parts);

}  // namespace bondstatic
