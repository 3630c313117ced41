// What every summary.json says in the same way.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bondstatic/model.hpp"
#include "bondstatic/output.hpp"
#include "bondstatic/state.hpp"
#include "bondstatic/version.hpp"

namespace bondstatic {

using Json = nlohmann::ordered_json;

Json counts_of(const Model& model);
Json outputs_of(const std::vector<OutputValue>& outputs);
Json state_of(const Model& model, const State& state);

/// Lists of particle ids: positions mean nothing outside.
Json bodies_of(const Model& model, const std::vector<std::vector<Index>>& bodies);

/// Indented; titles may hold bytes that are no UTF-8: they become U+FFFD, and the rest is still told.
std::string to_text(const Json& json);

}  // namespace bondstatic
