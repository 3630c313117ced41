#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "report/facts_tables.hpp"
#include "report/found_states.hpp"
#include "report/fracture_plots.hpp"
#include "report/output_plots.hpp"
#include "report/page_parts.hpp"
#include "report/pages.hpp"
#include "results/fracture_series.hpp"

namespace bondstatic {

namespace {

/// Earlier versions do not say whether a pattern pushes or turns: no units then.
CurveWords words_of(const JsonValue& summary) {
  const JsonValue curve = summary["curve"];
  return {curve["load"].text_or("load"), curve["load_unit"].text_or(),
          curve["displacement"].text_or("displacement"), curve["displacement_unit"].text_or()};
}

void put_point(Facts& facts, const std::string& name, const JsonValue& point, const CurveWords& words,
               const PageUnits& units) {
  if (!point.there()) return;
  std::string bonds;
  constexpr std::size_t most = 4;
  const std::vector<JsonValue> all = point["bonds"].items();
  for (std::size_t i = 0; i < std::min(most, all.size()); ++i) {
    const std::string mode = all[i]["mode"].text_or();
    bonds += fmt::format("{}{}{}", i == 0 ? "" : ", ", place_text(all[i]).value_or("bond"),
                         mode.empty() ? "" : " by " + mode);
  }
  if (all.size() > most) bonds += fmt::format(" and {} more", all.size() - most);
  facts.add(name + ": event", point["step"].number())
      .add(units.in(name + ": " + words.load, words.load_unit), point["load"].number())
      .add(units.in(name + ": " + words.displacement, words.displacement_unit),
           point["displacement"].number())
      .add(name + ": factor on the pattern", point["factor"].number())
      .add(name + ": broke", bonds);
}

void put_outcome(PageRun& run, const JsonValue& summary, const CurveWords& words, const PageUnits& units) {
  Facts facts("What broke");
  put_point(facts, "first break", summary["first_break"], words, units);
  put_point(facts, "peak", summary["peak"], words, units);
  std::string modes;
  for (const auto& [mode, count] : summary["breaks_by_mode"].members())
    if (const auto number = count.number(); number && !mode.empty())
      modes += fmt::format("{}{} by {}", modes.empty() ? "" : ", ", *number, mode);
  facts.add("end", summary["end"].text())
      .add("because", summary["reason"].text())
      .add("broken bonds", summary["breaks"].number())
      .add("modes", modes)
      .add("events", summary["events"].number())
      .add("avalanches", summary["avalanches"].number())
      .add("what never falls", summary["control"].text())
      .add("load case that scales", summary["pattern"].text())
      .add("load case that stays", summary["preload"].text());
  std::move(facts).put_into(run.tables);
}

void put_end(PageRun& run, const JsonValue& summary, const CurveWords& words, const PageUnits& units) {
  const JsonValue last = summary["last"], largest = last["largest_displacement"];
  Facts facts("State at the end");
  facts.add(units.in(words.load, words.load_unit), last["load"].number())
      .add(units.in(words.displacement, words.displacement_unit), last["displacement"].number())
      .add("factor on the pattern", last["factor"].number())
      .add(units.in("largest displacement", "m"), largest["magnitude"].number())
      .add("at", place_text(largest));
  std::move(facts).put_into(run.tables);
  const JsonValue energies = summary["energies"];
  Facts energy("Energies");
  energy.add(units.in("work", "J"), energies["work"].number())
      .add(units.in("strain energy", "J"), energies["strain"].number())
      .add(units.in("dissipated", "J"), energies["dissipated"].number())
      .add("balance, over the largest", energies["balance"].number());
  std::move(energy).put_into(run.tables);
}

void put_avalanche_table(PageRun& run, const FractureHistory& history, const CurveWords& words,
                         const PageUnits& units) {
  constexpr std::size_t most = 20;
  PageTable table{
      "Largest avalanches",
      {"avalanche", "bonds", "first event", "last event", units.in(words.load + " before", words.load_unit),
       units.in(words.load + " after", words.load_unit), units.in("released energy", "J")},
      {}};
  std::vector<BreakAvalanche> all = history.avalanches;
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.broken > b.broken; });
  for (std::size_t i = 0; i < std::min(most, all.size()); ++i) {
    const BreakEvent &first = history.events[all[i].first], &last = history.events[all[i].last];
    table.rows.push_back({double(first.avalanche), double(all[i].broken), first.step, last.step, first.load,
                          last.load_after, all[i].released});
  }
  if (all.size() > most) table.note = fmt::format("The first {} of {}.", most, all.size());
  put_table(run.tables, std::move(table));
}

