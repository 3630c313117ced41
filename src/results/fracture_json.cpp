#include <set>

#include "bondstatic/results.hpp"
#include "results/fracture_words.hpp"
#include "results/summary_parts.hpp"

namespace bondstatic {

namespace {

Json bonds_of(const Model& model, const FractureEvent& event) {
  Json bonds = Json::array();
  for (const BrokenBond& broken : event.bonds) {
    const Bond& bond = model.bonds[std::size_t(broken.bond)];
    bonds.push_back({{"bond", bond.id},
                     {"a", model.particles[std::size_t(bond.a)].id},
                     {"b", model.particles[std::size_t(bond.b)].id},
                     {"mode", mode_name(model, broken)}});
  }
  return bonds;
}

Json breaking_point(const Model& model, const Fracture& fracture, const FractureEvent* event) {
  if (!event) return nullptr;
  return {{"step", event - fracture.events.data() + 1},
          {"factor", event->factor},
          {"load", event->load},
          {"displacement", event->displacement},
          {"bonds", bonds_of(model, *event)}};
}

/// What load and displacement are of this pattern.
Json curve_of(const Model& model, const FractureOptions& asked) {
  const FractureWords words = fracture_words(model, asked);
  return {{"load", words.load},
          {"load_unit", words.load_unit},
          {"displacement", words.displacement},
          {"displacement_unit", words.displacement_unit}};
}

Json separated_of(const Fracture& fracture) {
  Json bodies = Json::array();
  for (const SeparatedBody& body : fracture.separated)
    bodies.push_back({{"after_step", body.event + 1}, {"particles", body.particles}});
  return bodies;
}

Json energies_of(const Fracture& fracture) {
  const FractureEvent *last = last_standing(fracture), none;
  if (!last) last = &none;
  return {{"strain", last->strain_energy},
          {"work", last->work},
          {"dissipated", last->dissipated},
          {"balance", fracture.report.energy_balance}};
}

Json last_of(const Model& model, const Fracture& fracture) {
  Json last = state_of({""}, fracture.last, largest_displacement(model, fracture.last));
  last.erase("name");
  last.erase("folder");
  if (fracture.events.empty()) return last;
  const FractureEvent& event = fracture.events.back();
  last["factor"] = event.factor_after;
  last["load"] = event.load_after;
  last["displacement"] = event.displacement_after;
  return last;
}

}  // namespace

std::string fracture_json(const Model& model, const RunInfo& run, const FractureOptions& asked,
                          const Fracture& fracture, const std::vector<OutputValue>& outputs,
                          const std::vector<std::string>& files) {
  const FractureReport& report = fracture.report;
  std::set<Index> avalanches;
  for (const FractureEvent& event : fracture.events) avalanches.insert(event.avalanche);
  std::vector<std::string> warnings = run.warnings;
  for (const auto* more : {&report.first.warnings, &fracture.warnings})
    warnings.insert(warnings.end(), more->begin(), more->end());
  const auto name_of_case = [&](Index load_case) -> Json {
    return load_case < 0 ? Json() : Json(model.load_cases[std::size_t(load_case)]);
  };
  const FractureEvent* first = fracture.events.empty() ? nullptr : &fracture.events.front();
  Json solver = solver_of(report.first);
  solver["factorisations"] = report.factorisations;
  solver["analyses"] = report.analyses;
  return to_text(
      Json{{"title", run.title},
           {"bondstatic", version()},
           {"case", run.file},
           {"units", run.si ? "SI" : "as given"},
           {"counts", counts_of(facts_of(model))},
           {"control", name_of(asked.control)},
           {"pattern", name_of_case(asked.pattern)},
           {"preload", name_of_case(asked.preload)},
           {"curve", curve_of(model, asked)},
           {"end", name_of(fracture.end)},
           {"reason", fracture.reason},
           {"events", fracture.events.size()},
           {"breaks", count_breaks(fracture)},
           {"avalanches", avalanches.size()},
           {"breaks_by_mode", breaks_by_mode(model, fracture)},
           {"first_break", breaking_point(model, fracture, first)},
           {"peak", breaking_point(model, fracture, peak_of(fracture))},
           {"last", last_of(model, fracture)},
           {"energies", energies_of(fracture)},
           {"accuracy", {{"backward_error", report.backward_error}, {"forward_error", report.forward_error}}},
           {"separated", separated_of(fracture)},
           {"solver", solver},
           {"seconds", report.seconds},
           {"outputs", outputs_of(outputs)},
           {"dropped", report.first.dropped},
           {"warnings", warnings},
           {"files", files}});
}

}  // namespace bondstatic
