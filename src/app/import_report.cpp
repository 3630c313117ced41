#include "app/import_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report.hpp"
#include "app/terminal.hpp"

namespace bondstatic {
namespace {

std::string list(const std::string& heading, const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += "    " + wrapped(note, 6) + "\n";
  return notes.empty() ? "" : "\n  " + heading + "\n" + text;
}

std::string vector_text(const Vector3& value) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", value.x(), value.y(), value.z());
}

TextTable facts_table(const ImportReport& report) {
  const ForeignModel& model = report.imported.model;
  const PackingFacts& facts = report.facts;
  TextTable table;
  table.rows.push_back({"format", model.format});
  table.rows.push_back(
      {"packing", fmt::format("{}, {}{}", counted(Index(model.particles.size()), "particle"),
                              counted(Index(model.bonds.size()), "bond"), model.si ? ", SI units" : "")});
  table.rows.push_back(
      {"centres", fmt::format("{} to {}", vector_text(facts.lowest), vector_text(facts.highest))});
  table.rows.push_back(
      {"radii", std::isnan(facts.smallest_radius)
                    ? "none given"
                    : fmt::format("{:.6g} to {:.6g}", facts.smallest_radius, facts.largest_radius)});
  if (model.cell)
    table.rows.push_back(
        {"cell", fmt::format("edges {}, {}, {}", vector_text(model.cell->edges.col(0)),
                             vector_text(model.cell->edges.col(1)), vector_text(model.cell->edges.col(2)))});
  if (!model.bonds.empty()) {
    table.rows.push_back(
        {"bonds", fmt::format("{:.3g} a particle (coordination number)", facts.coordination)});
    std::string bodies = fmt::format("{} connected by bonds",
                                     facts.bodies == 1 ? "1 body" : fmt::format("{} bodies", facts.bodies));
    if (facts.bodies > 1)
      bodies += fmt::format(", the largest of {}", counted(facts.largest_body, "particle"));
    if (facts.loose > 0) bodies += fmt::format("; {} without a bond", counted(facts.loose, "particle"));
    table.rows.push_back({"bodies", bodies});
  }
  return table;
}

nlohmann::ordered_json triple(const Vector3& value) {
  return {value.x(), value.y(), value.z()};
}

/// As [cell] of a case takes it; null where nothing is periodic.
nlohmann::ordered_json cell_json(const std::optional<Cell>& cell) {
  if (!cell) return nullptr;
  std::vector<std::string> periodic;
  for (std::size_t i = 0; i < 3; ++i)
    if (cell->periodic[i]) periodic.emplace_back(1, "xyz"[i]);
  return {{"edges", {triple(cell->edges.col(0)), triple(cell->edges.col(1)), triple(cell->edges.col(2))}},
          {"origin", triple(cell->origin)},
          {"periodic", periodic}};
}

}  // namespace

std::string import_report(const ImportReport& report) {
  const ForeignModel& model = report.imported.model;
  std::string text = model.title.empty() ? "" : bold(model.title, stdout) + "\n";
  text += to_text(facts_table(report), 2);
  text += list("taken", model.notes.taken);
  text += list("assumed", model.notes.assumed);
  text += list("left out", model.notes.left_out);
  text += list("to be filled in, in case.toml", report.to_be_filled_in);
  return text + list("written", report.written);
}

std::string import_json(const ImportReport& report) {
  const ForeignModel& model = report.imported.model;
  const PackingFacts& facts = report.facts;
  nlohmann::ordered_json json{
      {"files", report.imported.files},
      {"format", model.format},
      {"title", model.title},
      {"si", model.si},
      {"particles", model.particles.size()},
      {"bonds", model.bonds.size()},
      {"lowest", triple(facts.lowest)},
      {"highest", triple(facts.highest)},
      {"smallest_radius", facts.smallest_radius},  // null where no file has radii
      {"largest_radius", facts.largest_radius},
      {"cell", cell_json(model.cell)},
      {"coordination", facts.coordination},
      {"bodies", facts.bodies},
      {"largest_body", facts.largest_body},
      {"particles_without_bond", facts.loose},
      {"parallel_bonds", report.imported.parallel_bonds},
      {"taken", model.notes.taken},
      {"assumed", model.notes.assumed},
      {"left_out", model.notes.left_out},
      {"to_be_filled_in", report.to_be_filled_in},
      {"written", report.written},
  };
  // What files call themselves may be no UTF-8.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace bondstatic
