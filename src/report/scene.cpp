#include "report/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/force_plots.hpp"
#include "report/scene_reader.hpp"

namespace bondstatic {

namespace {

using Of = Grid::Of;

/// Load cases whose forces are plotted.
constexpr std::size_t most_plotted = 4;

/// "1,000,188"
std::string grouped(Index count) {
  std::string text = std::to_string(count);
  for (Index at = Index(text.size()) - 3; at > 0; at -= 3) text.insert(std::size_t(at), 1, ',');
  return text;
}

/// How many of so many, evenly spaced: the last one, from two on with the first.
void choose(std::vector<bool>& chosen, const std::vector<std::size_t>& from, std::size_t kept) {
  if (kept == 1) chosen[from.back()] = true;
  for (std::size_t i = 0; kept > 1 && i < kept; ++i)
    chosen[from[(i * (from.size() - 1) + (kept - 1) / 2) / (kept - 1)]] = true;
}

/// The last state of each load case, or of some where these are too many already; and of those before, as
/// many as there is room for.
std::vector<bool> chosen_states(const std::vector<SceneState>& states, double per_state,
                                const SceneLimits& limits) {
  const std::size_t count = states.size();
  const double room = std::max(2.0, std::floor(double(limits.numbers) / std::max(1.0, per_state)));
  if (double(count) <= room) return std::vector<bool>(count, true);
  const auto most = std::size_t(room);
  std::vector<std::vector<std::size_t>> cases;
  std::vector<std::size_t> last;
  for (std::size_t s = 0; s < count; ++s) {
    if (s == 0 || states[s].load_case != states[s - 1].load_case) cases.emplace_back();
    cases.back().push_back(s);
  }
  for (const auto& one : cases) last.push_back(one.back());
  std::vector<bool> chosen(count);
  if (cases.size() > most) choose(chosen, last, most);
  if (cases.size() > most) return chosen;
  const std::size_t more = most - cases.size(), before = count - cases.size();
  for (const auto& one : cases) choose(chosen, one, 1 + more * (one.size() - 1) / before);
  return chosen;
}

/// The last state of each load case, of the first few.
std::vector<bool> plotted_states(const std::vector<SceneState>& states, std::vector<std::string>& notes) {
  std::vector<bool> plotted(states.size());
  std::size_t cases = 0;
  for (std::size_t s = 0; s < states.size(); ++s) {
    if (s + 1 < states.size() && states[s + 1].load_case == states[s].load_case) continue;
    plotted[s] = ++cases <= most_plotted;
  }
  if (cases > most_plotted)
    notes.push_back(fmt::format("The forces of bonds are plotted for the first {} of {} load cases.",
                                most_plotted, cases));
  return plotted;
}

void note_what_is_left_out(const Sample& sample, std::size_t shown, std::size_t states,
                           std::vector<std::string>& notes) {
  if (sample.drawn < sample.all_particles || Index(sample.lines.size()) < sample.all_bonds)
    notes.push_back(fmt::format(
        "The scene shows {} of {} particles and {} of {} bonds, chosen by their ids, always the same "
        "ones. Plots and tables are of all.",
        grouped(sample.drawn), grouped(sample.all_particles), grouped(Index(sample.lines.size())),
        grouped(sample.all_bonds)));
  if (shown < states)
    notes.push_back(fmt::format(
        "The scene shows {} of {} states, evenly spaced: with all of them the file would be too large.",
        shown, states));
}

}  // namespace

std::optional<PageScene> read_scene(const std::vector<SceneState>& states, bool si, const SceneLimits& limits,
                                    Blocks& blocks, std::vector<std::string>& notes,
                                    std::vector<PagePlot>& plots) {
  if (states.empty()) return std::nullopt;
  const std::vector<bool> plotted = plotted_states(states, notes);
  const bool several = states.front().load_case != states.back().load_case;
  std::optional<SceneReader> reader;
  std::vector<bool> chosen{true};
  bool with_directions = true;  // which load cases share
  for (std::size_t s = 0; s < states.size(); ++s) {
    if (s > 0 && !chosen[s] && !plotted[s]) continue;
    const Grid grid(states[s].files);
    if (s == 0) {
      if (grid.count(Of::points) == 0) return std::nullopt;
      reader.emplace(grid, si, limits, blocks);
      chosen = chosen_states(states, reader->numbers_of(grid), limits);
    }
    if (chosen[s]) reader->add(grid, states[s]);
    if (!plotted[s]) continue;
    add_force_plots(grid, several ? states[s].load_case : "", with_directions, si, plots);
    with_directions = false;
  }
  note_what_is_left_out(reader->sample(), std::size_t(std::count(chosen.begin(), chosen.end(), true)),
                        states.size(), notes);
  return reader->finish();
}

}  // namespace bondstatic
