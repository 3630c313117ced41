#include <algorithm>

#include "bondstatic/results.hpp"
#include "results/summary_parts.hpp"

namespace bondstatic {

namespace {

Json accuracy_of(const Accuracy& accuracy) {
  return {{"backward_error", accuracy.backward_error}, {"forward_error", accuracy.forward_error},
          {"refinements", accuracy.refinements},       {"pivot_ratio", accuracy.pivot_ratio},
          {"force_balance", accuracy.force_balance},   {"moment_balance", accuracy.moment_balance},
          {"energy_balance", accuracy.energy_balance}};
}

template <class Matrix>
Json rows_of(const Matrix& matrix) {
  Json rows = Json::array();
  for (int i = 0; i < matrix.rows(); ++i) {
    Json row = Json::array();
    for (int j = 0; j < matrix.cols(); ++j) row.push_back(matrix(i, j));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json effective_of(const EffectiveStiffness& effective) {
  return {{"order", {"xx", "yy", "zz", "yz", "xz", "xy"}},
          {"volume", effective.volume},
          {"stiffness", rows_of(effective.stiffness)},
          {"asymmetry", effective.asymmetry},
          {"voigt_bound", rows_of(effective.voigt)},
          {"isotropic",
           {{"young", effective.isotropic.young},
            {"poisson", effective.isotropic.poisson},
            {"misfit", effective.isotropic.misfit}}}};
}

Json load_cases_of(const ModelFacts& model, const StaticSolution& solution,
                   const std::vector<LargestDisplacement>& largest) {
  Json cases = Json::array();
  for (std::size_t c = 0; c < solution.cases.size(); ++c) {
    Json one = state_of(model.load_cases, solution.cases[c], largest[c]);
    one["accuracy"] = accuracy_of(solution.cases[c].accuracy);
    if (!solution.cases[c].stress.hasNaN()) {
      one["strain"] = rows_of(solution.cases[c].strain);
      one["stress"] = rows_of(solution.cases[c].stress);
    }
    cases.push_back(std::move(one));
  }
  return cases;
}

Json phases_of(const StaticReport& report) {
  Json phases = Json::array();
  for (const Phase& phase : report.phases)
    phases.push_back({{"name", phase.name}, {"seconds", phase.seconds}});
  return phases;
}

}  // namespace

Accuracy worst_accuracy(const StaticSolution& solution) {
  Accuracy worst;
  for (const LoadCaseResult& result : solution.cases) {
    const Accuracy& one = result.accuracy;
    worst.backward_error = std::max(worst.backward_error, one.backward_error);
    worst.forward_error = std::max(worst.forward_error, one.forward_error);
    worst.refinements = std::max(worst.refinements, one.refinements);
    worst.pivot_ratio = std::min(worst.pivot_ratio, one.pivot_ratio);
    worst.force_balance = std::max(worst.force_balance, one.force_balance);
    worst.moment_balance = std::max(worst.moment_balance, one.moment_balance);
    worst.energy_balance = std::max(worst.energy_balance, one.energy_balance);
  }
  return worst;
}

std::string summary_json(const ModelFacts& model, const RunInfo& run, const StaticSolution& solution,
                         const std::vector<LargestDisplacement>& largest,
                         const std::vector<OutputValue>& outputs, const std::vector<std::string>& files) {
  const StaticReport& report = solution.report;
  std::vector<std::string> warnings = run.warnings;
  warnings.insert(warnings.end(), report.warnings.begin(), report.warnings.end());
  Json counts = counts_of(model);
  counts["unknowns"] = report.analysis.unknowns;
  Json summary{
      {"title", run.title},
      {"bondstatic", version()},
      {"case", run.file},
      {"units", run.si ? "SI" : "as given"},
      {"counts", counts},
      {"solver", solver_of(report)},
      {"accuracy", accuracy_of(worst_accuracy(solution))},
      {"load_cases", load_cases_of(model, solution, largest)},
      {"outputs", outputs_of(outputs)},
      {"phases", phases_of(report)},
      {"memory", {{"predicted_bytes", report.analysis.predicted_bytes}, {"peak_bytes", report.peak_bytes}}},
      {"dropped", report.dropped},
      {"warnings", warnings},
      {"files", files}};
  if (solution.effective) summary["effective_stiffness"] = effective_of(*solution.effective);
  if (!run.resolution.empty()) summary["resolution"] = resolution_of(run.resolution);
  return to_text(summary);
}

std::string summary_json(const Model& model, const RunInfo& run, const StaticSolution& solution,
                         const std::vector<OutputValue>& outputs, const std::vector<std::string>& files) {
  return summary_json(facts_of(model), run, solution, largest_displacements(model, solution), outputs, files);
}

}  // namespace bondstatic
