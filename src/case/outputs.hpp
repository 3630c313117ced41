// [[outputs]]: name, of, at, base and axis (apparent_young: from the platen base to the platen at), reduce,
// scale, case, expected, tolerance, source.
#pragma once

#include "bondstatic/output.hpp"
#include "case/draft.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

std::vector<Output> read_outputs(Draft& draft, Node* list);

}  // namespace bondstatic
