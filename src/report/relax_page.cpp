#include <algorithm>
#include <filesystem>

#include "report/csv_columns.hpp"
#include "report/facts_tables.hpp"
#include "report/found_states.hpp"
#include "report/output_plots.hpp"
#include "report/page_parts.hpp"
#include "report/pages.hpp"
#include "report/relaxed_case.hpp"

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
    const std::string file = (std::filesystem::path(folder_of(folder, one)) / "history.csv").string();
    const auto history = CsvColumns::read(file);
    const bool ours = history && history->names().size() >= known_columns.size() &&
                      std::equal(known_columns.begin(), known_columns.end(), history->names().begin());
    if (ours)
      put_history(run, *history, one["name"].text_or(), summary["outputs"].items(), units);
    else
      run.notes.push_back(file + (history ? " is of another run" : " is not there") +
                          ": no curves over time.");
  }
  found.states = load_case_states(folder, summary, run, at_rest ? "at rest" : "not at rest");
  return found;
}

}  // namespace bondstatic
