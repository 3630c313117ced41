// The answer of `solve` as a user reads it.
#pragma once

#include <string>

#include "app/run_case.hpp"

namespace bondstatic {

/// Title and what the model consists of.
std::string heading(const Case& given, const ModelFacts& model);
/// `judged`: what is farther from its expected value than its tolerance is said to be.
std::string outputs_table(const std::vector<OutputValue>& outputs, bool judged = true);
/// Where nothing was asked for, the largest displacement of each load case answers.
std::string displacement_table(const std::vector<const State*>& states,
                               const std::vector<LargestDisplacement>& largest);
std::string warnings_text(const std::vector<std::string>& warnings);
std::string dropped_text(const std::vector<std::vector<Index>>& dropped);
std::string counted(Index count, const std::string& what);
/// "DIR: particles.csv, ..": what a run wrote. States of its series (results/state_series.hpp) are only
/// counted.
std::string written_text(const std::string& folder, const std::vector<std::string>& files,
                         const std::string& kind);

/// Asks nothing of given.model, which may be gone. `files` are the results that went to `folder`; none if
/// they went nowhere.
std::string report(const Case& given, const ModelFacts& model, const Answer& answer,
                   const std::vector<LargestDisplacement>& largest, const std::string& folder,
                   const std::vector<std::string>& files);
/// The same where one process has it all; no folder if the results went nowhere.
std::string report(const Case& given, const Answer& answer, const std::string& folder);

}  // namespace bondstatic
