// KEY=VALUE from the command line, applied to the tree before it is read.
#pragma once

#include <string>
#include <vector>

#include "case/node.hpp"

namespace bondstatic {

/// KEY is dotted, with positions from 0 in lists: "bonds.0.young", "particles.0.line.to.0". VALUE is as in
/// TOML; what is no TOML value is a text. Members of tables are made where absent; list positions must be
/// there. Values carry the place "--set KEY=VALUE". Faults: no "=", a position out of range, a key through
/// what is no table or list.
void apply_overrides(Node& root, const std::vector<std::string>& overrides, std::vector<Fault>& faults);

/// What such a key names in the tree; null where there is nothing.
Node* find_node(Node& root, const std::string& key);

}  // namespace bondstatic
