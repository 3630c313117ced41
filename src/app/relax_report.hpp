// What `relax` and `check` tell a reader.
#pragma once

#include <string>

#include "bondstatic/case_file.hpp"
#include "bondstatic/check.hpp"

namespace bondstatic {

/// "compression: step 12000, time 0.0023, fastest particle 3.1e-07, unbalanced force 2e-08, about 3 s left"
std::string progress_text(const RelaxProgress& progress);

std::string relaxation_report(const Case& given, const Relaxation& relaxation,
                              const std::vector<OutputValue>& outputs, const std::string& written);
std::string certificate_report(const Case& given, const Certificate& certificate);

/// What kept a run from rest, and the cure; "" where it is at rest.
std::string unrest_text(const Case& given, const RelaxedCase& relaxed);

}  // namespace bondstatic
