#include "app/calibrate_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/report.hpp"
#include "app/terminal.hpp"

namespace bondstatic {

namespace {

std::string number(double value, const char* format = "{:.10g}") {
  return std::isnan(value) ? "" : fmt::format(fmt::runtime(format), value);
}

TextTable parameter_table(const CalibrationProblem& problem, const CalibrationResult& result) {
  TextTable table{{{"parameter", "value", "95 % from", "to", "bounds"}}, {false, true, true, true, false}};
  for (std::size_t p = 0; p < result.parameters.size(); ++p) {
    const CalibratedParameter& found = result.parameters[p];
    const CalibrationParameter& asked = problem.parameters[p];
    table.rows.push_back({found.name, number(found.value), number(found.lower_95, "{:.6g}"),
                          number(found.upper_95, "{:.6g}"),
                          fmt::format("{:.6g} to {:.6g}{}", asked.lower, asked.upper,
                                      found.at_bound ? ", which holds it" : "")});
  }
  return table;
}

std::string in_tolerances(double residual) {
  return fmt::format("{:.3f}", std::abs(residual) < 5e-4 ? 0.0 : residual);
}

void drop_column(TextTable& table, std::size_t column) {
  for (auto& row : table.rows) row.erase(row.begin() + std::ptrdiff_t(column));
  table.right.erase(table.right.begin() + std::ptrdiff_t(column));
}

TextTable target_table(const CalibrationProblem& problem, const CalibrationResult& result) {
  const bool measured = !std::isnan(problem.targets.front().tolerance);
  TextTable table{
      {{"target", "test", "wanted", "achieved", "difference", measured ? "in tolerances" : "relative"}},
      {false, false, true, true, true, true}};
  for (const AchievedTarget& target : result.targets) {
    const double difference = target.achieved - target.wanted;
    const double relative = target.wanted == 0 ? not_given : difference / std::abs(target.wanted);
    table.rows.push_back({target.output, target.test, number(target.wanted), number(target.achieved),
                          fmt::format("{:.2e}", difference),
                          measured ? in_tolerances(target.residual) : number(relative, "{:.1e}")});
  }
  if (problem.tests.size() == 1) drop_column(table, 1);
  return table;
}

/// Empty where it would fill the terminal, or says nothing.
TextTable correlation_table(const CalibrationResult& result) {
  constexpr std::size_t most = 8;
  TextTable table;
  const std::size_t count = result.parameters.size();
  if (count < 2 || count > most || result.correlation.rows() != Index(count)) return table;
  Index told = 0;  // of the pairs; where the tests cannot tell, there is none
  for (Index p = 0; p < Index(count); ++p)
    for (Index q = 0; q < p; ++q) told += !std::isnan(result.correlation(p, q));
  if (told == 0) return table;
  table.rows.push_back({"correlation"});
  table.right.assign(count + 1, true);
  table.right[0] = false;
  for (const CalibratedParameter& parameter : result.parameters) table.rows.front().push_back(parameter.name);
  for (std::size_t p = 0; p < count; ++p) {
    std::vector<std::string> row{result.parameters[p].name};
    for (std::size_t q = 0; q < count; ++q)
      row.push_back(number(result.correlation(Index(p), Index(q)), "{:.4f}"));
    table.rows.push_back(std::move(row));
  }
  return table;
}

TextTable scatter_table(const CalibrationResult& result) {
  TextTable table{{{"scatter of", "tests", "mean", "standard deviation", "relative"}},
                  {false, true, true, true, true}};
  for (const OutputScatter& of : scatter_of(result))
    table.rows.push_back({of.output, std::to_string(of.tests), number(of.mean),
                          fmt::format("{:.3e}", of.deviation),
                          of.mean == 0 ? "" : fmt::format("{:.1e}", of.deviation / std::abs(of.mean))});
  return table;
}

std::string verdict_of(const CalibrationResult& result) {
  if (!result.converged) return "no minimum found:";
  return result.reached ? "targets reached:" : "targets not reached:";
}

std::string singular_text(const CalibrationResult& result) {
  std::string text;
  for (Index i = 0; i < result.singular_values.size(); ++i)
    text += fmt::format("{}{:.4g}", i == 0 ? "" : ", ", result.singular_values[i]);
  return text;
}

std::string solves_text(const CalibrationResult& result) {
  const EvaluationTimes times = times_of(result);
  std::set<std::string> tests;
  for (const AchievedTarget& target : result.targets) tests.insert(target.test);
  std::string text = fmt::format("{}: {} of {}; {} for the first evaluation", counted(result.solves, "solve"),
                                 counted(Index(result.history.size()), "evaluation"),
                                 counted(Index(tests.size()), "test"), seconds_text(times.first));
  if (!std::isnan(times.later))
    text += fmt::format(", {} for a later one, {:.2f} of that", seconds_text(times.later),
                        times.later / times.first);
  return text;
}

void add_row(TextTable& table, const char* name, const std::string& text) {
  constexpr int indent = 19;  // two blanks, the longest name, two blanks
  if (!text.empty()) table.rows.push_back({name, wrapped(text, indent)});
}

}  // namespace

std::vector<OutputScatter> scatter_of(const CalibrationResult& result) {
  std::vector<OutputScatter> all;
  std::map<std::string, std::vector<double>> values;
  for (const AchievedTarget& target : result.targets) {
    if (values[target.output].empty()) all.push_back({target.output});
    values[target.output].push_back(target.achieved);
  }
  std::erase_if(all, [&](const OutputScatter& of) { return values[of.output].size() < 2; });
  for (OutputScatter& of : all) {
    const std::vector<double>& found = values[of.output];
    of.tests = Index(found.size());
    for (const double value : found) of.mean += value / double(of.tests);
    for (const double value : found)
      of.deviation += (value - of.mean) * (value - of.mean) / double(of.tests - 1);
    of.deviation = std::sqrt(of.deviation);
  }
  return all;
}

EvaluationTimes times_of(const CalibrationResult& result) {
  EvaluationTimes times;
  const auto& history = result.history;
  if (history.empty()) return times;
  times.first = history.front().seconds;
  if (history.size() == 1) return times;
  times.later = 0;
  for (std::size_t i = 1; i < history.size(); ++i)
    times.later += history[i].seconds / double(history.size() - 1);
  return times;
}

std::string calibration_report(const CalibrationProblem& problem, const CalibrationResult& result,
                               const std::string& written) {
  std::string text = heading(problem.given, facts_of(problem.tests.front().model));
  text += fmt::format("{} calibrated to {}\n\n", counted(Index(problem.parameters.size()), "parameter"),
                      counted(Index(problem.targets.size()), "target"));
  const std::string verdict = verdict_of(result);
  text += "  " + bold(verdict, stdout) + wrapped(verdict + " " + result.reason, 4).substr(verdict.size()) +
          "\n\n";
  text += to_text(parameter_table(problem, result), 2) + "\n";
  text += to_text(target_table(problem, result), 2) + "\n";
  for (const TextTable& table : {correlation_table(result), scatter_table(result)})
    if (table.rows.size() > 1) text += to_text(table, 2) + "\n";

  TextTable last;
  for (const Unidentified& one : result.unidentified) add_row(last, "not told apart", one.sentence);
  add_row(last, "singular values", singular_text(result));
  add_row(last, "solved", solves_text(result));
  add_row(last, "written", written);
  return text + to_text(last, 2) + warnings_text(problem.warnings) + warnings_text(result.warnings);
}

}  // namespace bondstatic
