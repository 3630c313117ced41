// Formulas of LAMMPS input scripts as far as they are constants (docs.lammps.org/variable.html).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace bondstatic {

/// What a script has given names to, as text; a number where it is one.
using ScriptVariables = std::map<std::string, std::string, std::less<>>;

/// Numbers, + - * / ^, parentheses, PI, v_NAME, sqrt exp ln log abs sin cos tan asin acos atan. Nothing where
/// the formula asks for more, or is not finite. -x^y and x^y^z, which tools read differently, are not read.
std::optional<double> constant_formula(std::string_view text, const ScriptVariables& variables);

}  // namespace bondstatic
