#include "report/fracture_history.hpp"

#include <fmt/format.h>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

/// The columns that are there whatever the outputs are; these follow.
constexpr int first_output = 18;

void add_avalanches(FractureHistory& history) {
  for (std::size_t e = 0; e < history.events.size(); ++e) {
    const BreakEvent& event = history.events[e];
    if (e == 0 || event.avalanche != history.events[e - 1].avalanche)
      history.avalanches.push_back({e, e, 0, 0});
    BreakAvalanche& avalanche = history.avalanches.back();
    avalanche.last = e;
    avalanche.broken += event.broken;
    avalanche.released += event.released;
  }
}

}  // namespace

Index FractureHistory::broken_after(double steps) const {
  Index broken = 0;
  for (const BreakEvent& event : events)
    if (event.step <= steps) broken += event.broken;
  return broken;
}

FractureHistory read_fracture_history(const std::string& file, const CsvColumns& csv) {
  FractureHistory history;
  const auto number = [&](const char* name) { return csv.numbers(name); };
  const auto step = number("step"), factor = number("factor"), load = number("load"),
             displacement = number("displacement"), runner_up = number("runner_up"),
             released = number("released"), strain = number("strain_energy"), work = number("work"),
             dissipated = number("dissipated"), load_after = number("load_after"),
             displacement_after = number("displacement_after");
  const auto bond = csv.whole_numbers("bond"), a = csv.whole_numbers("a"), b = csv.whole_numbers("b"),
             avalanche = csv.whole_numbers("avalanche");
  const auto mode = csv.texts("mode");
  std::vector<std::vector<double>> outputs;
  for (int column = first_output; column < int(csv.names().size()); ++column) {
    history.outputs.push_back(csv.names()[std::size_t(column)]);
    outputs.push_back(csv.numbers(column));
  }
  for (std::size_t row = 0; row < step.size(); ++row) {
    if (row > 0 && step[row] == step[row - 1]) {
      ++history.events.back().broken;
      continue;
    }
    if (!(row == 0 || step[row] > step[row - 1]))
      throw InputError({{{file, int(row) + 2, 1},
                         fmt::format("step = {} follows {}", step[row], step[row - 1]),
                         "let `bondstatic fracture CASE --out DIR` write it anew"}});
    BreakEvent event{step[row],
                     1,
                     load[row],
                     displacement[row],
                     load_after[row],
                     displacement_after[row],
                     factor[row],
                     runner_up[row],
                     released[row],
                     strain[row],
                     work[row],
                     dissipated[row],
                     avalanche[row],
                     "",
                     {}};
    event.bonds = fmt::format("bond {} ({} to {}){}", bond[row], a[row], b[row],
                              mode[row].empty() ? "" : ", " + mode[row]);
    for (const auto& values : outputs) event.outputs.push_back(values[row]);
    history.events.push_back(std::move(event));
  }
  for (BreakEvent& event : history.events)
    if (event.broken > 1) event.bonds += fmt::format(" and {} more", event.broken - 1);
  add_avalanches(history);
  return history;
}

}  // namespace bondstatic
