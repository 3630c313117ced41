// Ids of particles as a file gives them: each once, and bonds only between those that there are.
#pragma once

#include <string>
#include <vector>

#include "formats/foreign_model.hpp"
#include "io/id_table.hpp"

namespace bondstatic {

/// Positions by id; ids that are there twice are faults, appended at `line` of the second.
IdTable table_of_ids(const std::vector<Index>& ids, const std::vector<int>& lines, const std::string& file,
                     std::vector<Fault>& faults);

}  // namespace bondstatic
