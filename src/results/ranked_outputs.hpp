// The few numbers of an answer that is spread over the ranks of a run, brought together at rank 0. What is
// here is called by all ranks.
#pragma once

#include <vector>

#include "bondstatic/results.hpp"
#include "model/piece.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

/// evaluate_outputs(), bit for bit, at rank 0; nothing elsewhere. `outputs`, with positions in the whole
/// model, are asked for at rank 0 only; apparent_poisson names its middle, as nobody here has the whole model
/// to choose it from. `solution` is numbered as in the piece; its energy and work are of the whole. What
/// evaluate_outputs() throws is thrown at rank 0; the others return.
std::vector<OutputValue> evaluate_outputs_on_ranks(const std::vector<Output>& outputs, const Piece& piece,
                                                   const StaticSolution& solution, Ranks& ranks);

/// largest_displacements() at rank 0; nothing elsewhere.
std::vector<LargestDisplacement> largest_displacements_on_ranks(const Piece& piece,
                                                                const StaticSolution& solution, Ranks& ranks);

}  // namespace bondstatic
