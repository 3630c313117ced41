// Which bondstatic this is.
#pragma once

#include <string>

namespace bondstatic {

/// "0.1.0"
std::string version();

}  // namespace bondstatic
