// The grids that a folder of results has, for the scene.
#pragma once

#include <string>
#include <vector>

#include "report/json_value.hpp"
#include "report/page_data.hpp"
#include "report/scene_state.hpp"

namespace bondstatic {

/// The folder of a load case in a folder of results. Throws InputError where the summary leads outside of it.
std::string folder_of(const std::string& folder, const JsonValue& load_case);

/// model.vtu, or the pieces that model.pvtu names. Where they are not there: none, and a note in `run`.
std::vector<std::string> grid_files(const std::string& folder, PageRun& run);

/// A state for each load case of a summary, without a label.
std::vector<SceneState> load_case_states(const std::string& folder, const JsonValue& summary, PageRun& run);

/// What the series of a kind of run lists (results/state_series.hpp), "relax" or "fracture": files and times,
/// ascending. None, and a note, where it is not there.
struct ShownState {
  std::string file;
  double time = 0;  ///< of a run of fracture: how many events had happened
};
std::vector<ShownState> shown_states(const std::string& folder, const std::string& kind, PageRun& run);

}  // namespace bondstatic
