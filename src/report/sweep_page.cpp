#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "report/output_plots.hpp"
#include "report/page_parts.hpp"
#include "report/pages.hpp"
#include "report/sweep_table.hpp"

namespace bondstatic {

namespace {

constexpr double percent = 100;
constexpr double rounding = 1e-10;  ///< relative differences below are no differences

/// The abscissa: the numbers with the most distinct values, or the names.
const SweepKey& abscissa_of(const SweepTable& sweep) {
  const auto better = [](const SweepKey& a, const SweepKey& b) {
    const bool a_shows = a.is_number() && a.distinct > 1, b_shows = b.is_number() && b.distinct > 1;
    return a_shows != b_shows ? b_shows : a.distinct < b.distinct;
  };
  return *std::max_element(sweep.keys.begin(), sweep.keys.end(), better);
}

/// Over two decades in steps of about the same ratio.
bool wants_log_abscissa(const SweepKey& key) {
  std::vector<double> x = key.numbers;
  std::sort(x.begin(), x.end());
  x.erase(std::unique(x.begin(), x.end()), x.end());
  if (x.size() < 3 || x.front() <= 0 || x.back() < 100 * (1 - 1e-12) * x.front()) return false;
  double least = INFINITY, most = 0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double ratio = std::log(x[i] / x[i - 1]);
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  return most < 3 * least;
}

std::vector<const SweepKey*> other_keys(const SweepTable& sweep, const SweepKey& but) {
  std::vector<const SweepKey*> others;
  for (const SweepKey& key : sweep.keys)
    if (&key != &but && !depends_on(key, but)) others.push_back(&key);
  return others;
}

/// "law = parallel, poisson = 0.3", row by row.
std::vector<std::string> row_names(const SweepTable& sweep, const std::vector<const SweepKey*>& keys) {
  std::vector<std::string> names(sweep.rows());
  for (const SweepKey* key : keys) {
    const std::vector<std::string> values = value_names(*key);
    for (std::size_t row = 0; row < names.size(); ++row)
      names[row] += fmt::format("{}{} = {}", names[row].empty() ? "" : ", ", key->short_name, values[row]);
  }
  return names;
}

/// A series for each combination of the keys, in the order of the table.
struct Curve {
  std::string name;
  std::vector<std::size_t> rows;
};
std::vector<Curve> curves_of(const SweepTable& sweep, const std::vector<const SweepKey*>& keys) {
  const std::vector<std::string> names = row_names(sweep, keys);
  std::vector<Curve> curves;
  std::map<std::string, std::size_t> place;
  for (std::size_t row = 0; row < sweep.rows(); ++row) {
    const auto [found, first] = place.try_emplace(names[row], curves.size());
    if (first) curves.push_back({names[row], {}});
    curves[found->second].rows.push_back(row);
  }
  return curves;
}

class Plotter {
 public:
  explicit Plotter(const SweepTable& sweep)
      : sweep_(sweep),
        key_(abscissa_of(sweep)),
        others_(other_keys(sweep, key_)),
        curves_(curves_of(sweep, others_)) {
    axis_ = {key_.name, key_.unit, key_.is_number() && wants_log_abscissa(key_)};
    if (key_.is_number()) {
      x_ = key_.numbers;
      return;
    }
    const std::vector<std::string> names = value_names(key_);
    std::map<std::string, double> place;
    for (std::size_t row = 0; row < names.size(); ++row) {
      const auto [found, first] = place.try_emplace(key_.texts[row], double(axis_.categories.size()));
      if (first) axis_.categories.push_back(names[row]);
      x_.push_back(found->second);
    }
  }

  const SweepKey& key() const { return key_; }
  const std::vector<const SweepKey*>& others() const { return others_; }

