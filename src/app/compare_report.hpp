// What `compare` tells a reader.
#pragma once

#include <string>

#include "bondstatic/case_file.hpp"
#include "bondstatic/compare.hpp"

namespace bondstatic {

/// `steps`: one where no series was asked for; `written`: where the results went, "" if nowhere.
std::string comparison_report(const Case& given, const StaticReport& solved,
                              const std::vector<Comparison>& steps, const std::string& written);

}  // namespace bondstatic
