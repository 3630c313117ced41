#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "report/csv_columns.hpp"
#include "report/facts_tables.hpp"
#include "report/found_states.hpp"
#include "report/page_parts.hpp"
#include "report/pages.hpp"

namespace bondstatic {

namespace {

void put_verdict(PageRun& run, const JsonValue& c) {
  Facts facts("Static answer and run");
  facts.add("verdict", c["verdict"].text())
      .add("because", c["reason"].text())
      .add("run", c["run"].text())
      .add("step", c["step"].number())
      .add("load case", c["load_case"].text())
      .add("tolerance", c["tolerance"].number())
      .add("particles found in both", c["matched_particles"].number())
      .add("missing in the run", id_text(c["missing_in_run"]))
      .add("not in the case", id_text(c["unknown_to_case"]));
  std::move(facts).put_into(run.tables);
}

void put_fields(PageRun& run, const JsonValue& c) {
  const std::vector<JsonValue> fields = c["fields"].items();
  PageTable table{"Differences",
                  {"field", "norm, static", "norm, run", "relative difference", "largest", "largest at",
                   "best-fit scale", "left after scaling"},
                  {},
                  "Scale: the factor on the static answer that brings it nearest to the run."};
  PagePlot plot{"Differences by field", PagePlot::Kind::xy, {"field"}, {"relative difference", "", true}, {}};
  PageSeries norm{"norm", places(fields.size()), {}, PageSeries::Draw::points}, largest = norm, left = norm;
  largest.name = "largest";
  left.name = "norm after scaling";
  for (const JsonValue& one : fields) {
    plot.x.categories.push_back(one["field"].text_or());
    norm.y.push_back(one["difference"].number_or_nan());
    largest.y.push_back(one["largest"].number_or_nan());
    left.y.push_back(one["misfit_after_scaling"].number_or_nan());
    table.rows.push_back({plot.x.categories.back(), field(one["static_norm"].number()),
                          field(one["run_norm"].number()), field(one["difference"].number()),
                          field(one["largest"].number()), field(place_text(one["largest_at"])),
                          field(one["best_fit_scale"].number()),
                          field(one["misfit_after_scaling"].number())});
  }
  put_table(run.tables, std::move(table));
  plot.series = {std::move(norm), std::move(largest), std::move(left)};
  if (const auto tolerance = c["tolerance"].number())
    plot.series.push_back(
        limit_line("tolerance on displacement and rotation", *tolerance, 0, double(fields.size()) - 1));
  put_plot(run.plots, std::move(plot));
}

void put_suspects(PageRun& run, const JsonValue& c) {
  const std::vector<JsonValue> suspects = c["suspects"].items();
  PageTable table{"What could be different from the case",
                  {"if the run has", "factors", "left of the difference"},
                  {},
                  "Each takes the place of what the case says; over the displacements of the static answer."};
  PagePlot plot{"What each suspect leaves of the difference",
                PagePlot::Kind::xy,
                {"if the run has"},
                {"left, over the static displacements", "", true},
                {}};
  PageSeries left{"left", places(suspects.size()), {}, PageSeries::Draw::points};
  for (const JsonValue& one : suspects) {
    std::string factors;
    for (const JsonValue& factor : one["factors"].items())
      if (const auto value = factor.number())
        factors += fmt::format("{}{:.6g}", factors.empty() ? "" : ", ", *value);
    const std::string text = one["text"].text_or(one["what"].text_or());
    table.rows.push_back({text, field(std::optional(factors)), field(one["left"].number())});
    plot.x.categories.push_back(one["what"].text_or(text));
    left.y.push_back(one["left"].number_or_nan());
  }
  put_table(run.tables, std::move(table));
  plot.series.push_back(std::move(left));
  if (!suspects.empty())
    for (const JsonValue& one : c["fields"].items())
      if (const auto all = one["difference"].number(); all && one["field"].text_or() == "displacement")
        plot.series.push_back(
            limit_line("difference of displacements", *all, 0, double(suspects.size()) - 1));
  put_plot(run.plots, std::move(plot));
}

void put_unbalance(PageRun& run, const JsonValue& c, const PageUnits& units) {
  const JsonValue state = c["state"];
  Facts facts("What the run's state carries that rest does not");
  facts.add("unbalanced forces over the loads", state["residual_linear"].number())
      .add("the same, bonds turning with their particles", state["residual_finite"].number())
      .add("motion that is left, over the displacements", state["motion_left"].number())
      .add("kinetic over strain energy", state["kinetic_over_strain_energy"].number())
      .add(units.in("fastest particle", "m/s"), state["fastest_particle"].number())
      .add("net forces that the run writes, over the loads", state["net_force"].number())
      .add("part of the unbalanced forces that these confirm", state["confirmed_by_net_force"].number())
      .add("part of the acceleration in the slowest modes", state["in_slowest_modes"].number());
  std::move(facts).put_into(run.tables);
}

void put_worst(PageRun& run, const JsonValue& c, const PageUnits& units) {
  PageTable table{"Particles with the largest differences", {"particle"}, {}};
  for (const char* of : {"static ", "run "})
    for (const char* name : {"ux", "uy", "uz"})
      table.columns.push_back(units.in(std::string(of) + name, "m"));
  table.columns.push_back(units.in("difference", "m"));
  for (const JsonValue& one : c["worst"].items()) {
    std::vector<PageField> row{field(place_text(one))};
    std::vector<double> both;
    for (const char* of : {"static", "run"}) {
      const std::vector<JsonValue> motion = one[of].items();
      for (std::size_t i = 0; i < 3; ++i) {
        both.push_back(i < motion.size() ? motion[i].number_or_nan() : std::nan(""));
        row.push_back(field(both.back()));
      }
    }
    const double apart = std::hypot(both[3] - both[0], both[4] - both[1], both[5] - both[2]);
    row.push_back(field(apart));
    table.rows.push_back(std::move(row));
  }
  put_table(run.tables, std::move(table));
}

/// Steps of a run on its way: steps.csv tells more than the series in summary.json, which does where it is
/// gone.
void put_steps(PageRun& run, const std::string& folder, const JsonValue& summary) {
  if (!summary.has("series")) return;
  PagePlot plot{"Differences by step of the run", PagePlot::Kind::xy, {"step"}, {"relative", "", true}, {}};
  const auto table = CsvColumns::read((std::filesystem::path(folder) / "steps.csv").string());
  const auto add = [&](const std::string& name, std::vector<double> x, std::vector<double> y) {
    plot.series.push_back({name, std::move(x), std::move(y), PageSeries::Draw::line_and_points});
  };
  if (table) {
    const std::vector<double> step = table->numbers("step");
    const std::pair<const char*, const char*> columns[] = {{"displacement", "displacement"},
                                                           {"rotation", "rotation"},
                                                           {"energy", "energy"},
                                                           {"kinetic", "kinetic over strain energy"},
                                                           {"residual", "unbalanced forces over the loads"}};
    for (const auto& [column, name] : columns)
      if (const int at = table->find(column); at >= 0) add(name, step, table->numbers(at));
  } else {
    std::vector<double> step;
    for (const JsonValue& one : summary["series"].items()) step.push_back(one["step"].number_or_nan());
    for (const JsonValue& of : summary["comparison"]["fields"].items()) {
      const std::string name = of["field"].text_or();
      std::vector<double> values;
      for (const JsonValue& one : summary["series"].items()) values.push_back(one[name].number_or_nan());
      add(name, step, std::move(values));
    }
  }
  put_plot(run.plots, std::move(plot));
}

}  // namespace

FoundRun compare_page(const std::string& folder, const JsonValue& summary) {
  FoundRun found;
  PageRun& run = found.page;
  run.kind = "compare";
  const PageUnits units = units_of(summary);
  found.si = units.si;
  put_heading(run, summary);
  const JsonValue c = summary["comparison"];
  put_verdict(run, c);
  put_fields(run, c);
  put_suspects(run, c);
  put_steps(run, folder, summary);
  put_unbalance(run, c, units);
  put_worst(run, c, units);
  PageTable notes{"What was assumed of the run's files", {"note"}, {}};
  for (const JsonValue& note : c["notes"].items()) notes.rows.push_back({note.text_or()});
  put_table(run.tables, std::move(notes));
  put_model(run, summary);
  Facts solver("Solver");
  solver.add("solver", summary["solver"].text());
  std::move(solver).put_into(run.tables);
  put_left_out(run, summary);
  std::vector<std::string> files = grid_files(folder, run);
  if (!files.empty())
    found.states = {{std::move(files), c["load_case"].text_or(), "static answer and run", {}}};
  return found;
}

}  // namespace bondstatic
