#pragma once

#include <cstdio>

#include "bondstatic/report.hpp"

namespace bondstatic {

/// Where the report is, how large, and what it leaves out.
void tell(const Report& report, std::FILE* stream);

}  // namespace bondstatic
