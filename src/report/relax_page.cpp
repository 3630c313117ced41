#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "report/csv_columns.hpp"
#include "report/facts_tables.hpp"
#include "report/found_states.hpp"
#include "report/output_plots.hpp"
#include "report/page_parts.hpp"
#include "report/pages.hpp"
#include "report/relaxed_case.hpp"
#include "results/relaxation_series.hpp"

namespace bondstatic {

namespace {

/// The first columns of history.csv (RelaxedCase::history); outputs follow.
const std::vector<std::string> known_columns{"step", "time",       "load_factor", "kinetic", "strain",
                                             "work", "dissipated", "balance",     "fastest", "unbalanced"};

PageSeries over_time(const CsvColumns& history, const std::string& name, int column) {
  return {name, history.numbers("time"), history.numbers(column)};
}

void put_history(PageRun& run, const CsvColumns& history, const std::string& load_case,
                 const std::vector<JsonValue>& outputs, const PageUnits& units) {
  const std::string suffix = suffix_of(load_case);
  const PageAxis time = units.axis("time", "s");
  const auto known = [&](const std::string& name, const char* column) {
    return over_time(history, name, history.find(column));
  };
  put_plot(run.plots, {"Energies" + suffix,
                       PagePlot::Kind::xy,
                       time,
                       units.axis("energy", "J"),
                       {known("work", "work"), known("strain", "strain"), known("dissipated", "dissipated"),
                        known("kinetic", "kinetic")}});
  put_plot(run.plots,
           {"Way to rest" + suffix,
            PagePlot::Kind::xy,
            time,
            {"relative", "", true},
            {known("unbalanced force", "unbalanced"), known("balance of energies", "balance")},
            {},
            "The unbalanced force is over loads and reactions, the balance over the largest energy."});
  put_plot(run.plots, {"Fastest particle" + suffix,
                       PagePlot::Kind::xy,
                       time,
                       units.axis("speed", "m/s", true),
                       {known("fastest particle", "fastest")}});
  put_plot(run.plots, {"Load factor" + suffix,
                       PagePlot::Kind::xy,
                       time,
                       {"part of the loads"},
                       {known("load factor", "load_factor")}});
  for (int column = int(known_columns.size()); column < int(history.names().size()); ++column) {
    const std::string& name = history.names()[std::size_t(column)];
    PagePlot plot{
        name + " over time" + suffix, PagePlot::Kind::xy, time, {name}, {over_time(history, "run", column)}};
    const std::vector<double>& at = plot.series.front().x;
    for (const JsonValue& output : outputs)
      if (const auto expected = output["expected"].number();
          expected && output["name"].text_or() == name && !at.empty())
        plot.series.push_back(limit_line("expected", *expected, at.front(), at.back()));
    put_plot(run.plots, std::move(plot));
  }
}

/// "time 0.0012 s, kinetic 3.1e-09 J": the energy where the history has a row of that time.
std::string label_of(double time, const std::optional<CsvColumns>& history, const PageUnits& units) {
  const auto quantity = [&](const char* name, double value, const char* unit) {
    return fmt::format("{} {:.4g}{}", name, value, units.si ? std::string(" ") + unit : "");
  };
  const std::string label = quantity("time", time, "s");
  if (!history) return label;
  const std::vector<double> times = history->numbers("time");
  const auto row = std::lower_bound(times.begin(), times.end(), time);
  if (row == times.end() || *row != time) return label;
  const double kinetic = history->numbers("kinetic")[std::size_t(row - times.begin())];
  return label + ", " + quantity("kinetic", kinetic, "J");
}

/// Those that the run kept on its way, or the last one.
void put_states(FoundRun& found, const std::string& folder, const JsonValue& one,
                const std::optional<CsvColumns>& history, bool kept, const PageUnits& units) {
  const std::string name = one["name"].text_or();
  const std::string end = one["end"].text_or() == "at rest" ? "at rest" : "not at rest";
  std::vector<SceneState> states;
  if (kept)
    for (const ShownState& shown : shown_states(folder, relaxation_kind, found.page))
      states.push_back({{shown.file}, name, label_of(shown.time, history, units), shown.time});
  const auto time = one["time"].number();
  if (!states.empty() && time && *states.back().step >= *time)
    states.back().label += ", " + end;
  else if (std::vector<std::string> files = grid_files(folder, found.page); !files.empty())
    states.push_back({std::move(files), name, end, states.empty() ? std::nullopt : time});
  found.states.insert(found.states.end(), states.begin(), states.end());
}

/// Whether the run wrote a series of states for this load case.
bool has_series(const JsonValue& summary, const JsonValue& load_case) {
  const std::string folder = load_case["folder"].text_or();
  const std::string name = (folder.empty() ? "" : folder + "/") + series_file(relaxation_kind);
  const std::vector<JsonValue> files = summary["files"].items();
  return std::any_of(files.begin(), files.end(), [&](const JsonValue& file) { return file.text() == name; });
}

}  // namespace

FoundRun relax_page(const std::string& folder, const JsonValue& summary) {
  FoundRun found;
  PageRun& run = found.page;
  run.kind = "relax";
  const PageUnits units = units_of(summary);
  found.si = units.si;
  put_heading(run, summary);
  const bool at_rest = summary["at_rest"].flag().value_or(false);
  if (!at_rest) run.warnings.push_back("The run has not come to rest: its state is no answer yet.");
  put_outputs(run, summary, false);
  const std::vector<JsonValue> cases = summary["load_cases"].items();
  std::vector<std::string> names;
  for (const JsonValue& one : cases) names.push_back(one["name"].text_or());
  put_relaxed_cases(run, cases, names, units);
  put_load_cases(run, summary);
  put_model(run, summary);
  Facts time("Time");
  time.add("frequencies and time step, s", summary["planning_seconds"].number())
      .add("threads", summary["threads"].number());
  std::move(time).put_into(run.tables);
  put_left_out(run, summary);
  for (const JsonValue& one : cases) {
    const std::string place = folder_of(folder, one);
    const std::string file = (std::filesystem::path(place) / "history.csv").string();
    auto history = CsvColumns::read(file);
    const bool ours = history && history->names().size() >= known_columns.size() &&
                      std::equal(known_columns.begin(), known_columns.end(), history->names().begin());
    if (ours)
      put_history(run, *history, one["name"].text_or(), summary["outputs"].items(), units);
    else
      run.notes.push_back(file + (history ? " is of another run" : " is not there") +
                          ": no curves over time.");
    if (!ours) history.reset();
    put_states(found, place, one, history, has_series(summary, one), units);
  }
  return found;
}

}  // namespace bondstatic
