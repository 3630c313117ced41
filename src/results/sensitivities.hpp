// How outputs change with the parameters of the bonds' laws.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/output.hpp"
#include "bondstatic/sensitivity.hpp"
#include "io/file_set.hpp"

namespace bondstatic {

/// Parameters that outputs can be differentiated by: numbers of the laws, given to some bond, block by block.
std::vector<BlockParameter> differentiable_parameters(const Model& model);

/// Fills in OutputValue::sensitivities to all of them, of the last solve of `analysis`, whose answer
/// `solution` is and whose outputs `values` are. Returns, as warnings, which outputs have no derivative and
/// why.
std::vector<std::string> add_sensitivities(std::vector<OutputValue>& values,
                                           const std::vector<Output>& outputs, const Model& model,
                                           const StaticSolution& solution, StaticAnalysis& analysis,
                                           bool by_bond, int threads);

inline constexpr const char* sensitivity_table = "sensitivities.csv";
inline constexpr const char* bond_sensitivity_table = "bond_sensitivities.csv";

/// Those of the two that outputs have something for:
///
///     sensitivities.csv       output, block, law, parameter, value, derivative, elasticity: a row each
///     bond_sensitivities.csv  id, a, b, then "OUTPUT per PARAMETER" for each, by bond
std::vector<std::string> sensitivity_files(const std::vector<OutputValue>& outputs);
void write_sensitivities(FileSet& files, const Model& model, const std::vector<OutputValue>& outputs);

}  // namespace bondstatic
