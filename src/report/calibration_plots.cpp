#include "report/calibration_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "report/page_parts.hpp"

namespace bondstatic {

namespace {

const double nan = std::nan("");

std::string target_name(const JsonValue& target) {
  const std::string output = target["output"].text_or(), test = target["test"].text_or();
  return test.empty() ? output : output + ", " + test;
}

/// All of them: how far off they are in their tolerances or, where there are none, in parts of what is
/// wanted.
void put_all_targets(PageRun& run, const std::vector<JsonValue>& targets) {
  const bool tolerances = std::all_of(targets.begin(), targets.end(), [](const JsonValue& one) {
    return one["tolerance"].number().value_or(0) > 0;
  });
  PagePlot plot{"Achieved against wanted",
                PagePlot::Kind::xy,
                {"target"},
                {tolerances ? "achieved - wanted, in tolerances" : "achieved - wanted, over wanted"},
                {}};
  PageSeries wanted{"wanted", places(targets.size()), std::vector<double>(targets.size(), 0.0),
                    PageSeries::Draw::points},
      achieved = wanted;
  wanted.reference = true;
  achieved.name = "achieved";
  achieved.y.clear();
  for (const JsonValue& one : targets) {
    plot.x.categories.push_back(target_name(one));
    const double apart = one["achieved"].number_or_nan() - one["wanted"].number_or_nan();
    const double over =
        tolerances ? one["tolerance"].number_or_nan() : std::abs(one["wanted"].number_or_nan());
    achieved.y.push_back(over > 0 ? apart / over : nan);
  }
  if (tolerances) {
    wanted.name = "wanted, with its tolerance";
    wanted.low.assign(targets.size(), -1);
    wanted.high.assign(targets.size(), 1);
  }
  plot.series = {std::move(wanted), std::move(achieved)};
  put_plot(run.plots, std::move(plot));
}

}  // namespace

void put_targets_plots(PageRun& run, const JsonValue& calibration) {
  const std::vector<JsonValue> targets = calibration["targets"].items();
  put_all_targets(run, targets);
  std::map<std::string, std::vector<JsonValue>> by_output;
  for (const JsonValue& one : targets) by_output[one["output"].text_or()].push_back(one);
  for (const auto& [output, several] : by_output) {
    if (several.size() < 2) continue;
    PagePlot plot{output + " in each test", PagePlot::Kind::xy, {"test"}, {output}, {}};
    PageSeries wanted{"wanted", places(several.size()), {}, PageSeries::Draw::points}, achieved = wanted;
    achieved.name = "achieved";
    wanted.reference = true;
    for (const JsonValue& one : several) {
      plot.x.categories.push_back(one["test"].text_or());
      achieved.y.push_back(one["achieved"].number_or_nan());
      wanted.y.push_back(one["wanted"].number_or_nan());
      const double tolerance = one["tolerance"].number_or_nan();
      wanted.low.push_back(wanted.y.back() - tolerance);
      wanted.high.push_back(wanted.y.back() + tolerance);
    }
    plot.series = {std::move(wanted), std::move(achieved)};
    put_plot(run.plots, std::move(plot));
  }
}

void put_parameter_plot(PageRun& run, const JsonValue& calibration) {
  const std::vector<JsonValue> parameters = calibration["parameters"].items();
  PagePlot plot{
      "Parameters between their bounds",
      PagePlot::Kind::xy,
      {"parameter"},
      {"part of the way from the lower to the upper bound"},
      {},
      {},
      "Logarithmic where a parameter is scaled so. Bars are 95 % intervals; there is none where the tests "
      "cannot tell, or a bound holds the parameter."};
  PageSeries found{"calibrated", places(parameters.size()), {}, PageSeries::Draw::points}, start = found;
  start.name = "start";
  for (const JsonValue& one : parameters) {
    plot.x.categories.push_back(one["name"].text_or());
    const bool log = one["scale"].text_or() == "log";
    const auto scaled = [&](const char* key) {
      const double value = one[key].number_or_nan();
      return log ? (value > 0 ? std::log(value) : nan) : value;
    };
    const double low = scaled("min"), high = scaled("max");
    const auto part = [&](const char* key) { return high > low ? (scaled(key) - low) / (high - low) : nan; };
    start.y.push_back(part("start"));
    found.y.push_back(part("value"));
    found.low.push_back(part("lower_95"));
    found.high.push_back(part("upper_95"));
  }
  const double last = double(parameters.size()) - 1;
  plot.series = {std::move(found), std::move(start), limit_line("upper bound", 1, 0, last),
                 limit_line("lower bound", 0, 0, last)};
  put_plot(run.plots, std::move(plot));
}

void put_calibration_history(PageRun& run, const JsonValue& calibration) {
  const std::vector<JsonValue> history = calibration["history"].items();
  PagePlot cost{"Cost of each evaluation", PagePlot::Kind::xy, {"evaluation"}, {"cost", "", true}, {}};
  PageSeries taken{"steps taken", {}, {}, PageSeries::Draw::line_and_points},
      refused{"steps taken back", {}, {}, PageSeries::Draw::points};
  for (std::size_t i = 0; i < history.size(); ++i) {
    PageSeries& series = history[i]["accepted"].flag().value_or(true) ? taken : refused;
    series.x.push_back(double(i + 1));
    series.y.push_back(history[i]["cost"].number_or_nan());
  }
  cost.series = {std::move(taken), std::move(refused)};
  cost.note = "Half the sum of squares that is made least.";
  put_plot(run.plots, std::move(cost));

  constexpr std::size_t most = 20;
  const std::vector<JsonValue> parameters = calibration["parameters"].items();
  for (std::size_t p = 0; p < std::min(most, parameters.size()); ++p) {
    const JsonValue& parameter = parameters[p];
    const std::string name = parameter["name"].text_or();
    PagePlot plot{name + " on its way", PagePlot::Kind::xy, {"evaluation"}, {name}, {}};
    plot.y.log = parameter["scale"].text_or() == "log";
    PageSeries way{"evaluated", {}, {}, PageSeries::Draw::line_and_points},
        result{"calibrated, 95 % interval", {}, {}, PageSeries::Draw::points};
    for (std::size_t i = 0; i < history.size(); ++i) {
      way.x.push_back(double(i + 1));
      way.y.push_back(history[i]["parameters"][name].number_or_nan());
    }
    result.x = {double(history.size())};
    result.y = {parameter["value"].number_or_nan()};
    const double low = parameter["lower_95"].number_or_nan(), high = parameter["upper_95"].number_or_nan();
    if (!std::isnan(low) && !std::isnan(high)) {
      result.low = {low};
      result.high = {high};
    }
    plot.series = {std::move(way), std::move(result)};
    put_plot(run.plots, std::move(plot));
  }
  if (parameters.size() > most)
    run.notes.push_back(fmt::format("The way of the first {} of {} parameters.", most, parameters.size()));
}

}  // namespace bondstatic
