// Parts of every folder of results: the tables of a state, and what an earlier run left there.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/model.hpp"
#include "bondstatic/state.hpp"
#include "io/file_set.hpp"

namespace bondstatic {

/// "" or the folder of a load case with a slash behind it.
std::string prefix_of(const Model& model, const std::string& load_case);

/// What the summary.json of an earlier run lists; nothing where there is none, or none of ours.
std::vector<std::string> earlier_files(const std::string& folder);

/// particles.csv, bonds.csv, model.vtu.
std::vector<std::string> state_files(const Model& model, const std::string& load_case);
void write_state(FileSet& files, const Model& model, const State& state);

}  // namespace bondstatic
