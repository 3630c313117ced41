// What a user may change for bonds that are beams, as sentences.
#pragma once

#include "bondstatic/resolution.hpp"

namespace bondstatic {

/// One number where all bonds have about the same, else "A to B".
std::string range_text(const Spread& spread);

/// What advice names beside the numbers of the block.
struct Inputs {
  Spread young;              ///< kn L/A
  Spread shear_coefficient;  ///< 2 (1 + nu) ks/kn, as Obermayr's law has it
  Spread beam_coefficient;   ///< of the beam
};

/// For a block whose numbers are complete.
std::vector<std::string> advice_for(const BlockResolution& block, const BondBlock& given,
                                    const Inputs& inputs);

}  // namespace bondstatic
