#pragma once

#include <cstdint>
#include <vector>

#include "bondstatic/output.hpp"

namespace bondstatic {

/// Tells outputs apart that are columns of a history.
std::uint64_t fingerprint_of(const std::vector<Output>& outputs);

}  // namespace bondstatic
