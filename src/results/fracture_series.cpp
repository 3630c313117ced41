#include "results/fracture_series.hpp"

#include <algorithm>
#include <filesystem>

#include "results/bond_utilisation.hpp"
#include "results/grid.hpp"

namespace bondstatic {

std::vector<Column> fracture_columns(const Model& model, const State& state,
                                     const std::vector<Index>& break_event) {
  std::vector<Index> steps;
  steps.reserve(break_event.size());
  for (const Index event : break_event) steps.push_back(event + 1);
  return {{"break_step", std::move(steps)}, {"utilisation", bond_utilisations(model, state, break_event)}};
}

StateSeries fracture_series(const FractureRecord& record, const std::string& folder) {
  StateSeries series{fracture_kind, std::filesystem::path(folder) / unfinished_folder(fracture_kind)};
  for (const Index events : record.states) series.states.push_back({events, double(events)});
  return series;
}

void show_fracture(const Model& model, const State& state, const std::vector<Index>& break_event,
                   FractureRecord& record, const std::string& folder) {
  const Index events = 1 + *std::max_element(break_event.begin(), break_event.end());
  auto& states = record.states;
  const auto place = std::lower_bound(states.begin(), states.end(), events);
  if (place == states.end() || *place != events) states.insert(place, events);
  add_state(fracture_series(record, folder), events, [&](OutputFile& file) {
    write_grid(file, model, state, {}, fracture_columns(model, state, break_event));
  });
}

}  // namespace bondstatic
