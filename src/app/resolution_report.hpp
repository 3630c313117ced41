// How the bonds of a model compare to beams, as `solve` tells it in passing; summary.json has it in full.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/resolution.hpp"

namespace bondstatic {

/// A sentence or two for each block whose bonds differ from beams by 0.1 % or more, anywhere.
std::vector<std::string> resolution_texts(const std::vector<BlockResolution>& blocks);

}  // namespace bondstatic
