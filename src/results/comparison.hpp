// A comparison as files: summary.json, particles.csv, bonds.csv, model.vtu, case.resolved.toml; of a series
// also steps.csv.
//
// particles.csv: id, x, y, z, radius, ux ... rz (static), run_ux ... run_rz, difference_ux ... (run less
// static).
//
// bonds.csv: as of a solve, run_fx ... run_mz, difference_fx ...; only where the run tells forces of bonds.
//
// model.vtu: the fields of a solve, run_displacement, run_rotation, displacement_difference,
// rotation_difference on points, the columns of bonds.csv on lines.
//
// steps.csv: step; displacement, rotation, energy (differences, relative), scale, kinetic, residual.
//
// What the run does not tell is an empty field, NaN in model.vtu.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bondstatic/compare.hpp"
#include "bondstatic/results.hpp"

namespace bondstatic {

/// All that the files tell.
struct ComparisonResults {
  const Model& model;
  const State& statics;
  const RunState& run;  ///< of the last step
  const StaticReport& solved;
  const std::vector<Comparison>& steps;  ///< one where no series was asked for; the last one is explained
};

std::vector<std::string> comparison_files(const ComparisonResults& results);

/// The numbers of an Unbalance, and what summary.json calls them.
std::vector<std::pair<const char*, double>> numbers_of(const Unbalance& unbalance);

/// summary.json; `files` is what it lists.
std::string comparison_json(const ComparisonResults& results, const RunInfo& info,
                            const std::vector<std::string>& files);

/// Throws Error (invalid_input) where the files could not be written; worth calling before the solve.
void check_comparison_folder(const std::string& folder, bool with_bonds, bool with_steps);

/// Whole or not at all, as write_results().
void write_comparison(const ComparisonResults& results, const RunInfo& info, const std::string& folder,
                      const std::function<void()>& checkpoint = {});

}  // namespace bondstatic
