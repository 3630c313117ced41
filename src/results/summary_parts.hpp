// What every summary.json says in the same way.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bondstatic/results.hpp"
#include "bondstatic/version.hpp"

namespace bondstatic {

using Json = nlohmann::ordered_json;

Json counts_of(const ModelFacts& model);
Json outputs_of(const std::vector<OutputValue>& outputs);
Json solver_of(const StaticReport& report);
Json resolution_of(const std::vector<BlockResolution>& blocks);
Json state_of(const std::vector<std::string>& load_cases, const State& state,
              const LargestDisplacement& largest);

/// Indented; titles may hold bytes that are no UTF-8: they become U+FFFD, and the rest is still told.
std::string to_text(const Json& json);

}  // namespace bondstatic
