// Parameters of bond laws by the keys of a case: "bonds.0.young" of one block, "young" of all that give it.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/calibration.hpp"

namespace bondstatic {

struct NamedParameter {
  std::vector<BlockParameter> places;  ///< empty: the key names nothing that could be calibrated, and
  std::string message, cure;           ///< this is why
};

/// Only numbers (no seed, no switch), and only where the block gives them: with kappa given, poisson does
/// nothing, and neither does a block's value where each bond has its own.
NamedParameter find_parameter(const Model& model, const std::string& key);

/// "3 of 4 bonds of bonds.0 have a young of their own", for each block: these bonds do not follow the key.
std::vector<std::string> own_values(const Model& model, const std::string& key);

/// Of the place's law.
const Parameter& parameter_at(const Model& model, const BlockParameter& place);
double value_at(const Model& model, const BlockParameter& place);

/// "bonds.0.young"
std::string key_of(const Model& model, const BlockParameter& place);

}  // namespace bondstatic
