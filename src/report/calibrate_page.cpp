#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/calibration_plots.hpp"
#include "report/facts_tables.hpp"
#include "report/page_parts.hpp"
#include "report/pages.hpp"

namespace bondstatic {

namespace {

void put_outcome(PageRun& run, const JsonValue& calibration) {
  const auto converged = calibration["converged"].flag(), reached = calibration["reached"].flag();
  const std::size_t evaluations = calibration["history"].items().size();
  Facts facts("Calibration");
  if (converged) facts.add("minimum found", *converged ? "yes" : "no");
  if (reached) facts.add("targets reached", *reached ? "yes" : "no");
  facts.add("because", calibration["reason"].text())
      .add("evaluations", double(evaluations))
      .add("solves", calibration["solves"].number())
      .add("first evaluation, s", calibration["seconds"]["first"].number())
      .add("a later one, s", calibration["seconds"]["later"].number());
  std::move(facts).put_into(run.tables);
}

void put_parameters(PageRun& run, const JsonValue& calibration) {
  PageTable table{"Parameters",
                  {"parameter", "value", "95 % from", "95 % to", "start", "lower bound", "upper bound",
                   "scale", "held by a bound"},
                  {}};
  for (const JsonValue& one : calibration["parameters"].items()) {
    const bool held = one["at_bound"].flag().value_or(false);
    table.rows.push_back(
        {one["name"].text_or(), field(one["value"].number()), field(one["lower_95"].number()),
         field(one["upper_95"].number()), field(one["start"].number()), field(one["min"].number()),
         field(one["max"].number()), field(one["scale"].text()), held ? PageField("yes") : PageField()});
  }
  put_table(run.tables, std::move(table));
}

void put_targets(PageRun& run, const JsonValue& calibration) {
  PageTable table{
      "Targets",
      {"output", "test", "wanted", "achieved", "difference", "tolerance", "in tolerances", "weight"},
      {}};
  for (const JsonValue& one : calibration["targets"].items()) {
    const auto wanted = one["wanted"].number(), achieved = one["achieved"].number(),
               tolerance = one["tolerance"].number();
    const auto apart = wanted && achieved ? std::optional(*achieved - *wanted) : std::nullopt;
    table.rows.push_back({one["output"].text_or(), field(one["test"].text()), field(wanted), field(achieved),
                          field(apart), field(tolerance),
                          tolerance ? field(one["residual"].number()) : PageField(),
                          tolerance ? PageField() : field(one["weight"].number())});
  }
  put_table(run.tables, std::move(table));
}

void put_certainty(PageRun& run, const JsonValue& calibration) {
  std::vector<std::string> names;
  for (const JsonValue& one : calibration["parameters"].items()) names.push_back(one["name"].text_or());

  PageTable correlation{"Correlation of the parameters", {"parameter"}, {}};
  correlation.columns.insert(correlation.columns.end(), names.begin(), names.end());
  const std::vector<JsonValue> rows = calibration["correlation"].items();
  bool known = false;
  for (std::size_t i = 0; i < std::min(rows.size(), names.size()); ++i) {
    std::vector<PageField> row{names[i]};
    for (const JsonValue& one : rows[i].items()) {
      row.push_back(field(one.number()));
      known |= one.there();
    }
    row.resize(correlation.columns.size());
    correlation.rows.push_back(std::move(row));
  }
  if (known && names.size() > 1) run.tables.push_back(std::move(correlation));

  PageTable unseen{"What the tests cannot tell apart", {"why"}, {}, "A direction that no target sees."};
  unseen.columns.insert(unseen.columns.end(), names.begin(), names.end());
  for (const JsonValue& one : calibration["unidentified"].items()) {
    const std::string sentence = one["sentence"].text_or();
    run.warnings.push_back("Not told apart: " + sentence + ".");
    std::vector<PageField> row{sentence};
    for (const std::string& name : names) row.push_back(field(one["direction"][name].number()));
    unseen.rows.push_back(std::move(row));
  }
  put_table(run.tables, std::move(unseen));

  PageTable scatter{
      "Scatter of the tests", {"output", "tests", "mean", "standard deviation", "over the mean"}, {}};
  for (const JsonValue& one : calibration["scatter"].items()) {
    const auto mean = one["mean"].number(), deviation = one["standard_deviation"].number();
    const bool ratio = mean && deviation && *mean != 0;
    scatter.rows.push_back({one["output"].text_or(), field(one["tests"].number()), field(mean),
                            field(deviation), ratio ? PageField(*deviation / std::abs(*mean)) : PageField()});
  }
  put_table(run.tables, std::move(scatter));

  Facts singular("Singular values of the sensitivities");
  const std::vector<JsonValue> values = calibration["singular_values"].items();
  for (std::size_t i = 0; i < values.size(); ++i) singular.add(std::to_string(i + 1), values[i].number());
  std::move(singular).put_into(run.tables);
}

void put_tests(PageRun& run, const JsonValue& calibration) {
  PageTable table{
      "Tests", {"test", "particles", "bonds", "bond laws", "supported particles", "load cases"}, {}};
  for (const JsonValue& test : calibration["tests"].items()) {
    const JsonValue model = test["model"];
    std::string laws;
    for (const auto& [law, bonds] : model["bonds_by_law"].members())
      if (bonds.number().value_or(0) > 0) laws += (laws.empty() ? "" : ", ") + law;
    table.rows.push_back({test["name"].text_or(), field(model["particles"].number()),
                          field(model["bonds"].number()), laws, field(model["supported_particles"].number()),
                          field(model["load_cases"].number())});
  }
  put_table(run.tables, std::move(table));
  Facts facts("What was calibrated");
  const auto si = calibration["si_units"].flag();
  facts.add("case", calibration["case"].text());
  if (si) facts.add("units", *si ? "SI" : "as given");
  facts.add("written by", "bondstatic " + calibration["bondstatic"].text_or());
  std::move(facts).put_into(run.tables);
}

}  // namespace

FoundRun calibrate_page(const std::string&, const JsonValue& calibration) {
  FoundRun found;
  PageRun& run = found.page;
  run.kind = "calibrate";
  found.si = calibration["si_units"].flag().value_or(false);
  put_heading(run, calibration);
  put_parameters(run, calibration);  // first: the answer
  put_targets(run, calibration);
  put_outcome(run, calibration);
  put_targets_plots(run, calibration);
  put_parameter_plot(run, calibration);
  put_calibration_history(run, calibration);
  put_certainty(run, calibration);
  put_tests(run, calibration);
  return found;
}

}  // namespace bondstatic
