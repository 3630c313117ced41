// One set of results written by all ranks of a run, each its own particles and bonds.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bondstatic/results.hpp"
#include "model/piece.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

/// Writes result_files(facts, ranks.size()) as write_results() does; called by all ranks. `facts` are of the
/// whole model and asked for at rank 0 only, as are `run` and `outputs`. The states of `solution` are
/// numbered as in the piece; what it says of the whole (names, energy, work, accuracy, report) is the same on
/// all ranks. All must see the same folder. No rank holds more than its piece: rank 0 puts the tables
/// together from the files of the others, block by block. After an error on any rank the folder is as it was,
/// and all throw: the others throw an Error with its words.
void write_results_on_ranks(const Piece& piece, const ModelFacts& facts, const RunInfo& run,
                            const StaticSolution& solution, const std::vector<OutputValue>& outputs,
                            const std::string& folder, Ranks& ranks,
                            const std::function<void()>& checkpoint = {},
                            const std::function<void(double)>& progress = {});

}  // namespace bondstatic
