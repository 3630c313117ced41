// Numbers as tables hold them.
#pragma once

#include "bondstatic/types.hpp"

namespace bondstatic {

inline constexpr int longest_number = 32;  ///< characters that one number may take

/// Writes the shortest decimal that reads back to the same double (as fmt's "{}": 0.001, 1e-05, 1e+16, inf),
/// nothing for NaN; returns the end. There must be room for `longest_number` characters.
char* write_number(char* out, double value);
char* write_number(char* out, Index value);

}  // namespace bondstatic
