#include "bondstatic/compare.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/commands.hpp"
#include "app/compare_report.hpp"
#include "app/interrupt.hpp"
#include "app/run_case.hpp"
#include "app/status_line.hpp"
#include "app/terminal.hpp"
#include "compare/read_run.hpp"
#include "formats/readers.hpp"
#include "io/nearest_name.hpp"
#include "results/comparison.hpp"

namespace bondstatic {

namespace {

[[noreturn]] void misused(const std::string& message, const std::string& cure) {
  throw Error(ExitCode::invalid_input, message + "\n    cure: " + cure);
}

Index chosen_load_case(const Model& model, const CompareArguments& arguments) {
  const auto& names = model.load_cases;
  if (!arguments.load_case) {
    if (names.size() == 1) return 0;
    misused(fmt::format("the case has {} load cases: {}", names.size(), name_list(names)),
            "say which one the run has: --load-case NAME");
  }
  const auto found = std::find(names.begin(), names.end(), *arguments.load_case);
  if (found != names.end()) return Index(found - names.begin());
  const std::string nearest = nearest_name(*arguments.load_case, names);
  misused(fmt::format("the case has no load case \"{}\"", *arguments.load_case),
          nearest.empty() ? "give one of " + name_list(names) : "did you mean \"" + nearest + "\"?");
}

/// The case with this load case alone: the others need not be solved.
Model only(const Model& model, Index load_case) {
  if (model.load_cases.size() == 1) return model;
  Model out = model;
  const auto others = [load_case](const auto& one) {
    return one.load_case != every_case && one.load_case != load_case;
  };
  std::erase_if(out.supports, others);
  std::erase_if(out.loads, others);
  std::erase_if(out.strains, others);
  for (Support& one : out.supports) one.load_case = every_case;
  for (Load& one : out.loads) one.load_case = every_case;
  for (Strain& one : out.strains) one.load_case = every_case;
  out.load_cases = {model.load_cases[std::size_t(load_case)]};
  return out;
}

void check_choices(const CompareArguments& arguments) {
  if (arguments.every_step && arguments.step)
    misused("--step and --every-step exclude each other", "give one");
  if (arguments.bonds.empty() && (!arguments.bond_columns.empty() || !arguments.bond_force.empty()))
    misused("--bond-columns and --bond-force say what the columns of --bonds are", "give --bonds FILE, too");
  if (!(arguments.tolerance > 0)) misused("--tolerance must be positive", "give 1e-3, for one");
}

std::vector<std::optional<Index>> steps_of(const CompareArguments& arguments) {
  if (!arguments.every_step) return {arguments.step};
  std::vector<Fault> faults;
  const auto steps = dump_steps(arguments.run, {}, faults);
  if (!faults.empty() || !steps) throw InputError(std::move(faults));
  return {steps->begin(), steps->end()};
}

}  // namespace

ExitCode compare(const CompareArguments& arguments) {
  check_choices(arguments);
  const BondForceFile bonds{arguments.bonds, arguments.bond_columns,
                            bond_force_columns(arguments.bond_force)};
  const SolveArguments& asked = arguments.solve;
  StatusLine status;
  status.show("read");
  Case given = read_case(asked, asked.overrides);
  given.model = only(given.model, chosen_load_case(given.model, arguments));
  const auto wanted = steps_of(arguments);
  if (!asked.folder.empty())
    check_comparison_folder(asked.folder, !arguments.bonds.empty(), wanted.size() > 1);

  given.solve.progress = [&](const std::string& phase) { status.show(phase); };
  const StaticSolution solution = solve_statics(given.model, given.solve);
  const State& statics = solution.cases.front();

  std::vector<Comparison> steps;
  RunState run;
  for (const auto& step : wanted) {
    const bool last = steps.size() + 1 == wanted.size();
    status.show(fmt::format("compare {} of {}", steps.size() + 1, wanted.size()));
    run = read_run(given.model, statics, arguments.run, step);
    if (last && !bonds.file.empty()) read_bond_forces(given.model, statics, bonds, arguments.step, run);
    steps.push_back(compare(given.model, statics, 0, run, given.solve, {arguments.tolerance, last}));
  }

  const RunInfo info{given.title, given.file, given.resolved, given.si, given.warnings};
  const ComparisonResults results{given.model, statics, run, solution.report, steps};
  std::string written;
  std::vector<std::string> files;
  if (!asked.folder.empty()) {
    status.show("write");
    const DeferredInterrupts guard;
    write_comparison(results, info, asked.folder, DeferredInterrupts::check);
    files = comparison_files(results);
    written = asked.folder + ": " + name_list(files);
  }
  status.clear();
  fmt::print("{}", asked.json ? comparison_json(results, info, files)
                              : comparison_report(given, solution.report, steps, written));
  return steps.back().verdict == CompareVerdict::same_state ? ExitCode::done : ExitCode::not_accurate;
}

}  // namespace bondstatic
