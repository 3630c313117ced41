// What lies in a folder of results, as pages.
#pragma once

#include <string>
#include <vector>

#include "report/page_data.hpp"
#include "report/scene_state.hpp"

namespace bondstatic {

/// A run as its command wrote it. The page has no scene yet: that is made of the states.
struct FoundRun {
  PageRun page;
  std::vector<SceneState> states;
  bool si = false;  ///< units are known
};

/// One for each kind of run that the folder has: summary.json of a solve, relax, fracture or compare,
/// certificate.json of a check, calibration.json, sweep.csv. Throws Error (invalid_input) where there is none
/// of them, InputError with file, line and column where one is damaged.
std::vector<FoundRun> read_results(const std::string& folder);

}  // namespace bondstatic
