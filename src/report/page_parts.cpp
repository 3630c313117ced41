#include "report/page_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/thinned.hpp"

namespace bondstatic {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// What a log axis cannot show.
void leave_gaps(std::vector<double>& values) {
  for (double& value : values)
    if (!(value > 0)) value = nan;
}

bool has_point(const PageSeries& series) {
  for (std::size_t i = 0; i < series.y.size(); ++i)
    if (std::isfinite(series.x[i]) && std::isfinite(series.y[i])) return true;
  return false;
}

}  // namespace

std::string PageUnits::in(const std::string& name, const std::string& unit) const {
  return si && !unit.empty() ? name + ", " + unit : name;
}

PageAxis PageUnits::axis(const std::string& name, const std::string& unit, bool log) const {
  return {name, of(unit), log};
}

PageUnits units_of(const JsonValue& summary) {
  return {summary["units"].text_or() == "SI"};
}

Facts& Facts::add(const std::string& name, const std::optional<double>& value) {
  if (value) table_.rows.push_back({name, *value});
  return *this;
}

Facts& Facts::add(const std::string& name, const std::optional<std::string>& value) {
  if (value && !value->empty()) table_.rows.push_back({name, *value});
  return *this;
}

void Facts::put_into(std::vector<PageTable>& tables) && {
  if (!table_.rows.empty()) tables.push_back(std::move(table_));
}

PageField field(double value) {
  return std::isnan(value) ? PageField() : PageField(value);
}

PageField field(const std::optional<double>& value) {
  return value ? PageField(*value) : PageField();
}

PageField field(const std::optional<std::string>& value) {
  return value && !value->empty() ? PageField(*value) : PageField();
}

void put_table(std::vector<PageTable>& tables, PageTable table) {
  const auto empty = [](const PageField& one) { return std::holds_alternative<std::monostate>(one); };
  for (std::size_t c = table.columns.size(); c-- > 0;) {
    if (!std::all_of(table.rows.begin(), table.rows.end(), [&](const auto& row) { return empty(row[c]); }))
      continue;
    table.columns.erase(table.columns.begin() + std::ptrdiff_t(c));
    for (auto& row : table.rows) row.erase(row.begin() + std::ptrdiff_t(c));
  }
  if (!table.rows.empty() && !table.columns.empty()) tables.push_back(std::move(table));
}

void put_plot(std::vector<PagePlot>& plots, PagePlot plot) {
  for (PageSeries& series : plot.series) {
    if (plot.x.log) leave_gaps(series.x);
    if (plot.y.log)
      for (auto* values : {&series.y, &series.low, &series.high}) leave_gaps(*values);
  }
  const auto found = std::any_of(plot.series.begin(), plot.series.end(), [](const PageSeries& series) {
    return !series.reference && has_point(series);
  });
  if (!found) return;
  std::erase_if(plot.series, [](const PageSeries& series) { return !has_point(series); });
  bool thinner = false;
  for (PageSeries& series : plot.series) thinner |= thin(series);
  if (thinner)
    plot.note += fmt::format("{}Long curves are drawn by their ends, lowest and highest points of {} parts.",
                             plot.note.empty() ? "" : " ", parts_of_thin_series);
  plots.push_back(std::move(plot));
}

bool wants_log(const std::vector<PageSeries>& series) {
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  for (const PageSeries& one : series)
    for (const double value : one.y) {
      if (std::isnan(value)) continue;
      least = std::min(least, value);
      largest = std::max(largest, value);
    }
  return least > 0 && largest > 100 * least;
}

PageSeries limit_line(const std::string& name, double value, double from, double to) {
  PageSeries line{name, {from, to}, {value, value}};
  line.reference = true;
  return line;
}

std::vector<double> places(std::size_t count) {
  std::vector<double> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = double(i);
  return all;
}

std::string id_text(const JsonValue& ids) {
  constexpr std::size_t most = 20;
  const std::vector<JsonValue> all = ids.items();
  std::string text;
  for (std::size_t i = 0; i < std::min(most, all.size()); ++i) {
    const auto id = all[i].whole();
    if (!id) all[i].refuse("the id of a particle");
    text += fmt::format("{}{}", text.empty() ? "" : ", ", *id);
  }
  return all.size() > most ? fmt::format("{} and {} more", text, all.size() - most) : text;
}

std::string suffix_of(const std::string& load_case) {
  return load_case.empty() ? "" : ": " + load_case;
}

std::string count_text(Index count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace bondstatic
