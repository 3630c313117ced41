#include <cmath>
#include <nlohmann/json.hpp>

#include "app/translate_report.hpp"

namespace bondstatic {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has neither infinity nor NaN.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_of(const Model& model, const BlockFit& fit, std::size_t block, const BondCode& code) {
  Json stored = Json::object(), misfit = Json::object();
  for (std::size_t p = 0; p < fit.lowest.size(); ++p)
    stored[code.stored[p].name] = {{"lowest", number(fit.lowest[p])}, {"highest", number(fit.highest[p])}};
  const char* names[] = {"kn", "ks", "kt", "kb"};
  for (std::size_t i = 0; i < fit.misfit.size(); ++i) misfit[names[i]] = number(fit.misfit[i]);
  return {{"block", block},
          {"law", model.blocks[block].law},
          {"bonds", fit.bonds},
          {"stored", stored},
          {"misfit", misfit},
          {"coupling_lost", fit.coupled},
          {"contact_point_moved", fit.moved},
          {"departing", fit.departing},
          {"departure", fit.departure}};
}

Json json_of(const Model& model, const FieldDifference& difference) {
  Json out{{"norm", number(difference.norm)}, {"largest", number(difference.largest)}};
  const Worst& worst = difference.worst;
  if (worst.at >= 0)
    out[worst.of_bond ? "bond" : "particle"] =
        worst.of_bond ? model.bonds[std::size_t(worst.at)].id : model.particles[std::size_t(worst.at)].id;
  return out;
}

Json cases_of(const Model& model, const TranslationEffects& effects) {
  Json cases = Json::array();
  for (std::size_t c = 0; c < effects.load_cases.size(); ++c) {
    Json fields = Json::array();
    for (std::size_t f = 0; f < effects.both.fields[c].size(); ++f)
      fields.push_back({{"field", effects.both.fields[c][f].field},
                        {"contact_point", json_of(model, effects.contact_point.fields[c][f])},
                        {"stiffness", json_of(model, effects.stiffness.fields[c][f])},
                        {"both", json_of(model, effects.both.fields[c][f])}});
    cases.push_back({{"name", effects.load_cases[c]}, {"fields", fields}});
  }
  return cases;
}

}  // namespace

std::string translation_json(const Case& given, const Translation& translation,
                             const std::vector<BlockFit>& fits,
                             const std::optional<TranslationEffects>& effects) {
  const BondCode& code = *translation.code;
  Json blocks = Json::array(), outputs = Json::array();
  for (std::size_t b = 0; b < fits.size(); ++b)
    if (fits[b].bonds > 0) blocks.push_back(json_of(given.model, fits[b], b, code));
  Json out{{"title", given.title},
           {"case", given.file},
           {"code", code.name},
           {"version", code.version},
           {"rule", code.fit},
           {"contact_point", code.contact_point_text},
           {"contact_point_known_from", code.known_from},
           {"blocks", blocks}};
  if (effects) {
    for (std::size_t i = 0; i < effects->outputs.size(); ++i)
      outputs.push_back({{"name", effects->outputs[i].name},
                         {"value", number(effects->outputs[i].value)},
                         {"contact_point", number(effects->contact_point.outputs[i].value)},
                         {"stiffness", number(effects->stiffness.outputs[i].value)},
                         {"both", number(effects->both.outputs[i].value)}});
    out["load_cases"] = cases_of(given.model, *effects);
    out["outputs"] = outputs;
  }
  out["warnings"] = given.warnings;
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bondstatic
