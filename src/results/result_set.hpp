// Parts of every folder of results: the tables of a state, and what an earlier run left there.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/model.hpp"
#include "bondstatic/state.hpp"
#include "io/file_set.hpp"

namespace bondstatic {

/// "" or the folder of a load case with a slash behind it.
std::string prefix_of(const std::vector<std::string>& load_cases, const std::string& load_case);

/// What the summary.json of an earlier run lists, or another file of ours with such a list; nothing where
/// there is none, or none of ours.
std::vector<std::string> earlier_files(const std::string& folder, const char* listed_in = "summary.json");

inline constexpr const char* particle_table = "particles.csv";
inline constexpr const char* bond_table = "bonds.csv";
inline constexpr const char* grid_file = "model.vtu";
inline constexpr const char* grid_of_pieces_file = "model.pvtu";
std::string grid_piece_file(int rank);  ///< model_0.vtu

/// The tables and the grid, as so many ranks write them.
std::vector<std::string> state_files(const std::vector<std::string>& load_cases, const std::string& load_case,
                                     int ranks = 1);
void write_state(FileSet& files, const Model& model, const State& state);

/// Bytes of the tables and of the grid of a state where no number is zero.
double typical_table_bytes(Index particles, Index bonds);
double typical_grid_bytes(Index particles, Index bonds);

}  // namespace bondstatic
