#include <fmt/format.h>

#include <cmath>

#include "report/facts_tables.hpp"
#include "report/page_parts.hpp"
#include "report/pages.hpp"
#include "report/relaxed_case.hpp"

namespace bondstatic {

namespace {

void put_verdict(PageRun& run, const JsonValue& certificate) {
  const auto agrees = certificate["agrees"].flag();
  const auto tolerance = certificate["tolerance"].number();
  Facts facts("Certificate");
  if (agrees && tolerance)
    facts.add("verdict", fmt::format("static answer and explicit run {} within {:g}",
                                     *agrees ? "agree" : "do not agree", *tolerance));
  facts.add("kinematics", certificate["kinematics"].text())
      .add("static answer, s", certificate["static_seconds"].number())
      .add("explicit run, s", certificate["dynamic_seconds"].number())
      .add("explicit run over static answer", certificate["ratio"].number());
  std::move(facts).put_into(run.tables);
}

struct Order {
  const char *name, *key;
};
/// The first order is what may not be; the others come with finite rotations.
constexpr Order orders[] = {
    {"first order", "first_order"}, {"second order", "second_order"}, {"third order", "third_order"}};

PageField within(const JsonValue& difference, double tolerance) {
  const auto first = difference["first_order"].number();
  if (std::isnan(tolerance)) return {};
  return first && *first <= tolerance ? "yes" : "no";
}

void put_differences(PageRun& run, const JsonValue& load_case, double tolerance, bool finite) {
  const std::string name = load_case["name"].text_or();
  const std::vector<JsonValue> differences = load_case["differences"].items();
  PageTable table{"Static answer and explicit run" + suffix_of(name),
                  {"relative difference", "largest", "norm", "first order", "second order", "third order",
                   "within", "largest at"},
                  {},
                  finite ? "Of the load: motions of finite rotations differ from the linear answer at second "
                           "order. Only the first order is held against the tolerance."
                         : ""};
  PagePlot plot{
      "Differences" + suffix_of(name), PagePlot::Kind::xy, {"field"}, {"relative difference", "", true}, {}};
  PageSeries largest{"largest", places(differences.size()), {}, PageSeries::Draw::points};
  std::vector<PageSeries> by_order;
  for (const Order& order : orders) {
    by_order.push_back(largest);
    by_order.back().name = order.name;
  }
  for (const JsonValue& one : differences) {
    plot.x.categories.push_back(one["field"].text_or());
    largest.y.push_back(one["largest"].number_or_nan());
    std::vector<PageField> row{plot.x.categories.back(), field(one["largest"].number()),
                               field(one["norm"].number())};
    for (std::size_t i = 0; i < by_order.size(); ++i) {
      by_order[i].y.push_back(one[orders[i].key].number_or_nan());
      row.push_back(field(one[orders[i].key].number()));
    }
    row.push_back(within(one, tolerance));
    row.push_back(field(place_text(one["largest_at"])));
    table.rows.push_back(std::move(row));
  }
  put_table(run.tables, std::move(table));
  plot.series.push_back(std::move(largest));
  // Small kinematics know but one order.
  if (finite)
    for (PageSeries& series : by_order) plot.series.push_back(std::move(series));
  if (!std::isnan(tolerance))
    plot.series.push_back(limit_line(finite ? "tolerance on the first order" : "tolerance", tolerance, 0,
                                     double(differences.size()) - 1));
  put_plot(run.plots, std::move(plot));
}

void put_static_accuracy(PageRun& run, const std::vector<JsonValue>& cases,
                         const std::vector<std::string>& names) {
  PageTable table{"Accuracy of the static answer",
                  {"load case", "backward error", "forward error", "energy against work"},
                  {}};
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const JsonValue accuracy = cases[c]["static"];
    table.rows.push_back({field(std::optional(names[c])), field(accuracy["backward_error"].number()),
                          field(accuracy["forward_error"].number()),
                          field(accuracy["energy_balance"].number())});
  }
  put_table(run.tables, std::move(table));
}

void put_frequencies(PageRun& run, const std::vector<JsonValue>& runs, const std::vector<std::string>& names,
                     const PageUnits& units) {
  PagePlot plot{"Lowest frequencies",
                PagePlot::Kind::xy,
                {"mode"},
                {"angular frequency", units.si ? "rad/s" : "rad per time"},
                {}};
  for (std::size_t c = 0; c < runs.size(); ++c) {
    PageSeries series{names[c].empty() ? "model" : names[c], {}, {}, PageSeries::Draw::points};
    for (const JsonValue& frequency : runs[c]["plan"]["lowest_frequencies"].items()) {
      series.x.push_back(double(series.x.size() + 1));
      series.y.push_back(frequency.number_or_nan());
    }
    plot.series.push_back(std::move(series));
  }
  plot.y.log = wants_log(plot.series);
  put_plot(run.plots, std::move(plot));
}

}  // namespace

FoundRun check_page(const std::string&, const JsonValue& certificate) {
  FoundRun found;
  PageRun& run = found.page;
  run.kind = "check";
  const PageUnits units = units_of(certificate);
  found.si = units.si;
  put_heading(run, certificate);
  put_verdict(run, certificate);
  const double tolerance = certificate["tolerance"].number_or_nan();
  const bool finite = certificate["kinematics"].text_or() == "finite";
  const std::vector<JsonValue> cases = certificate["load_cases"].items();
  std::vector<std::string> names;
  std::vector<JsonValue> runs;
  for (const JsonValue& one : cases) {
    put_differences(run, one, tolerance, finite);
    names.push_back(one["name"].text_or());
    runs.push_back(one["run"]);
  }
  put_relaxed_cases(run, runs, names, units);
  put_frequencies(run, runs, names, units);
  put_static_accuracy(run, cases, names);
  put_model(run, certificate);
  return found;
}

}  // namespace bondstatic
