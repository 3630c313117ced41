// [[outputs]]: name, of, at, base and axis (apparent_young, apparent_poisson: from the platen base to the
// platen at), middle (apparent_poisson: where the sides are measured), reduce, scale, case, expected,
// tolerance, source.
#pragma once

#include "bondstatic/output.hpp"
#include "case/draft.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

std::vector<Output> read_outputs(Draft& draft, Node* list);

}  // namespace bondstatic
