#include "results/summary_parts.hpp"

#include "results/load_case_folder.hpp"

namespace bondstatic {

Json counts_of(const ModelFacts& model) {
  Json laws = Json::object();
  for (const auto& [law, bonds] : model.bonds_by_law) laws[law] = bonds;
  return {{"particles", model.particles},
          {"bonds", model.bonds},
          {"bonds_by_law", laws},
          {"supported_particles", model.supported_particles},
          {"load_cases", model.load_cases.size()}};
}

namespace {

Json sensitivities_of(const std::vector<ParameterSensitivity>& sensitivities) {
  Json all = Json::array();
  for (const ParameterSensitivity& one : sensitivities)
    all.push_back({{"block", one.block},
                   {"parameter", one.parameter},
                   {"value", one.value},
                   {"derivative", one.derivative},
                   {"elasticity", one.elasticity}});
  return all;
}

}  // namespace

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
    if (!output.sensitivities.empty()) one["sensitivities"] = sensitivities_of(output.sensitivities);
    all.push_back(std::move(one));
  }
  return all;
}

Json solver_of(const StaticReport& report) {
  return {{"name", report.solver},
          {"reason", report.solver_reason},
          {"iterations", report.iterations},
          {"threads", report.threads},
          {"threads_asked", report.threads_asked},
          {"ordering", report.analysis.ordering},
          {"unknowns", report.analysis.unknowns},
          {"matrix_entries", report.analysis.matrix_entries},
          {"factor_entries", report.analysis.factor_entries},
          {"factor_flops", report.analysis.factor_flops},
          {"factorisations", report.factorisations}};
}

Json state_of(const std::vector<std::string>& load_cases, const State& state,
              const LargestDisplacement& largest) {
  Json one{{"name", state.name},
           {"folder", load_case_folder(load_cases, state.name)},
           {"energy", state.energy},
           {"work", state.work}};
  if (largest.particle) {
    const Vector3& u = largest.displacement;
    one["largest_displacement"] = {{"particle", *largest.particle},
                                   {"magnitude", u.stableNorm()},
                                   {"components", {u.x(), u.y(), u.z()}}};
  }
  return one;
}

std::string to_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace bondstatic
