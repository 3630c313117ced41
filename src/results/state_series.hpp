// The states of a run: each a grid of its own, written as the run goes into a folder that nobody takes for
// results, and together a series that ParaView plays.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "bondstatic/types.hpp"
#include "io/file_set.hpp"

namespace bondstatic {

// By the kind of run, "fracture" or "relax":
std::string state_file(const std::string& kind, Index number);  ///< fracture_0012.vtu
std::string series_file(const std::string& kind);               ///< fracture.pvd
std::string unfinished_folder(const std::string& kind);         ///< fracture.unfinished
/// Whether a file is called like a state; folders before its name do not matter.
bool is_state_file(const std::string& kind, const std::string& name);

struct SeriesState {
  Index number = 0;  ///< in the file's name
  double time = 0;   ///< as the series is played
};

/// States lie in `unfinished` until they become part of the results, in the subfolder `prefix` ("" or
/// "NAME/").
struct StateSeries {
  std::string kind;
  std::filesystem::path unfinished;
  std::string prefix = "";
  std::vector<SeriesState> states = {};  ///< ascending
};

/// Adds the grid that `write` writes, whole or not at all: one of the states, which may be there already.
void add_state(const StateSeries& series, Index number, const std::function<void(OutputFile&)>& write);

/// Names of the states and of the collection as results; nothing where there are no states.
std::vector<std::string> series_files(const StateSeries& series);
/// Names of all states in the folder of results, of whatever run.
std::vector<std::string> states_in(const std::filesystem::path& folder, const StateSeries& series);

/// Makes the states and VTK's collection of them part of the results, and leaves them where they are.
void adopt_states(FileSet& files, const StateSeries& series);

/// Throws Error (invalid_input) where one of them is not there; `checkpoint` is the file that speaks of them.
void check_states(const StateSeries& series, const char* checkpoint);

/// Removes all states but these; with the last one the folder.
void remove_other_states(const StateSeries& series);

}  // namespace bondstatic
