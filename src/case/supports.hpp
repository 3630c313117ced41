// [[supports]]: at, fix = "all" | ["x", "rz", ..], values = { z = "-0.1 mm", ry = "1 deg" }, case. A degree
// of freedom in both takes the value; loads and supports without `case` hold in every load case.
#pragma once

#include "case/draft.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

/// One Support a particle and block. A degree of freedom that two blocks prescribe differently in one load
/// case is a fault.
void read_supports(Draft& draft, Node* list);

}  // namespace bondstatic
