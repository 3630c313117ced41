#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "bondstatic/results.hpp"
#include "bondstatic/version.hpp"
#include "results/load_case_folder.hpp"

namespace bondstatic {

namespace {

using Json = nlohmann::ordered_json;

Json counts_of(const Model& model, const StaticReport& report) {
  std::set<Index> supported;
  for (const Support& support : model.supports) supported.insert(support.particle);
  Json laws = Json::object();
  for (const BondBlock& block : model.blocks) laws[block.law] = 0;
  for (const Bond& bond : model.bonds) {
    Json& count = laws[model.blocks[std::size_t(bond.block)].law];
    count = count.get<Index>() + 1;
  }
  return {{"particles", model.particles.size()},
          {"bonds", model.bonds.size()},
          {"bonds_by_law", laws},
          {"supported_particles", supported.size()},
          {"load_cases", model.load_cases.size()},
          {"unknowns", report.analysis.unknowns}};
}

Json solver_of(const StaticReport& report) {
  return {{"name", report.solver},
          {"threads", report.threads},
          {"threads_asked", report.threads_asked},
          {"ordering", report.analysis.ordering},
          {"unknowns", report.analysis.unknowns},
          {"matrix_entries", report.analysis.matrix_entries},
          {"factor_entries", report.analysis.factor_entries},
          {"factor_flops", report.analysis.factor_flops},
          {"factorisations", report.factorisations}};
}

Json accuracy_of(const Accuracy& accuracy) {
  return {{"backward_error", accuracy.backward_error}, {"forward_error", accuracy.forward_error},
          {"refinements", accuracy.refinements},       {"pivot_ratio", accuracy.pivot_ratio},
          {"force_balance", accuracy.force_balance},   {"moment_balance", accuracy.moment_balance},
          {"energy_balance", accuracy.energy_balance}};
}

Json load_cases_of(const Model& model, const StaticSolution& solution) {
  Json cases = Json::array();
  for (const LoadCaseResult& result : solution.cases) {
    Json one{{"name", result.name},
             {"folder", load_case_folder(model, result.name)},
             {"energy", result.energy},
             {"work", result.work}};
    if (const LargestDisplacement largest = largest_displacement(result); largest.particle >= 0) {
      const Vector3& u = largest.displacement;
      one["largest_displacement"] = {{"particle", model.particles[std::size_t(largest.particle)].id},
                                     {"magnitude", u.stableNorm()},
                                     {"components", {u.x(), u.y(), u.z()}}};
    }
    one["accuracy"] = accuracy_of(result.accuracy);
    cases.push_back(std::move(one));
  }
  return cases;
}

Json outputs_of(const std::vector<OutputValue>& outputs) {
  Json all = Json::array();
  for (const OutputValue& output : outputs) {
    Json one{{"name", output.name}, {"value", output.value}};
    if (output.expected) {
      one["expected"] = *output.expected;
      one["relative_error"] = output.relative_error();
      one["tolerance"] = output.tolerance;
    }
    if (!output.source.empty()) one["source"] = output.source;
    all.push_back(std::move(one));
  }
  return all;
}

Json phases_of(const StaticReport& report) {
  Json phases = Json::array();
  for (const Phase& phase : report.phases)
    phases.push_back({{"name", phase.name}, {"seconds", phase.seconds}});
  return phases;
}

/// By particle ids: positions mean nothing outside.
Json dropped_of(const Model& model, const StaticReport& report) {
  Json bodies = Json::array();
  for (const std::vector<Index>& body : report.dropped) {
    Json ids = Json::array();
    for (const Index p : body) ids.push_back(model.particles[std::size_t(p)].id);
    bodies.push_back(std::move(ids));
  }
  return bodies;
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

LargestDisplacement largest_displacement(const State& state) {
  LargestDisplacement largest;
  double most = -1;
  for (std::size_t i = 0; i < state.displacement.size(); ++i) {
    const double magnitude = state.displacement[i].head<3>().stableNorm();
    if (!(magnitude > most)) continue;  // nor where it is NaN
    most = magnitude;
    largest = {Index(i), state.displacement[i].head<3>()};
  }
  return largest;
}

std::string summary_json(const Model& model, const RunInfo& run, const StaticSolution& solution,
                         const std::vector<OutputValue>& outputs, const std::vector<std::string>& files) {
  const StaticReport& report = solution.report;
  std::vector<std::string> warnings = run.warnings;
  warnings.insert(warnings.end(), report.warnings.begin(), report.warnings.end());
  const Json summary{
      {"title", run.title},
      {"bondstatic", version()},
      {"case", run.file},
      {"units", run.si ? "SI" : "as given"},
      {"counts", counts_of(model, report)},
      {"solver", solver_of(report)},
      {"accuracy", accuracy_of(worst_accuracy(solution))},
      {"load_cases", load_cases_of(model, solution)},
      {"outputs", outputs_of(outputs)},
      {"phases", phases_of(report)},
      {"memory", {{"predicted_bytes", report.analysis.predicted_bytes}, {"peak_bytes", report.peak_bytes}}},
      {"dropped", dropped_of(model, report)},
      {"warnings", warnings},
      {"files", files}};
  // Titles may hold bytes that are no UTF-8; they become U+FFFD, and the rest is still told.
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace bondstatic
