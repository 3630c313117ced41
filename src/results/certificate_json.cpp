#include "bondstatic/results.hpp"
#include "results/relaxation_parts.hpp"

namespace bondstatic {

namespace {

Json place_of(const Model& model, const Worst& worst) {
  if (worst.at < 0) return nullptr;
  const auto at = std::size_t(worst.at);
  return worst.of_bond ? Json{{"bond", model.bonds[at].id}} : Json{{"particle", model.particles[at].id}};
}

/// NaN, where an order was not told apart, becomes null.
Json field_of(const Model& model, const FieldDifference& field) {
  return {{"field", field.field},
          {"largest", field.largest},
          {"norm", field.norm},
          {"largest_at", place_of(model, field.worst)},
          {"first_order", field.first_order},
          {"second_order", field.second_order},
          {"third_order", field.third_order}};
}

Json case_of(const Model& model, const CaseCertificate& one) {
  Json fields = Json::array();
  for (const FieldDifference& field : one.fields) fields.push_back(field_of(model, field));
  return {{"name", one.name},
          {"agrees", one.agrees},
          {"differences", fields},
          {"static",
           {{"forward_error", one.statics.forward_error},
            {"backward_error", one.statics.backward_error},
            {"energy_balance", one.statics.energy_balance}}},
          {"run", relaxed_case_of(model, one.run)}};
}

}  // namespace

std::string certificate_json(const Model& model, const RunInfo& run, const Certificate& certificate) {
  Json cases = Json::array();
  for (const CaseCertificate& one : certificate.cases) cases.push_back(case_of(model, one));
  std::vector<std::string> warnings = run.warnings;
  warnings.insert(warnings.end(), certificate.warnings.begin(), certificate.warnings.end());
  return to_text(Json{{"title", run.title},
                      {"bondstatic", version()},
                      {"case", run.file},
                      {"units", run.si ? "SI" : "as given"},
                      {"counts", counts_of(facts_of(model))},
                      {"kinematics", certificate.kinematics == Kinematics::finite ? "finite" : "small"},
                      {"tolerance", certificate.tolerance},
                      {"agrees", certificate.agrees()},
                      {"load_cases", cases},
                      {"static_seconds", certificate.static_seconds},
                      {"dynamic_seconds", certificate.dynamic_seconds},
                      {"ratio", certificate.dynamic_seconds / certificate.static_seconds},
                      {"warnings", warnings}});
}

}  // namespace bondstatic
