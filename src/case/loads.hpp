// [[loads]]: at, force | total_force, moment | total_moment, case; or gravity = [0, 0, -9.81], with or
// without at. A total is shared equally by the selected particles. Gravity acts with mass 4/3 pi R^3 density.
#pragma once

#include "case/draft.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

void read_loads(Draft& draft, Node* list);

}  // namespace bondstatic
