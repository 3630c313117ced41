#include <fmt/format.h>

#include "report/facts_tables.hpp"
#include "report/found_states.hpp"
#include "report/output_plots.hpp"
#include "report/page_parts.hpp"
#include "report/pages.hpp"

namespace bondstatic {

namespace {

void put_matrix(PageRun& run, const std::string& title, const JsonValue& effective, const char* which) {
  const std::vector<JsonValue> order = effective["order"].items(), rows = effective[which].items();
  PageTable table{title, {"stress of"}, {}};
  for (const JsonValue& name : order) table.columns.push_back(name.text_or());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<PageField> row{i < order.size() ? order[i].text_or() : ""};
    for (const JsonValue& one : rows[i].items()) row.push_back(field(one.number()));
    row.resize(table.columns.size());
    table.rows.push_back(std::move(row));
  }
  put_table(run.tables, std::move(table));
}

void put_effective_stiffness(PageRun& run, const JsonValue& summary) {
  const JsonValue effective = summary["effective_stiffness"], isotropic = effective["isotropic"];
  const PageUnits units = units_of(summary);
  put_matrix(run, units.in("Effective stiffness", "Pa"), effective, "stiffness");
  Facts facts("Effective stiffness: the nearest isotropic one");
  facts.add(units.in("Young's modulus", "Pa"), isotropic["young"].number())
      .add("Poisson's ratio", isotropic["poisson"].number())
      .add("relative distance from it", isotropic["misfit"].number())
      .add(units.in("volume of the cell", "m³"), effective["volume"].number())
      .add("asymmetry of the matrix", effective["asymmetry"].number());
  std::move(facts).put_into(run.tables);
  put_matrix(run, units.in("Voigt bound: nothing moves but with the strain", "Pa"), effective, "voigt_bound");
}

void put_stresses(PageRun& run, const JsonValue& summary) {
  const PageUnits units = units_of(summary);
  for (const JsonValue& one : summary["load_cases"].items())
    for (const bool stress : {false, true}) {
      const std::string name = stress ? units.in("Stress", "Pa") : "Strain";
      PageTable table{name + suffix_of(one["name"].text_or()), {"", "x", "y", "z"}, {}};
      const std::vector<JsonValue> rows = one[stress ? "stress" : "strain"].items();
      for (std::size_t i = 0; i < rows.size() && i < 3; ++i) {
        std::vector<PageField> row{table.columns[i + 1]};
        for (const JsonValue& part : rows[i].items()) row.push_back(field(part.number()));
        row.resize(table.columns.size());
        table.rows.push_back(std::move(row));
      }
      put_table(run.tables, std::move(table));
    }
}

/// What the law itself is off in rows of bonds.
void put_bond_laws(PageRun& run, const JsonValue& summary) {
  PageTable table{"Bond laws beside the Timoshenko beam",
                  {"bonds", "law", "number", "length over diameter", "deflection of their rows off, %",
                   "of one bond off, %", "shear stiffness off, %", "advice"},
                  {},
                  "Medians of each block of bonds."};
  constexpr double percent = 100;
  for (const JsonValue& block : summary["resolution"].items()) {
    const auto median = [&](const char* of, double times) -> PageField {
      const auto value = block[of]["median"].number();
      return value ? PageField(times * *value) : PageField();
    };
    std::string advice;
    for (const JsonValue& sentence : block["advice"].items())
      advice += (advice.empty() ? "" : "; ") + sentence.text_or();
    table.rows.push_back(
        {fmt::format("bonds.{}", block["block"].whole().value_or(0)), field(block["law"].text()),
         field(block["bonds"].number()), median("slenderness", 1), median("deflection_error", percent),
         median("deflection_error_of_one_bond", percent), median("transverse_stiffness_error", percent),
         advice.empty() ? PageField() : PageField(advice)});
  }
  put_table(run.tables, std::move(table));
}

}  // namespace

FoundRun solve_page(const std::string& folder, const JsonValue& summary) {
  FoundRun found;
  PageRun& run = found.page;
  run.kind = "solve";
  found.si = units_of(summary).si;
  put_heading(run, summary);
  put_outputs(run, summary, true);
  put_sensitivities(run, summary);
  put_load_cases(run, summary);
  put_effective_stiffness(run, summary);
  put_stresses(run, summary);
  put_model(run, summary);
  put_accuracy(run, summary);
  put_solver(run, summary);
  put_time_and_memory(run, summary);
  put_bond_laws(run, summary);
  put_left_out(run, summary);
  found.states = load_case_states(folder, summary, run);
  return found;
}

}  // namespace bondstatic
