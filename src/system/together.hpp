// Figures that all ranks of a run form together, each from its own part. Without ranks (null) a process has
// all of it, and its figures are what they are, bit for bit.
#pragma once

#include <span>

#include "system/extended.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

/// NaN where it is NaN on any rank.
double largest_of_all(Ranks* ranks, double mine);

/// Added up in the order of the ranks, the same on all of them.
void add_up(Ranks* ranks, std::span<Extended> mine);
double sum_of_all(Ranks* ranks, double mine);

}  // namespace bondstatic
