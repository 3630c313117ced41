// Particle types of other codes as groups of a model.
#pragma once

#include <vector>

#include "formats/foreign_model.hpp"

namespace bondstatic {

/// Groups "type 1", "type 2", ... for the types that occur, ascending; nothing where `types` is empty.
void group_by_type(const std::vector<Index>& types, ForeignModel& model);

}  // namespace bondstatic
