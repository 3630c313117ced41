// The page of each kind of run, from what its command wrote into a folder. All throw InputError where a file
// is damaged.
#pragma once

#include <string>

#include "report/json_value.hpp"
#include "report/result_folder.hpp"

namespace bondstatic {

FoundRun solve_page(const std::string& folder, const JsonValue& summary);
FoundRun relax_page(const std::string& folder, const JsonValue& summary);
FoundRun fracture_page(const std::string& folder, const JsonValue& summary);
FoundRun compare_page(const std::string& folder, const JsonValue& summary);
FoundRun check_page(const std::string& folder, const JsonValue& certificate);
FoundRun calibrate_page(const std::string& folder, const JsonValue& calibration);
FoundRun sweep_page(const std::string& folder);  ///< of sweep.csv

}  // namespace bondstatic
