// Readers of what our own commands wrote, which a report shows: each asks a file for everything.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/error.hpp"

namespace bondstatic {

/// Append what is wrong with the file; abort where an answer is not sound.
void read_whole_grid(const std::string& path, std::vector<Fault>& faults);
void read_whole_table(const std::string& path, std::vector<Fault>& faults);
void read_whole_sweep(const std::string& path, std::vector<Fault>& faults);
void read_whole_json(const std::string& path, std::vector<Fault>& faults);

}  // namespace bondstatic
