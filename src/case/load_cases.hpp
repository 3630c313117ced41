// Names of load cases: `case` in [[loads]] and [[supports]].
#pragma once

#include "case/draft.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

/// Collects the names into Model::load_cases in the order of the loads, then of the supports; "" alone where
/// none is named.
void collect_load_cases(Draft& draft, Node* loads, Node* supports);

/// Number of the load case that a block names, every_case where it names none.
Index load_case_of(Draft& draft, TableReader& block);

}  // namespace bondstatic