  /// Values row by row over the abscissa; those that are not finite are left out.
  PagePlot plot(const std::string& title, const std::string& ordinate,
                const std::vector<double>& values) const {
    PagePlot plot{title, PagePlot::Kind::xy, axis_, {ordinate}, {}};
    for (const Curve& curve : curves_) {
      std::vector<std::pair<double, double>> points;
      for (const std::size_t row : curve.rows)
        if (std::isfinite(values[row])) points.emplace_back(x_[row], values[row]);
      std::stable_sort(points.begin(), points.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      PageSeries series{
          curve.name.empty() ? ordinate : curve.name, {}, {}, PageSeries::Draw::line_and_points};
      if (!key_.is_number()) series.draw = PageSeries::Draw::bars;
      for (const auto& [x, y] : points) {
        series.x.push_back(x);
        series.y.push_back(y);
      }
      if (!series.x.empty()) plot.series.push_back(std::move(series));
    }
    return plot;
  }

 private:
  const SweepTable& sweep_;
  const SweepKey& key_;
  std::vector<const SweepKey*> others_;
  std::vector<Curve> curves_;
  std::vector<double> x_;
  PageAxis axis_;
};

/// What the others are compared with: the first value of the first key that counts names, of laws the beam
/// that is exact for any number of bonds.
struct Reference {
  const SweepKey* key = nullptr;
  std::string value;
  std::string name;
};
Reference reference_of(const SweepTable& sweep) {
  for (const SweepKey& key : sweep.keys) {
    if (key.is_number() || key.distinct < 2) continue;
    const auto beam = std::find(key.texts.begin(), key.texts.end(), "timoshenko");
    const auto at = std::size_t((beam == key.texts.end() ? key.texts.begin() : beam) - key.texts.begin());
    return {&key, key.texts[at], fmt::format("{} = {}", key.short_name, value_names(key)[at])};
  }
  return {};
}

/// The row with the reference's value and all other keys the same, for each row; no row where there is none.
std::vector<std::size_t> reference_rows(const SweepTable& sweep, const Reference& reference) {
  // What changes together with the key is part of it.
  std::vector<const SweepKey*> same;
  for (const SweepKey& key : sweep.keys)
    if (&key != reference.key && !depends_on(key, *reference.key)) same.push_back(&key);
  const auto others = [&](std::size_t row) {
    std::vector<std::string> values;
    for (const SweepKey* key : same) values.push_back(key->texts[row]);
    return values;
  };
  std::map<std::vector<std::string>, std::size_t> row_of;
  for (std::size_t row = 0; row < sweep.rows(); ++row)
    if (reference.key->texts[row] == reference.value) row_of.try_emplace(others(row), row);
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < sweep.rows(); ++row) {
    const auto found = row_of.find(others(row));
    rows.push_back(found == row_of.end() ? sweep.rows() : found->second);
  }
  return rows;
}

/// In percent of the reference; nothing for the reference itself.
std::vector<double> differences(const SweepOutput& output, const std::vector<std::size_t>& reference) {
  std::vector<double> all;
  for (std::size_t row = 0; row < output.values.size(); ++row) {
    const std::size_t with = reference[row];
    const bool other = with < output.values.size() && with != row && output.values[with] != 0;
    all.push_back(other ? percent * (output.values[row] / output.values[with] - 1) : NAN);
  }
  return all;
}

bool differ(const std::vector<double>& differences) {
  return std::any_of(differences.begin(), differences.end(),
                     [](double value) { return std::abs(value) > percent * rounding; });
}

/// Outputs that are numbered, over their number: a curve for each point of the sweep.
void put_family(PageRun& run, const SweepTable& sweep, const NumberedOutputs& family,
                const Reference& reference, const std::vector<std::size_t>& with) {
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
    PageSeries value{names[row], family.number, {}, PageSeries::Draw::line_and_points}, difference = value;
    for (const std::size_t output : family.index) {
      value.y.push_back(sweep.outputs[output].values[row]);
      difference.y.push_back(with.empty() ? NAN : differences(sweep.outputs[output], with)[row]);
    }
    any |= differ(difference.y);
    values.series.push_back(std::move(value));
    apart.series.push_back(std::move(difference));
  }
  values.y.log = wants_log(values.series);
  put_plot(run.plots, std::move(values));
  if (any) put_plot(run.plots, std::move(apart));
}

void put_plots(PageRun& run, const SweepTable& sweep) {
  constexpr std::size_t most_outputs = 30, most_curves_of_numbered = 12;
  const Plotter plotter(sweep);
  const Reference reference = reference_of(sweep);
  const auto with = reference.key ? reference_rows(sweep, reference) : std::vector<std::size_t>();
  std::vector<std::string> names;
  for (const SweepOutput& output : sweep.outputs) names.push_back(output.name);
  std::vector<bool> drawn(sweep.outputs.size(), false);
  if (sweep.rows() <= most_curves_of_numbered)
    for (const NumberedOutputs& family : numbered_outputs(names)) {
      put_family(run, sweep, family, reference, with);
      for (const std::size_t output : family.index) drawn[output] = true;
    }
  std::size_t count = 0;
  for (std::size_t i = 0; i < sweep.outputs.size(); ++i) {
    const SweepOutput& output = sweep.outputs[i];
    if (drawn[i] || ++count > most_outputs) continue;
    PagePlot plot = plotter.plot(output.name, output.name, output.values);
    plot.y.log = plotter.key().is_number() && wants_log(plot.series);
    put_plot(run.plots, std::move(plot));
    if (!reference.key || reference.key == &plotter.key()) continue;
    const std::vector<double> apart = differences(output, with);
    if (!differ(apart)) continue;
    PagePlot error = plotter.plot(output.name + ": difference from " + reference.name, "difference", apart);
    error.y.unit = "%";
    put_plot(run.plots, std::move(error));
  }
  if (count > most_outputs)
    run.notes.push_back(
        fmt::format("Plots of the first {} of {} outputs; the table has all.", most_outputs, count));
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
  for (const SweepOutput& output : sweep.outputs) points.columns.push_back(output.name);
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
      for (const SweepOutput& output : sweep.outputs)
        fields.push_back(std::isnan(output.values[row]) ? PageField() : PageField(output.values[row]));
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
