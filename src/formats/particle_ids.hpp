// Ids as a file gives them: each once.
#pragma once

#include <string>
#include <vector>

#include "formats/foreign_model.hpp"
#include "io/id_table.hpp"

namespace bondstatic {

/// Positions by id; ids that are there twice are faults, appended at the line of the second. `of`:
/// "particle", "bond".
IdTable table_of_ids(const std::string& of, const std::vector<Index>& ids, const std::vector<int>& lines,
                     const std::string& file, std::vector<Fault>& faults);

}  // namespace bondstatic
