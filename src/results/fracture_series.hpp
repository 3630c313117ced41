// The states of a run of fracture: each a grid of its own, written as the run goes into a folder that nobody
// takes for results, and together a series that ParaView plays.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/results.hpp"
#include "io/column.hpp"
#include "io/file_set.hpp"

namespace bondstatic {

inline constexpr const char* unfinished_folder = "fracture.unfinished";
inline constexpr const char* series_file = "fracture.pvd";
std::string fracture_state_file(Index events);  ///< fracture_0012.vtu
bool is_fracture_state(const std::string& name);

/// break_step and utilisation.
std::vector<Column> fracture_columns(const Model& model, const State& state,
                                     const std::vector<Index>& break_event);

/// VTK's collection of the states.
std::string series_text(const std::vector<Index>& states);

/// Makes the states that were shown part of the results in `folder`, and leaves them where they are.
void adopt_states(FileSet& files, const std::vector<Index>& states, const std::string& folder);

/// Throws Error (invalid_input) where one of them is not there.
void check_states(const std::vector<Index>& states, const std::string& folder);

/// Removes all states but these; with the last one the folder.
void remove_states(const std::string& folder, const std::vector<Index>& but = {});

}  // namespace bondstatic
