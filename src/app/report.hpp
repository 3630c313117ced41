// The answer of `solve` as a user reads it.
#pragma once

#include <string>

#include "app/run_case.hpp"

namespace bondstatic {

/// Title and what the model consists of.
std::string heading(const Case& given);
/// `judged`: what is farther from its expected value than its tolerance is said to be.
std::string outputs_table(const std::vector<OutputValue>& outputs, bool judged = true);
std::string displacement_table(const Case& given, const std::vector<const State*>& states);
std::string warnings_text(const std::vector<std::string>& warnings);
std::string dropped_text(const Case& given, const std::vector<std::vector<Index>>& dropped);
std::string counted(Index count, const std::string& what);

/// `folder` is where the results went; "" if nowhere.
std::string report(const Case& given, const Answer& answer, const std::string& folder);

}  // namespace bondstatic
