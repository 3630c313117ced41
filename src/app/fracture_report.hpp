// What `fracture` tells a reader.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/case_file.hpp"
#include "bondstatic/output.hpp"

namespace bondstatic {

/// "fracture: 120 events, 133 bonds broken, factor 0.83, load 0.97 of the largest"
std::string progress_text(const FractureProgress& progress);

/// `files` are those that were written to `folder`; none if they went nowhere.
std::string fracture_report(const Case& given, const Fracture& fracture,
                            const std::vector<OutputValue>& outputs, const std::string& folder,
                            const std::vector<std::string>& files);

}  // namespace bondstatic
