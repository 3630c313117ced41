// A disordered packing as users have it: a case file with tables in CSV, in the order of chance.
#pragma once

#include <filesystem>

#include "bondstatic/types.hpp"

namespace bondstatic::bench {

/// Writes folder/case.toml and its tables for about so many particles, in place of all that is in the folder.
/// The model is never in this process: programs begin as a copy of it, and their memory is measured.
void write_packing_case(const std::filesystem::path& folder, Index particles);

}  // namespace bondstatic::bench
