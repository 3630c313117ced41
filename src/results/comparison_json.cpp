#include "results/comparison.hpp"
#include "results/summary_parts.hpp"

namespace bondstatic {

namespace {

Json numbers(const Vector6& v) {
  return Json(std::vector<double>(v.begin(), v.end()));
}

Json place_of(const Model& model, const FieldComparison& field) {
  if (field.at < 0) return nullptr;
  const auto at = std::size_t(field.at);
  return field.of_bond ? Json{{"bond", model.bonds[at].id}} : Json{{"particle", model.particles[at].id}};
}

/// NaN, where a run does not tell, becomes null.
Json field_of(const Model& model, const FieldComparison& field) {
  return {{"field", field.field},          {"static_norm", field.static_norm},
          {"run_norm", field.run_norm},    {"difference", field.difference},
          {"largest", field.largest},      {"largest_at", place_of(model, field)},
          {"best_fit_scale", field.scale}, {"misfit_after_scaling", field.misfit}};
}

Json unbalance_of(const Unbalance& unbalance) {
  Json all = Json::object();
  for (const auto& [name, number] : numbers_of(unbalance)) all[name] = number;
  return all;
}

Json suspect_of(const Suspect& suspect) {
  return {
      {"what", suspect.what}, {"text", suspect.text}, {"factors", suspect.factors}, {"left", suspect.left}};
}

Json step_of(const Model& model, const Comparison& c) {
  Json fields = Json::array(), worst = Json::array(), suspects = Json::array();
  for (const FieldComparison& field : c.fields) fields.push_back(field_of(model, field));
  for (const WorstParticle& one : c.worst)
    worst.push_back({{"particle", model.particles[std::size_t(one.particle)].id},
                     {"static", numbers(one.statics)},
                     {"run", numbers(one.run)}});
  for (const Suspect& suspect : c.suspects) suspects.push_back(suspect_of(suspect));
  return {{"run", c.run},
          {"step", c.step},
          {"load_case", c.load_case},
          {"verdict", name_of(c.verdict)},
          {"reason", c.reason},
          {"tolerance", c.tolerance},
          {"fields", fields},
          {"state", unbalance_of(c.unbalance)},
          {"suspects", suspects},
          {"worst", worst},
          {"matched_particles", c.matched},
          {"missing_in_run", c.missing},
          {"unknown_to_case", c.unknown},
          {"notes", c.notes}};
}

Json series_of(const std::vector<Comparison>& steps) {
  Json all = Json::array();
  for (const Comparison& c : steps) {
    Json one{{"step", c.step}};
    for (const FieldComparison& field : c.fields) one[field.field] = field.difference;
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

std::vector<std::pair<const char*, double>> numbers_of(const Unbalance& u) {
  return {{"residual_linear", u.linear},
          {"residual_finite", u.finite},
          {"motion_left", u.still_moves},
          {"kinetic_over_strain_energy", u.kinetic},
          {"fastest_particle", u.fastest},
          {"net_force", u.net_force},
          {"confirmed_by_net_force", u.moving_part},
          {"in_slowest_modes", u.slow_modes}};
}

std::string comparison_json(const ComparisonResults& results, const RunInfo& info,
                            const std::vector<std::string>& files) {
  std::vector<std::string> warnings = info.warnings;
  warnings.insert(warnings.end(), results.solved.warnings.begin(), results.solved.warnings.end());
  Json json{{"title", info.title},
            {"bondstatic", version()},
            {"case", info.file},
            {"units", info.si ? "SI" : "as given"},
            {"counts", counts_of(facts_of(results.model))},
            {"solver", results.solved.solver},
            {"comparison", step_of(results.model, results.steps.back())}};
  if (results.steps.size() > 1) json["series"] = series_of(results.steps);
  json["dropped"] = results.solved.dropped;
  json["warnings"] = warnings;
  json["files"] = files;
  return to_text(json);
}

}  // namespace bondstatic
