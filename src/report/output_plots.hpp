// What a case asked for: its outputs, beside what was expected of them.
#pragma once

#include <string>
#include <vector>

#include "report/json_value.hpp"
#include "report/page_data.hpp"

namespace bondstatic {

/// Outputs with expected values, errors and tolerances. `judged`: whether a tolerance that is missed is one
/// that the run was to keep; an explicit run of finite rotations is not.
void put_outputs(PageRun& run, const JsonValue& summary, bool judged);

/// Derivatives and relative sensitivities of outputs to bond parameters.
void put_sensitivities(PageRun& run, const JsonValue& summary);

/// Outputs called "particle 2", "particle 3" ..: three or more with one stem and a number each.
struct NumberedOutputs {
  std::string stem;
  std::vector<double> number;      ///< ascending
  std::vector<std::size_t> index;  ///< of the output, beside each number
};
std::vector<NumberedOutputs> numbered_outputs(const std::vector<std::string>& names);

}  // namespace bondstatic
