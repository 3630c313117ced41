#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "report/output_plots.hpp"
#include "report/page_parts.hpp"
#include "report/pages.hpp"
#include "report/sweep_curves.hpp"
#include "report/sweep_reference.hpp"
#include "report/sweep_table.hpp"

namespace bondstatic {

namespace {

/// Outputs that are numbered, over their number: a curve for each point of the sweep.
void put_family(PageRun& run, const SweepTable& sweep, const NumberedOutputs& family,
                const SweepReference& reference) {
  std::vector<const SweepKey*> keys;
  for (const SweepKey& key : sweep.keys) keys.push_back(&key);
  const std::vector<std::string> names = row_names(sweep, keys);
  PagePlot values{"Outputs by number: " + family.stem, PagePlot::Kind::xy, {family.stem}, {"value"}, {}};
  PagePlot apart{family.stem + ": difference from " + reference.name,
                 PagePlot::Kind::xy,
                 {family.stem},
                 {"difference", "%"},
                 {}};
  bool any = false;
  for (std::size_t row = 0; row < sweep.rows(); ++row) {
    if (!sweep.done(row)) continue;
    PageSeries value{names[row], family.number, {}, PageSeries::Draw::line_and_points};
    value.place = int(row);
    PageSeries difference = value;
    for (const std::size_t output : family.index) {
      value.y.push_back(sweep.outputs[output].values[row]);
      difference.y.push_back(differences(sweep.outputs[output].values, reference)[row]);
    }
    any |= differ(difference.y);
    values.series.push_back(std::move(value));
    apart.series.push_back(std::move(difference));
  }
  values.y.log = wants_log(values.series);
  put_plot(run.plots, std::move(values));
  if (any) put_plot(run.plots, std::move(apart));
}

void put_ordinate(PageSweep& page, const std::string& title, std::size_t column) {
  const std::vector<double>& values = page.columns[column].values;
  if (std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
    page.ordinates.push_back({title, column, wants_log({{"", {}, values}})});
}

void put_plots(PageRun& run, const SweepTable& sweep) {
  constexpr std::size_t most_outputs = 30, most_numbers = 300'000, most_curves_of_numbered = 12;
  const std::size_t most = std::clamp(most_numbers / sweep.rows(), std::size_t(1), most_outputs);
  const SweepReference reference = reference_of(sweep);
  std::vector<std::string> names;
  for (const SweepColumn& output : sweep.outputs) names.push_back(output.name);
  std::vector<bool> numbered(sweep.outputs.size(), false);
  if (sweep.rows() <= most_curves_of_numbered)
    for (const NumberedOutputs& family : numbered_outputs(names)) {
      put_family(run, sweep, family, reference);
      for (const std::size_t output : family.index) numbered[output] = true;
    }
  std::vector<SweepColumn> outputs;
  for (std::size_t i = 0; i < sweep.outputs.size(); ++i)
    if (!numbered[i]) outputs.push_back(sweep.outputs[i]);
  if (outputs.size() > most) {
    run.notes.push_back(
        fmt::format("Plots of the first {} of {} outputs; the table has all.", most, outputs.size()));
    outputs.resize(most);
  }
  PageSweep page = sweep_curves(sweep, outputs);
  std::size_t column = page.columns.size() - outputs.size();
  for (const SweepColumn& output : outputs) {
    put_ordinate(page, output.name, column++);
    std::vector<double> apart = differences(output.values, reference);
    if (!differ(apart)) continue;
    page.columns.push_back({"difference", "%", std::move(apart)});
    put_ordinate(page, output.name + ": difference from " + reference.name, page.columns.size() - 1);
  }
  if (!page.ordinates.empty()) run.sweep = std::move(page);
}

PageField field_of(const std::string& text, const SweepKey& key, std::size_t row) {
  return key.is_number() && key.unit.empty() ? PageField(key.numbers[row]) : PageField(text);
}

void put_tables(PageRun& run, const SweepTable& sweep) {
  constexpr std::size_t most = 2000;
  PageTable points{"Points of the sweep", {}, {}}, failed{"Points that failed", {}, {}};
  for (const SweepKey& key : sweep.keys) points.columns.push_back(key.name);
  failed.columns = points.columns;
  failed.columns.push_back("status");
  points.columns.insert(points.columns.end(), {"particles", "bonds"});
  for (const SweepColumn& output : sweep.outputs) points.columns.push_back(output.name);
  for (std::size_t row = 0; row < sweep.rows(); ++row) {
    PageTable& table = sweep.done(row) ? points : failed;
    if (table.rows.size() == most) {
      table.note = fmt::format("The first {} only; sweep.csv has all.", most);
      continue;
    }
    std::vector<PageField> fields;
    for (const SweepKey& key : sweep.keys) fields.push_back(field_of(key.texts[row], key, row));
    if (!sweep.done(row)) fields.emplace_back(sweep.status[row]);
    if (sweep.done(row))
      for (const auto* columns : {&sweep.counts, &sweep.outputs})
        for (const SweepColumn& one : *columns) fields.push_back(field(one.values[row]));
    table.rows.push_back(std::move(fields));
  }
  for (PageTable* table : {&failed, &points})
    if (!table->rows.empty()) run.tables.push_back(std::move(*table));
}

}  // namespace

FoundRun sweep_page(const std::string& folder) {
  const std::string file = (std::filesystem::path(folder) / "sweep.csv").string();
  const auto csv = CsvColumns::read(file);
  FoundRun found;
  PageRun& run = found.page;
  run.kind = "sweep";
  if (!csv) return found;
  const SweepTable sweep = read_sweep(file, *csv);
  for (const SweepKey& key : sweep.keys) run.title += (run.title.empty() ? "Sweep of " : ", ") + key.name;
  if (sweep.rows() == 0) {
    run.notes.push_back(file + " has no points.");
    return found;
  }
  const auto failed = std::count_if(sweep.status.begin(), sweep.status.end(),
                                    [](const std::string& status) { return status != "done"; });
  if (failed > 0)
    run.warnings.push_back(
        fmt::format("{} of {} points failed; the plots leave them out.", failed, sweep.rows()));
  put_plots(run, sweep);
  put_tables(run, sweep);
  return found;
}

}  // namespace bondstatic
