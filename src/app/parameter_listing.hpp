// What the listings of laws and of strength criteria have in common.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/terminal.hpp"
#include "bondstatic/bond_law.hpp"
#include "bondstatic/error.hpp"

namespace bondstatic {

using Json = nlohmann::ordered_json;

/// Name, unit, bounds, default and meaning of each.
TextTable table_of(const std::vector<Parameter>& parameters);
Json json_of(const std::vector<Parameter>& parameters);

/// "unknown law ..., did you mean ...".
Error unknown_name(const std::string& kind, const std::string& name, const std::vector<std::string>& known);

}  // namespace bondstatic
