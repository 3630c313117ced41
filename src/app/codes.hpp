// Codes by the name that a user gives.
#pragma once

#include <string>

#include "bond/codes.hpp"

namespace bondstatic {

/// Throws Error (invalid_input) that names the codes there are.
const BondCode& bond_code(const std::string& name);

}  // namespace bondstatic
