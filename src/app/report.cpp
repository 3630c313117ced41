#include "app/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "app/resolution_report.hpp"
#include "app/terminal.hpp"
#include "results/state_series.hpp"

namespace bondstatic {

namespace {

std::string counts(const ModelFacts& model, bool si) {
  std::map<std::string, Index> laws;
  for (const auto& [law, bonds] : model.bonds_by_law)
    if (bonds > 0) laws[law] = bonds;
  std::string by_law;
  for (const auto& [law, count] : laws)
    by_law += (by_law.empty() ? "" : ", ") + (laws.size() == 1 ? law : fmt::format("{} {}", count, law));
  return fmt::format("{}, {}{}, {} supported, {}{}", counted(model.particles, "particle"),
                     counted(model.bonds, "bond"), by_law.empty() ? "" : " (" + by_law + ")",
                     model.supported_particles, counted(Index(model.load_cases.size()), "load case"),
                     si ? ", SI units" : "");
}

}  // namespace

std::string counted(Index count, const std::string& what) {
  if (count == 1) return fmt::format("{} {}", count, what);
  if (what.ends_with('y')) return fmt::format("{} {}ies", count, what.substr(0, what.size() - 1));
  return fmt::format("{} {}s", count, what);
}

std::string written_text(const std::string& folder, const std::vector<std::string>& files,
                         const std::string& kind) {
  std::string names;
  Index states = 0;
  for (const std::string& name : files) {
    const bool state = is_state_file(kind, name);
    states += state;
    if (!state) names += (names.empty() ? "" : ", ") + name;
  }
  return folder + ": " + names + (states > 0 ? "; " + counted(states, "state") + " shown" : "");
}

std::string outputs_table(const std::vector<OutputValue>& outputs, bool judged) {
  TextTable table{{{"output", "value", "expected", "relative error", "source"}},
                  {false, true, true, true, false}};
  for (const OutputValue& output : outputs) {
    std::vector<std::string> row{output.name, fmt::format("{:.10g}", output.value), "", "", ""};
    if (output.expected) {
      const double error = output.relative_error();
      const bool agrees = !judged || error <= output.tolerance;
      row[2] = fmt::format("{:.10g}", *output.expected);
      row[3] = fmt::format("{:.1e}", error);
      row[4] =
          output.source +
          (agrees ? "" : fmt::format("{}outside {:g}", output.source.empty() ? "" : "; ", output.tolerance));
    }
    table.rows.push_back(std::move(row));
  }
  const bool compared = std::any_of(outputs.begin(), outputs.end(),
                                    [](const OutputValue& output) { return output.expected.has_value(); });
  if (!compared)
    for (auto& row : table.rows) row.resize(2);
  return to_text(table, 2);
}

namespace {

/// Nothing where nothing was asked for.
std::string sensitivities_table(const Model& model, const std::vector<OutputValue>& outputs) {
  TextTable table{{{"sensitivity of", "to", "of bonds", "value", "derivative", "% per %"}},
                  {false, false, false, true, true, true}};
  for (const OutputValue& output : outputs)
    for (const ParameterSensitivity& of : output.sensitivities)
      table.rows.push_back({output.name, of.parameter,
                            fmt::format("{}, {}", of.block, model.blocks[std::size_t(of.block)].law),
                            std::isnan(of.value) ? "differs" : fmt::format("{:.7g}", of.value),
                            fmt::format("{:.7g}", of.derivative),
                            std::isnan(of.elasticity) ? "" : fmt::format("{:.4f}", of.elasticity)});
  return table.rows.size() == 1 ? "" : "\n" + to_text(table, 2);
}

}  // namespace

std::string displacement_table(const std::vector<const State*>& states,
                               const std::vector<LargestDisplacement>& largest) {
  TextTable table{{{"load case", "largest displacement", "particle", "ux", "uy", "uz", "energy"}},
                  {false, true, true, true, true, true, true}};
  for (std::size_t c = 0; c < states.size(); ++c) {
    if (!largest[c].particle) continue;
    const State& state = *states[c];
    const Vector3& u = largest[c].displacement;
    table.rows.push_back({state.name.empty() ? "-" : state.name, fmt::format("{:.7g}", u.stableNorm()),
                          std::to_string(*largest[c].particle), fmt::format("{:.7g}", u.x()),
                          fmt::format("{:.7g}", u.y()), fmt::format("{:.7g}", u.z()),
                          fmt::format("{:.7g}", state.energy)});
  }
  return to_text(table, 2);
}

namespace {

std::string effective_text(const EffectiveStiffness& effective) {
  TextTable table{{{"effective stiffness", "xx", "yy", "zz", "yz", "xz", "xy"}},
                  {false, true, true, true, true, true, true}};
  for (int i = 0; i < 6; ++i) {
    std::vector<std::string> row{table.rows.front()[std::size_t(i) + 1]};
    const double noise = 1e-12 * effective.stiffness.cwiseAbs().maxCoeff();
    for (int j = 0; j < 6; ++j)
      row.push_back(std::abs(effective.stiffness(i, j)) <= noise
                        ? "0"
                        : fmt::format("{:.7g}", effective.stiffness(i, j)));
    table.rows.push_back(std::move(row));
  }
  const IsotropicFit bound = isotropic_fit(effective.voigt), &fit = effective.isotropic;
  TextTable lines;
  lines.rows.push_back({"isotropic", fmt::format("E = {:.7g}, nu = {:.7g}, misfit {:.2g} %", fit.young,
                                                 fit.poisson, 100 * fit.misfit)});
  lines.rows.push_back(
      {"Voigt bound", fmt::format("E = {:.7g}, nu = {:.7g} were nothing to move but with the strain",
                                  bound.young, bound.poisson)});
  return to_text(table, 2) + "\n" + to_text(lines, 2);
}

}  // namespace

std::string dropped_text(const std::vector<std::vector<Index>>& dropped) {
  constexpr std::size_t most = 12;
  std::string ids;
  std::size_t particles = 0;
  for (const std::vector<Index>& body : dropped)
    for (const Index id : body)
      if (particles++ < most) ids += fmt::format(" {}", id);
  return fmt::format("{} unsupported, {}:{}{}", counted(Index(dropped.size()), "body"),
                     counted(Index(particles), "particle"), ids, particles > most ? " ..." : "");
}

std::string heading(const Case& given, const ModelFacts& model) {
  return (given.title.empty() ? "" : bold(given.title, stdout) + "\n") + counts(model, given.si) + "\n";
}

std::string warnings_text(const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& warning : warnings) text += fmt::format("  warning: {}\n", warning);
  return text;
}

