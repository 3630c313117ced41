// The answer of `solve` as a user reads it.
#pragma once

#include <string>

#include "app/run_case.hpp"

namespace bondstatic {

/// `folder` is where the results went; "" if nowhere.
std::string report(const Case& given, const Answer& answer, const std::string& folder);

}  // namespace bondstatic
