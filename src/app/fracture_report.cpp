#include "app/fracture_report.hpp"

#include <fmt/format.h>

#include "app/report.hpp"
#include "app/terminal.hpp"
#include "results/fracture_series.hpp"
#include "results/fracture_words.hpp"

namespace bondstatic {

namespace {

/// "load 12.4 N, displacement 0.001 m (factor 0.5)"
std::string place_text(const Case& given, const FractureEvent& event) {
  const FractureWords words = fracture_words(given.model, given.fracture);
  const auto number = [&](const std::string& name, double value, const std::string& unit) {
    return fmt::format("{} {:.7g}{}", name, value, given.si && !unit.empty() ? " " + unit : "");
  };
  return fmt::format("{}, {} (factor {:.7g})", number(words.load, event.load, words.load_unit),
                     number(words.displacement, event.displacement, words.displacement_unit), event.factor);
}

std::string bonds_text(const Model& model, const FractureEvent& event) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t i = 0; i < event.bonds.size() && i < most; ++i) {
    const Bond& bond = model.bonds[std::size_t(event.bonds[i].bond)];
    const std::string mode = mode_name(model, event.bonds[i]);
    text += fmt::format("{}bond {} ({} to {}){}", i == 0 ? "" : ", ", bond.id,
                        model.particles[std::size_t(bond.a)].id, model.particles[std::size_t(bond.b)].id,
                        mode.empty() ? "" : " by " + mode);
  }
  return text + (event.bonds.size() > most ? fmt::format(" and {} more", event.bonds.size() - most) : "");
}

std::string modes_text(const Model& model, const Fracture& fracture) {
  std::string text;
  for (const auto& [mode, count] : breaks_by_mode(model, fracture))
    if (!mode.empty()) text += fmt::format("{}{} by {}", text.empty() ? "" : ", ", count, mode);
  return text;
}

void add_events(const Case& given, const Fracture& fracture, TextTable& table) {
  const FractureEvent &first = fracture.events.front(), &peak = *peak_of(fracture);
  table.rows.push_back(
      {"first break",
       wrapped(fmt::format("{}: {}", place_text(given, first), bonds_text(given.model, first)), 15)});
  table.rows.push_back({"peak", place_text(given, peak)});
  const Index avalanches = fracture.events.back().avalanche, breaks = count_breaks(fracture);
  const std::string modes = modes_text(given.model, fracture);
  table.rows.push_back(
      {"broken",
       fmt::format("{} in {}, {}{}", counted(breaks, "bond"), counted(Index(fracture.events.size()), "event"),
                   counted(avalanches, "avalanche"), modes.empty() ? "" : ": " + modes)});
}

std::string separated_text(const Fracture& fracture) {
  std::size_t particles = 0;
  for (const SeparatedBody& body : fracture.separated) particles += body.particles.size();
  return fmt::format("{} of {}, the first after event {}", counted(Index(fracture.separated.size()), "body"),
                     counted(Index(particles), "particle"), fracture.separated.front().event + 1);
}

void add_accuracy(const Fracture& fracture, TextTable& table) {
  const FractureReport& report = fracture.report;
  if (const FractureEvent* last = last_standing(fracture))
    table.rows.push_back(
        {"energies", fmt::format("work {:.6g}, strain {:.6g}, dissipated {:.6g}; balance {:.1e}", last->work,
                                 last->strain_energy, last->dissipated, report.energy_balance)});
  table.rows.push_back({"accuracy", fmt::format("relative error at most {:.1e} (backward error {:.1e})",
                                                report.forward_error, report.backward_error)});
  const Index breaks = count_breaks(fracture);
  const std::string each =
      breaks > 0 ? fmt::format(", {} a break", seconds_text(report.seconds / double(breaks))) : "";
  std::string solved = counted(report.first.analysis.unknowns, "unknown");
  if (!report.first.solver.empty()) solved += " by " + report.first.solver;
  table.rows.push_back(
      {"run",
       fmt::format("{} ({}) in {}{}; {}", solved, counted(report.first.threads, "thread"),
                   seconds_text(report.seconds), each, counted(report.factorisations, "factorisation"))});
}

}  // namespace

std::string progress_text(const FractureProgress& progress) {
  const double part = progress.largest_load > 0 ? progress.load / progress.largest_load : 0;
  return fmt::format("fracture: {}, {} broken, factor {:.4g}, load {:.2f} of the largest",
                     counted(progress.events, "event"), counted(progress.breaks, "bond"), progress.factor,
                     part);
}

std::string fracture_report(const Case& given, const Fracture& fracture,
                            const std::vector<OutputValue>& outputs, const std::string& folder,
                            const std::vector<std::string>& files) {
  std::string text = heading(given, facts_of(given.model)) + "\n";
  if (!outputs.empty()) text += outputs_table(outputs, false) + "\n";
  TextTable table;
  if (!fracture.events.empty()) add_events(given, fracture, table);
  const std::string end = text_of(fracture.end);
  table.rows.push_back(
      {"end", wrapped(bold(end, stdout) +
                          (fracture.reason.empty() || fracture.reason == end ? "" : ": " + fracture.reason),
                      15)});
  if (!fracture.separated.empty()) table.rows.push_back({"separated", separated_text(fracture)});
  add_accuracy(fracture, table);
  const auto& dropped = fracture.report.first.dropped;
  if (!dropped.empty()) table.rows.push_back({"left out", dropped_text(dropped)});
  if (!files.empty())
    table.rows.push_back({"written", wrapped(written_text(folder, files, fracture_kind), 15)});
  text += to_text(table, 2) + warnings_text(given.warnings) + warnings_text(fracture.report.first.warnings);
  return text + warnings_text(fracture.warnings);
}

}  // namespace bondstatic
