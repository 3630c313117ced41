// Units of outputs: what a number that is held against one may be given in.
#pragma once

#include <optional>
#include <string>

#include "bondstatic/units.hpp"

namespace bondstatic {

/// Of what an output is `of`; nothing where there is no such quantity. Angles are pure numbers.
std::optional<Dimension> dimension_of_output(const std::string& of);

/// The factor from SI to the output as it is told. A scale that is a power of ten is one of units, and its
/// sign one of direction; of another one (over an area, say) the unit cannot be told: nothing.
std::optional<double> unit_scale(double scale);

}  // namespace bondstatic
