// TOML to tree and tree to TOML.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/node.hpp"

namespace bondstatic {

/// The tree of a TOML document. Where the text is not TOML, the fault is appended and nothing returned.
std::optional<Node> parse_toml(const std::string& text, const std::string& file, std::vector<Fault>& faults);

/// One value as in a TOML document ("2.5", "[1, 2]", "{ id = 3 }"); nothing where the text is not one.
std::optional<Node> parse_toml_value(const std::string& text);

/// The document of a tree: plain values first, then tables and lists of tables; numbers round-trip.
std::string to_toml(const Node& root);

}  // namespace bondstatic
