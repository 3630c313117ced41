// The radius of each bond's section alone: an eighth of the memory of bond_properties().
#pragma once

#include <vector>

#include "bondstatic/model.hpp"

namespace bondstatic {

/// NaN where the bond's law has no section. Throws as bond_properties() does.
std::vector<double> bond_radii(const Model& model, int threads = 1);

}  // namespace bondstatic
