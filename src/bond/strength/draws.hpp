// Strengths that scatter from bond to bond: numbers that look random but depend on the seed, the pair of
// particles and which bond between them it is, alone.
#pragma once

#include <cstdint>
#include <vector>

#include "bondstatic/model.hpp"

namespace bondstatic {

/// Of each bond, how many between the same two particles come before it in the model.
std::vector<Index> ordinals_in_pair(const Model& model);

/// Key of all draws of one bond.
std::uint64_t bond_key(Index seed, Index id_a, Index id_b, Index ordinal);

/// A strength drawn about `given` (BondStrength::Scatter), the first of the stream that is positive and
/// finite; NaN where a thousand are not.
double drawn_strength(BondStrength::Scatter scatter, double given, double spread, std::uint64_t key,
                      std::uint64_t stream);

}  // namespace bondstatic
