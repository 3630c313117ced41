// A case read, solved and its outputs evaluated: what solve does once and sweep does at every point of its
// grid.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "bondstatic/case_file.hpp"
#include "bondstatic/output.hpp"
#include "bondstatic/results.hpp"

namespace bondstatic {

/// Reads the case and applies the choices of the command line.
Case read_case(const SolveArguments& arguments, const std::vector<std::string>& overrides,
               Purpose purpose = Purpose::statics);

struct Answer {
  StaticSolution solution;
  std::vector<OutputValue> outputs;
  std::vector<BlockResolution> resolution = {};  ///< of `solve`
};

/// `progress` hears of each phase. Throws Error (invalid_input) where sensitivities are asked of no outputs.
Answer answer(const Case& given, const std::function<void(const std::string&)>& progress,
              Sensitivities sensitivities = Sensitivities::none);

}  // namespace bondstatic