void put_separated(PageRun& run, const JsonValue& summary) {
  constexpr std::size_t most = 50;
  PageTable table{"What came apart", {"after event", "particles", "ids"}, {}};
  const std::vector<JsonValue> bodies = summary["separated"].items();
  for (std::size_t i = 0; i < std::min(most, bodies.size()); ++i)
    table.rows.push_back({field(bodies[i]["after_step"].number()),
                          double(bodies[i]["particles"].items().size()), id_text(bodies[i]["particles"])});
  if (bodies.size() > most) table.note = fmt::format("The first {} of {} bodies.", most, bodies.size());
  put_table(run.tables, std::move(table));
}

/// Where a state stands on the curve: with the bonds of the last event gone; before the first, at its load.
std::string label_of(double steps, const FractureHistory& history, const CurveWords& words,
                     const PageUnits& units) {
  std::string label = fmt::format("{} broken", history.broken_after(steps));
  const auto after = std::find_if(history.events.begin(), history.events.end(),
                                  [&](const BreakEvent& event) { return event.step == steps; });
  double load = std::nan("");
  if (after != history.events.end()) load = after->load_after;
  if (steps == 0 && !history.events.empty()) load = history.events.front().load;
  if (std::isnan(load)) return label;
  const std::string unit = units.of(words.load_unit);
  return label + fmt::format(", {} {:.4g}{}", words.load, load, unit.empty() ? "" : " " + unit);
}

std::vector<SceneState> states_of(PageRun& run, const std::string& folder, const JsonValue& summary,
                                  const FractureHistory& history, const CurveWords& words,
                                  const PageUnits& units) {
  const std::string load_case = summary["pattern"].text_or();
  const double events = summary["events"].number().value_or(0);
  std::vector<SceneState> states;
  if (events > 0)
    for (const ShownState& shown : shown_states(folder, fracture_kind, run))
      states.push_back({{shown.file}, load_case, label_of(shown.time, history, words, units), shown.time});
  if (!states.empty() && *states.back().step >= events) return states;
  std::vector<std::string> files = grid_files(folder, run);
  if (!files.empty())
    states.push_back({std::move(files), load_case, label_of(events, history, words, units), events});
  return states;
}

}  // namespace

FoundRun fracture_page(const std::string& folder, const JsonValue& summary) {
  FoundRun found;
  PageRun& run = found.page;
  run.kind = "fracture";
  const PageUnits units = units_of(summary);
  found.si = units.si;
  put_heading(run, summary);
  const CurveWords words = words_of(summary);
  put_outcome(run, summary, words, units);
  const std::string file = (std::filesystem::path(folder) / "fracture.csv").string();
  FractureHistory history;
  if (const auto csv = CsvColumns::read(file))
    history = read_fracture_history(file, *csv);
  else
    run.notes.push_back(file + " is not there: no curves.");
  put_fracture_plots(run.plots, history, words, !summary.has("preload"), units.si);
  put_avalanche_table(run, history, words, units);
  put_separated(run, summary);
  put_outputs(run, summary, false);
  put_end(run, summary, words, units);
  put_model(run, summary);
  put_accuracy(run, summary);
  Facts time("Time");
  const auto seconds = summary["seconds"].number(), breaks = summary["breaks"].number();
  time.add("whole run, s", seconds);
  if (seconds && breaks && *breaks > 0) time.add("each break, s", *seconds / *breaks);
  std::move(time).put_into(run.tables);
  put_solver(run, summary);
  put_left_out(run, summary);
  found.states = states_of(run, folder, summary, history, words, units);
  return found;
}

}  // namespace bondstatic
