// What the JSON of a run and of a certificate say of a run in the same way.
#pragma once

#include "bondstatic/relaxation.hpp"
#include "results/summary_parts.hpp"

namespace bondstatic {

Json relaxed_case_of(const Model& model, const RelaxedCase& relaxed);

}  // namespace bondstatic