namespace {

std::string threads(const StaticReport& report) {
  if (report.threads == report.threads_asked) return counted(report.threads, "thread");
  return fmt::format("{} of {}, as the machine is busy", report.threads,
                     counted(report.threads_asked, "thread"));
}

/// What the solve took and how good it is, a line each.
TextTable facts(const StaticSolution& solution) {
  const StaticReport& report = solution.report;
  const Accuracy worst = worst_accuracy(solution);
  double seconds = 0;
  for (const Phase& phase : report.phases) seconds += phase.seconds;
  TextTable table;
  table.rows.push_back(
      {"accuracy",
       fmt::format("relative error at most {:.1e} (backward error {:.1e}, refined {})", worst.forward_error,
                   worst.backward_error,
                   worst.refinements == 1 ? "once" : fmt::format("{} times", worst.refinements))});
  table.rows.push_back(
      {"balance", fmt::format("forces {:.1e}, moments {:.1e}, energy and work {:.1e}", worst.force_balance,
                              worst.moment_balance, worst.energy_balance)});
  table.rows.push_back(
      {"solved", fmt::format("{} by {} ({}) in {}{}", counted(report.analysis.unknowns, "unknown"),
                             report.solver, threads(report), seconds_text(seconds),
                             report.iterations > 0 ? ", " + counted(report.iterations, "iteration") : "")});
  if (!report.solver_reason.empty()) table.rows.push_back({"chosen", report.solver_reason});
  table.rows.push_back(
      {"memory", fmt::format("{} for the solve predicted, {} at the peak of the process",
                             bytes_text(report.analysis.predicted_bytes), bytes_text(report.peak_bytes))});
  if (!report.dropped.empty()) table.rows.push_back({"left out", dropped_text(report.dropped)});
  return table;
}

/// Names of the files; the pieces of a grid, a rank each, are only counted.
std::string names_of(const std::vector<std::string>& files) {
  std::string names;
  Index pieces = 0;
  for (const std::string& file : files) {
    const std::string name = std::filesystem::path(file).filename().string();
    const bool piece = name.starts_with("model_") && name.ends_with(".vtu");
    pieces += piece;
    if (!piece) names += (names.empty() ? "" : ", ") + file;
  }
  return pieces == 0 ? names : fmt::format("{}, and {} of the grid", names, counted(pieces, "piece"));
}

}  // namespace

std::string report(const Case& given, const ModelFacts& model, const Answer& answer,
                   const std::vector<LargestDisplacement>& largest, const std::string& folder,
                   const std::vector<std::string>& files) {
  std::vector<const State*> states;
  for (const State& state : answer.solution.cases) states.push_back(&state);
  std::string text = heading(given, model) + "\n";
  text += given.outputs.empty() ? displacement_table(states, largest) : outputs_table(answer.outputs);
  text += sensitivities_table(given.model, answer.outputs);
  if (answer.solution.effective) text += "\n" + effective_text(*answer.solution.effective);
  TextTable lines = facts(answer.solution);
  for (const std::string& line : resolution_texts(answer.resolution))
    lines.rows.push_back({"bond law", wrapped(line, 12)});
  if (!files.empty())
    lines.rows.push_back({"written", wrapped(fmt::format("{}: {}", folder, names_of(files)), 12)});
  text += "\n" + to_text(lines, 2);
  return text + warnings_text(given.warnings) + warnings_text(answer.solution.report.warnings);
}

std::string report(const Case& given, const Answer& answer, const std::string& folder) {
  const std::vector<std::string> files =
      folder.empty() ? std::vector<std::string>{} : result_files(given.model, answer.outputs);
  return report(given, facts_of(given.model), answer, largest_displacements(given.model, answer.solution),
                folder, files);
}

}  // namespace bondstatic
