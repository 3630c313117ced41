#include "report/sweep_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace bondstatic {

namespace {

std::vector<double> distinct(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// Over two decades in steps of about the same ratio.
bool wants_log_abscissa(const PageSweep::Column& column) {
  const std::vector<double> x = distinct(column.values);
  if (!column.categories.empty() || x.size() < 3 || x.front() <= 0 ||
      x.back() < 100 * (1 - 1e-12) * x.front())
    return false;
  double least = INFINITY, most = 0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double ratio = std::log(x[i] / x[i - 1]);
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  return most < 3 * least;
}

PageSweep::Column column_of(const SweepKey& key) {
  PageSweep::Column column{key.name, key.unit, key.numbers};
  if (key.is_number()) return column;
  const std::vector<std::string> names = value_names(key);
  std::map<std::string, double> place;
  for (std::size_t row = 0; row < names.size(); ++row) {
    const auto [found, first] = place.try_emplace(key.texts[row], double(column.categories.size()));
    if (first) column.categories.push_back(names[row]);
    column.values.push_back(found->second);
  }
  return column;
}

/// Over one key: a curve for each combination of the others, in the order of the table.
PageSweep::Curves curves_over(const SweepTable& sweep, const SweepKey& abscissa) {
  std::vector<const SweepKey*> others;
  for (const SweepKey& key : sweep.keys)
    if (&key != &abscissa && !depends_on(key, abscissa)) others.push_back(&key);
  PageSweep::Curves curves;
  std::map<std::string, std::size_t> place;
  for (const std::string& name : row_names(sweep, others)) {
    const auto [found, first] = place.try_emplace(name, curves.names.size());
    if (first) curves.names.push_back(name);
    curves.of_row.push_back(found->second);
  }
  return curves;
}

/// The key with the most numbers, or names.
std::size_t widest_key(const SweepTable& sweep) {
  const auto better = [](const SweepKey& a, const SweepKey& b) {
    const bool a_shows = a.is_number() && a.distinct > 1, b_shows = b.is_number() && b.distinct > 1;
    return a_shows != b_shows ? b_shows : a.distinct < b.distinct;
  };
  return std::size_t(std::max_element(sweep.keys.begin(), sweep.keys.end(), better) - sweep.keys.begin());
}

/// Whether the key, or one that changes together with it, says how many particles a generator makes.
bool counts_particles(const SweepTable& sweep, const SweepKey& key) {
  return std::any_of(sweep.keys.begin(), sweep.keys.end(), [&](const SweepKey& one) {
    return one.name.ends_with(".count") && depends_on(one, key) && depends_on(key, one);
  });
}

/// Whether each value of the key goes with one of the column's.
bool follows(const PageSweep::Column& column, const SweepKey& key) {
  std::map<std::string, double> value;
  for (std::size_t row = 0; row < column.values.size(); ++row)
    if (std::isfinite(column.values[row]) &&
        value.try_emplace(key.texts[row], column.values[row]).first->second != column.values[row])
      return false;
  return true;
}

/// The key that a column follows makes the same curves; else those over the widest key will do.
std::size_t key_behind(const PageSweep::Column& column, const SweepTable& sweep, std::size_t widest) {
  for (std::size_t key = 0; key < sweep.keys.size(); ++key)
    if (follows(column, sweep.keys[key])) return key;
  return widest;
}

}  // namespace

std::vector<std::string> row_names(const SweepTable& sweep, const std::vector<const SweepKey*>& keys) {
  std::vector<std::string> names(sweep.rows());
  for (const SweepKey* key : keys) {
    const std::vector<std::string> values = value_names(*key);
    for (std::size_t row = 0; row < names.size(); ++row)
      names[row] += fmt::format("{}{} = {}", names[row].empty() ? "" : ", ", key->short_name, values[row]);
  }
  return names;
}

PageSweep sweep_curves(const SweepTable& sweep, const std::vector<SweepColumn>& outputs) {
  PageSweep page;
  for (const SweepKey& key : sweep.keys) {
    page.columns.push_back(column_of(key));
    page.curves.push_back(curves_over(sweep, key));
  }
  for (const auto* columns : {&sweep.counts, &outputs})
    for (const SweepColumn& one : *columns) page.columns.push_back({one.name, "", one.values});

  const std::size_t keys = sweep.keys.size(), widest = widest_key(sweep), bonds = keys + 1;
  const auto varies = [&](std::size_t column) { return distinct(page.columns[column].values).size() > 1; };
  const auto put = [&](std::size_t column) {
    const std::size_t curves = column < keys ? column : key_behind(page.columns[column], sweep, widest);
    page.abscissae.push_back({column, curves, wants_log_abscissa(page.columns[column])});
  };
  const std::size_t first = varies(bonds) && counts_particles(sweep, sweep.keys[widest]) ? bonds : widest;
  put(first);
  for (std::size_t column = 0; column < page.columns.size(); ++column)
    if (column != first && varies(column)) put(column);
  return page;
}

}  // namespace bondstatic
