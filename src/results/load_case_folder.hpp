// Where the tables of a load case lie.
#pragma once

#include <string>
#include <vector>

namespace bondstatic {

/// "" for the only load case, otherwise a folder called like it. Characters that would make it a path, a
/// hidden folder or something unprintable stand as %XX, so that no two names share a folder.
std::string load_case_folder(const std::vector<std::string>& load_cases, const std::string& name);

}  // namespace bondstatic
