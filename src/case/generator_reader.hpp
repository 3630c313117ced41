// The generators of a [[particles]] block: from their tables to points.
#pragma once

#include <optional>
#include <vector>

#include "case/table_reader.hpp"

namespace bondstatic {

/// The generator keys that a block may have.
const std::vector<std::string>& generator_keys();

/// Points of the generator `key` of the block, nothing where it is at fault.
std::optional<std::vector<Vector3>> generated_points(TableReader& block, const std::string& key);

}  // namespace bondstatic
