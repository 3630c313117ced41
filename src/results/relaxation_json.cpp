#include "bondstatic/results.hpp"
#include "results/relaxation_parts.hpp"

namespace bondstatic {

std::string relaxation_json(const Model& model, const RunInfo& run, const Relaxation& relaxation,
                            const std::vector<OutputValue>& outputs, const std::vector<std::string>& files) {
  Json cases = Json::array();
  for (const RelaxedCase& relaxed : relaxation.cases) cases.push_back(relaxed_case_of(model, relaxed));
  std::vector<std::string> warnings = run.warnings;
  warnings.insert(warnings.end(), relaxation.warnings.begin(), relaxation.warnings.end());
  return to_text(Json{{"title", run.title},
                      {"bondstatic", version()},
                      {"case", run.file},
                      {"units", run.si ? "SI" : "as given"},
                      {"counts", counts_of(facts_of(model))},
                      {"at_rest", relaxation.at_rest()},
                      {"threads", relaxation.threads},
                      {"planning_seconds", relaxation.planning_seconds},
                      {"load_cases", cases},
                      {"outputs", outputs_of(outputs)},
                      {"dropped", relaxation.dropped},
                      {"warnings", warnings},
                      {"files", files}});
}

}  // namespace bondstatic
