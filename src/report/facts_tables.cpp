#include "report/facts_tables.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "bondstatic/version.hpp"

namespace bondstatic {

namespace {

std::string laws_text(const JsonValue& laws) {
  std::string text;
  for (const auto& [law, bonds] : laws.members()) {
    const auto count = bonds.number();
    if (count && *count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", *count, law);
  }
  return text;
}

PageField name_field(const JsonValue& load_case) {
  return field(load_case["name"].text());
}

}  // namespace

std::optional<std::string> place_text(const JsonValue& place) {
  for (const char* kind : {"particle", "bond"})
    if (const auto id = place[kind].whole()) return fmt::format("{} {}", kind, *id);
  return std::nullopt;
}

void put_heading(PageRun& run, const JsonValue& summary) {
  const auto stamp = summary["bondstatic"].text();
  if (!stamp) summary["bondstatic"].refuse("the version that wrote it");
  const std::string file = summary["case"].text_or();
  run.title = summary["title"].text_or();
  if (run.title.empty()) run.title = std::filesystem::path(file).filename().string();
  for (const JsonValue& warning : summary["warnings"].items()) run.warnings.push_back(warning.text_or());
  if (*stamp != version())
    run.notes.push_back(
        fmt::format("Written by bondstatic {}, shown by {}: what {} does not know is left out.", *stamp,
                    version(), version()));
}

void put_model(PageRun& run, const JsonValue& summary) {
  const JsonValue counts = summary["counts"];
  Facts facts("What was solved");
  facts.add("case", summary["case"].text())
      .add("particles", counts["particles"].number())
      .add("bonds", counts["bonds"].number())
      .add("bonds by law", laws_text(counts["bonds_by_law"]))
      .add("supported particles", counts["supported_particles"].number())
      .add("load cases", counts["load_cases"].number())
      .add("unknowns", counts["unknowns"].number())
      .add("units", summary["units"].text())
      .add("written by", "bondstatic " + summary["bondstatic"].text_or());
  std::move(facts).put_into(run.tables);
}

void put_solver(PageRun& run, const JsonValue& summary) {
  const JsonValue solver = summary["solver"];
  Facts facts("Solver");
  const auto iterations = solver["iterations"].number();
  facts.add("solver", solver["name"].text())
      .add("chosen because", solver["reason"].text())
      .add("iterations", iterations && *iterations > 0 ? iterations : std::nullopt)
      .add("threads", solver["threads"].number())
      .add("threads asked for", solver["threads_asked"].number())
      .add("ordering", solver["ordering"].text())
      .add("unknowns", solver["unknowns"].number())
      .add("entries of the matrix", solver["matrix_entries"].number())
      .add("entries of the factor", solver["factor_entries"].number())
      .add("operations of a factorisation", solver["factor_flops"].number())
      .add("factorisations", solver["factorisations"].number())
      .add("analyses", solver["analyses"].number());
  std::move(facts).put_into(run.tables);
}

void put_accuracy(PageRun& run, const JsonValue& summary) {
  PageTable table{"Accuracy",
                  {"load case", "backward error", "forward error", "refinements", "pivot ratio",
                   "balance of forces", "balance of moments", "energy against work"},
                  {},
                  "Relative. The forward error bounds what displacements are off; balances are what is left "
                  "of loads and reactions."};
  const auto add = [&](PageField name, const JsonValue& accuracy) {
    table.rows.push_back({std::move(name), field(accuracy["backward_error"].number()),
                          field(accuracy["forward_error"].number()), field(accuracy["refinements"].number()),
                          field(accuracy["pivot_ratio"].number()), field(accuracy["force_balance"].number()),
                          field(accuracy["moment_balance"].number()),
                          field(accuracy["energy_balance"].number())});
  };
  const std::vector<JsonValue> cases = summary["load_cases"].items();
  for (const JsonValue& one : cases)
    if (one.has("accuracy")) add(name_field(one), one["accuracy"]);
  if (table.rows.size() != 1 && summary.has("accuracy"))
    add(table.rows.empty() ? PageField() : "worst of all", summary["accuracy"]);
  put_table(run.tables, std::move(table));
}

void put_time_and_memory(PageRun& run, const JsonValue& summary) {
  PageTable table{"Time", {"phase", "time, s", "part, %"}, {}};
  const std::vector<JsonValue> phases = summary["phases"].items();
  double all = 0;
  for (const JsonValue& phase : phases) all += phase["seconds"].number().value_or(0);
  for (const JsonValue& phase : phases) {
    const auto seconds = phase["seconds"].number();
    if (seconds)
      table.rows.push_back(
          {phase["name"].text_or(), *seconds, all > 0 ? PageField(100 * *seconds / all) : PageField()});
  }
  if (!table.rows.empty()) table.rows.push_back({"all", all, all > 0 ? PageField(100.0) : PageField()});
  put_table(run.tables, std::move(table));

  constexpr double megabyte = 1e6;
  const auto megabytes = [&](const char* name) -> std::optional<double> {
    const auto bytes = summary["memory"][name].number();
    return bytes ? std::optional(*bytes / megabyte) : std::nullopt;
  };
  Facts memory("Memory");
  memory.add("predicted for the solve, MB", megabytes("predicted_bytes"))
      .add("peak of the process, MB", megabytes("peak_bytes"));
  std::move(memory).put_into(run.tables);
}

std::vector<PageField> displacement_fields(const JsonValue& largest) {
  std::vector<PageField> fields{field(largest["magnitude"].number()), field(place_text(largest))};
  const std::vector<JsonValue> components = largest["components"].items();
  for (std::size_t i = 0; i < 3; ++i)
    fields.push_back(i < components.size() ? field(components[i].number()) : PageField());
  return fields;
}

void put_load_cases(PageRun& run, const JsonValue& summary) {
  const PageUnits units = units_of(summary);
  PageTable table{
      "Load cases",
      {"load case", units.in("largest displacement", "m"), "at", units.in("ux", "m"), units.in("uy", "m"),
       units.in("uz", "m"), units.in("strain energy", "J"), units.in("work", "J")},
      {}};
  for (const JsonValue& one : summary["load_cases"].items()) {
    std::vector<PageField> row{name_field(one)};
    for (PageField& part : displacement_fields(one["largest_displacement"])) row.push_back(std::move(part));
    row.push_back(field(one["energy"].number()));
    row.push_back(field(one["work"].number()));
    table.rows.push_back(std::move(row));
  }
  put_table(run.tables, std::move(table));
}

void put_left_out(PageRun& run, const JsonValue& summary) {
  constexpr std::size_t most = 50;
  PageTable table{"Left out: nothing supports them", {"body", "particles", "ids"}, {}};
  const std::vector<JsonValue> bodies = summary["dropped"].items();
  for (std::size_t b = 0; b < std::min(most, bodies.size()); ++b)
    table.rows.push_back({double(b + 1), double(bodies[b].items().size()), id_text(bodies[b])});
  if (bodies.size() > most) table.note = fmt::format("The first {} of {} bodies.", most, bodies.size());
  put_table(run.tables, std::move(table));
}

}  // namespace bondstatic
