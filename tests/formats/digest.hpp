// All that a reader found, as text with 17 digits; checks that it is sound.
#pragma once

#include <string>

#include "formats/readers.hpp"

namespace bondstatic::test {

/// Ids are distinct, numbers finite, radii positive or not given; bonds join two particles, which are there
/// where the file has particles; columns are as long as what they belong to.
std::string digest(const ForeignModel& model);
std::string digest(const ParticleState& state);
std::string digest(const BondState& state);

}  // namespace bondstatic::test
