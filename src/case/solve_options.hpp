// [solve]: solver, tolerance (on the backward error), unsupported = "error" | "drop", memory_limit (bytes or
// "8 GB", 0: what the machine has), threads (0: the cores at hand).
#pragma once

#include "bondstatic/statics.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

StaticOptions read_solve_options(Reading& reading, Node& table);

}  // namespace bondstatic
