#include "report/output_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include "report/page_parts.hpp"

namespace bondstatic {

namespace {

struct FoundOutput {
  std::string name, source;
  double value, expected, error, tolerance;  ///< NaN where not there
};

std::vector<FoundOutput> outputs_in(const JsonValue& summary) {
  std::vector<FoundOutput> outputs;
  for (const JsonValue& one : summary["outputs"].items())
    outputs.push_back({one["name"].text_or(), one["source"].text_or(), one["value"].number_or_nan(),
                       one["expected"].number_or_nan(), one["relative_error"].number_or_nan(),
                       one["tolerance"].number_or_nan()});
  return outputs;
}

void put_table_of(PageRun& run, const std::vector<FoundOutput>& outputs, bool judged) {
  PageTable table{
      "Outputs", {"output", "value", "expected", "relative error", "tolerance", "within", "source"}, {}};
  for (const FoundOutput& one : outputs) {
    const bool compared = judged && !std::isnan(one.error) && !std::isnan(one.tolerance);
    table.rows.push_back({one.name, field(one.value), field(one.expected), field(one.error),
                          judged ? field(one.tolerance) : PageField(),
                          compared ? PageField(one.error <= one.tolerance ? "yes" : "no") : PageField(),
                          one.source.empty() ? PageField() : PageField(one.source)});
  }
  put_table(run.tables, std::move(table));
}

std::vector<FoundOutput> expected_ones(const std::vector<FoundOutput>& outputs) {
  std::vector<FoundOutput> some;
  for (const FoundOutput& one : outputs)
    if (!std::isnan(one.expected)) some.push_back(one);
  return some;
}

std::vector<std::string> names_of(const std::vector<FoundOutput>& outputs) {
  std::vector<std::string> names;
  for (const FoundOutput& one : outputs) names.push_back(one.name);
  return names;
}

void put_errors(PageRun& run, const std::vector<FoundOutput>& outputs, bool judged) {
  PagePlot plot{"Outputs: relative errors", PagePlot::Kind::xy, {"output"}, {"relative error", "", true}, {}};
  plot.x.categories = names_of(outputs);
  PageSeries errors{"found against expected", places(outputs.size()), {}, PageSeries::Draw::points};
  PageSeries limits{"tolerance", places(outputs.size()), {}, PageSeries::Draw::line_and_points};
  limits.reference = true;
  std::string exact;
  for (const FoundOutput& one : outputs) {
    errors.y.push_back(one.error);
    limits.y.push_back(one.tolerance);
    if (one.error == 0) exact += (exact.empty() ? "" : ", ") + one.name;
  }
  plot.series = {std::move(errors)};
  if (judged) plot.series.push_back(std::move(limits));
  if (!exact.empty()) plot.note = "No error at all: " + exact + ".";
  put_plot(run.plots, std::move(plot));
}

/// Values over what was expected: of any size, side by side.
void put_ratios(PageRun& run, const std::vector<FoundOutput>& outputs) {
  std::vector<FoundOutput> some;
  for (const FoundOutput& one : outputs)
    if (one.expected != 0 && std::isfinite(one.value)) some.push_back(one);
  PagePlot plot{"Outputs over expected values", PagePlot::Kind::xy, {"output"}, {"value / expected"}, {}};
  plot.x.categories = names_of(some);
  PageSeries ratios{"found", places(some.size()), {}, PageSeries::Draw::points};
  bool sources_differ = false;
  for (const FoundOutput& one : some) {
    ratios.y.push_back(one.value / one.expected);
    sources_differ |= one.source != some.front().source;
  }
  if (some.empty()) return;
  const std::string source = some.front().source;
  const std::string name = sources_differ || source.empty() ? "expected" : "expected: " + source;
  plot.series = {std::move(ratios), limit_line(name, 1, 0, double(some.size()) - 1)};
  put_plot(run.plots, std::move(plot));
}

void put_families(PageRun& run, const std::vector<FoundOutput>& outputs) {
  for (const NumberedOutputs& family : numbered_outputs(names_of(outputs))) {
    PagePlot plot{"Outputs by number: " + family.stem, PagePlot::Kind::xy, {family.stem}, {"value"}, {}};
    PageSeries found{"found", family.number, {}, PageSeries::Draw::points}, expected = found;
    expected.name = "expected";
    expected.draw = PageSeries::Draw::line;
    expected.reference = true;
    for (const std::size_t i : family.index) {
      found.y.push_back(outputs[i].value);
      expected.y.push_back(outputs[i].expected);
    }
    plot.series = {std::move(found), std::move(expected)};
    put_plot(run.plots, std::move(plot));
  }
}

}  // namespace

std::vector<NumberedOutputs> numbered_outputs(const std::vector<std::string>& names) {
  std::map<std::string, std::map<double, std::size_t>> by_stem;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    std::size_t digits = name.size();
    while (digits > 0 && std::isdigit(static_cast<unsigned char>(name[digits - 1]))) --digits;
    std::size_t stem = digits;
    while (stem > 0 && (name[stem - 1] == ' ' || name[stem - 1] == '_' || name[stem - 1] == '#')) --stem;
    double number = 0;
    const auto read = std::from_chars(name.data() + digits, name.data() + name.size(), number);
    if (read.ec == std::errc() && digits < name.size() && stem > 0) by_stem[name.substr(0, stem)][number] = i;
  }
  std::vector<NumberedOutputs> families;
  constexpr std::size_t least = 3;
  for (const auto& [stem, members] : by_stem) {
    if (members.size() < least) continue;
    NumberedOutputs family{stem, {}, {}};
    for (const auto& [number, index] : members) {
      family.number.push_back(number);
      family.index.push_back(index);
    }
    families.push_back(std::move(family));
  }
  return families;
}

void put_outputs(PageRun& run, const JsonValue& summary, bool judged) {
  const std::vector<FoundOutput> outputs = outputs_in(summary), expected = expected_ones(outputs);
  put_table_of(run, outputs, judged);
  put_errors(run, expected, judged);
  put_ratios(run, expected);
  put_families(run, outputs);
}

void put_sensitivities(PageRun& run, const JsonValue& summary) {
  PageTable table{"Sensitivities",
                  {"output", "parameter", "bonds", "value", "derivative", "% for each %"},
                  {},
                  "How the output changes with a parameter of all bonds of a block."};
  std::vector<std::string> outputs;
  std::map<std::string, std::map<double, double>> elasticities;  // parameter -> output -> % for each %
  for (const JsonValue& output : summary["outputs"].items())
    for (const JsonValue& one : output["sensitivities"].items()) {
      const std::string name = output["name"].text_or(), parameter = one["parameter"].text_or();
      const std::string block = fmt::format("bonds.{}", one["block"].whole().value_or(0));
      table.rows.push_back({name, parameter, block, field(one["value"].number()),
                            field(one["derivative"].number()), field(one["elasticity"].number())});
      if (outputs.empty() || outputs.back() != name) outputs.push_back(name);
      elasticities[block + '.' + parameter][double(outputs.size() - 1)] = one["elasticity"].number_or_nan();
    }
  put_table(run.tables, std::move(table));
  PagePlot plot{"Relative sensitivities", PagePlot::Kind::xy, {"output"}, {"% for each %"}, {}};
  plot.x.categories = outputs;
  for (const auto& [parameter, values] : elasticities) {
    PageSeries series{parameter, {}, {}, PageSeries::Draw::points};
    for (const auto& [x, y] : values) {
      series.x.push_back(x);
      series.y.push_back(y);
    }
    plot.series.push_back(std::move(series));
  }
  put_plot(run.plots, std::move(plot));
}

}  // namespace bondstatic
