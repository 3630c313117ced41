#include "app/compare_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report.hpp"
#include "app/terminal.hpp"

namespace bondstatic {

namespace {

std::string share(double value) {
  return std::isnan(value) ? "" : fmt::format("{:.1e}", value);
}

std::string scale_text(double value) {
  return std::isnan(value) ? "" : fmt::format("{:.6f}", value);
}

std::string vector_text(const Vector3& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x(), v.y(), v.z());
}

std::string place_of(const Case& given, const FieldComparison& field) {
  if (field.at < 0) return "";
  const auto at = std::size_t(field.at);
  return field.of_bond ? fmt::format("bond {}", given.model.bonds[at].id)
                       : fmt::format("particle {}", given.model.particles[at].id);
}

TextTable field_table(const Case& given, const Comparison& c) {
  TextTable table{{{"relative difference", "norm", "largest", "best-fit scale", "left then", "largest at"}},
                  {false, true, true, true, true, false}};
  for (const FieldComparison& field : c.fields)
    table.rows.push_back({field.field, share(field.difference), share(field.largest), scale_text(field.scale),
                          share(field.misfit), place_of(given, field)});
  return table;
}

TextTable worst_table(const Case& given, const Comparison& c) {
  TextTable table{{{"particle", "static", "run", "difference"}}, {true, false, false, true}};
  for (const WorstParticle& one : c.worst) {
    const Vector3 statics = one.statics.head<3>(), run = one.run.head<3>();
    table.rows.push_back({std::to_string(given.model.particles[std::size_t(one.particle)].id),
                          vector_text(statics), vector_text(run),
                          fmt::format("{:.2e}", (run - statics).norm())});
  }
  return table;
}

void add_row(TextTable& table, const char* name, const std::string& text) {
  if (!text.empty()) table.rows.push_back({name, wrapped(text, 12)});
}

std::string carried_text(const Unbalance& u) {
  std::string text;
  if (!std::isnan(u.linear))
    text = fmt::format("{:.1e} of the loads (with finite rotations {:.1e})", u.linear, u.finite);
  if (!std::isnan(u.still_moves))
    text += fmt::format("{}worth {:.1e} of the displacements", text.empty() ? "" : ", ", u.still_moves);
  return text;
}

std::string movement_text(const Unbalance& u) {
  std::string text;
  if (!std::isnan(u.fastest)) text = fmt::format("fastest particle {:.1e}", u.fastest);
  if (!std::isnan(u.kinetic)) text += fmt::format(", kinetic energy {:.1e} of the strain energy", u.kinetic);
  if (!std::isnan(u.net_force))
    text += fmt::format("{}net forces of the run {:.1e} of the loads", text.empty() ? "" : ", ", u.net_force);
  return text;
}

std::string ids_text(const std::vector<Index>& ids, const std::string& what) {
  constexpr std::size_t most = 12;
  if (ids.empty()) return "";
  std::string text = fmt::format("{} {}:", counted(Index(ids.size()), "particle"), what);
  for (std::size_t i = 0; i < std::min(most, ids.size()); ++i) text += fmt::format(" {}", ids[i]);
  return text + (ids.size() > most ? " ..." : "");
}

TextTable suspect_table(const Comparison& c) {
  TextTable table{{{"left", "if the run has"}}, {true, false}};
  for (const Suspect& suspect : c.suspects) table.rows.push_back({share(suspect.left), suspect.text});
  return table;
}

/// Bond forces are known of the last step alone.
std::string difference_of(const Comparison& c, const std::string& name) {
  for (const FieldComparison& field : c.fields)
    if (field.field == name) return share(field.difference);
  return "";
}

TextTable series_table(const std::vector<Comparison>& steps) {
  TextTable table{{{"step"}}, {}};
  for (const FieldComparison& field : steps.back().fields) table.rows.front().push_back(field.field);
  table.rows.front().push_back("verdict");
  table.right.assign(table.rows.front().size() - 1, true);
  for (const Comparison& c : steps) {
    std::vector<std::string> row{std::to_string(c.step)};
    for (const FieldComparison& field : steps.back().fields) row.push_back(difference_of(c, field.field));
    row.push_back(&c == &steps.back() || c.verdict == CompareVerdict::same_state ? name_of(c.verdict)
                                                                                 : "apart");
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

std::string comparison_report(const Case& given, const StaticReport& solved,
                              const std::vector<Comparison>& steps, const std::string& written) {
  const Comparison& c = steps.back();
  std::string text = heading(given, facts_of(given.model));
  text += fmt::format("{}, step {}, beside the static answer{}\n\n", c.run, c.step,
                      c.load_case.empty() ? "" : " of load case " + c.load_case);
  const std::string verdict = std::string(name_of(c.verdict)) + ":";
  text += "  " + bold(verdict, stdout) + wrapped(verdict + " " + c.reason, 4).substr(verdict.size()) + "\n\n";
  if (steps.size() > 1) text += to_text(series_table(steps), 2) + "\n";
  text += to_text(field_table(given, c), 2) + "\n";
  if (!c.suspects.empty()) text += to_text(suspect_table(c), 2) + "\n";
  text += to_text(worst_table(given, c), 2) + "\n";

  TextTable last;
  add_row(last, "carried", carried_text(c.unbalance));
  add_row(last, "movement", movement_text(c.unbalance));
  add_row(last, "missing", ids_text(c.missing, "of the case not in the run"));
  add_row(last, "unknown", ids_text(c.unknown, "of the run not in the case"));
  for (const std::string& note : c.notes) add_row(last, "note", note);
  if (!solved.dropped.empty()) add_row(last, "left out", dropped_text(solved.dropped));
  add_row(last, "written", written);
  return text + to_text(last, 2) + warnings_text(given.warnings) + warnings_text(solved.warnings);
}

}  // namespace bondstatic
