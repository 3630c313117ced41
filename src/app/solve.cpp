#include <fmt/format.h>

#include <chrono>

#include "app/commands.hpp"
#include "app/interrupt.hpp"
#include "app/report.hpp"
#include "app/run_case.hpp"
#include "app/solve_on_ranks.hpp"
#include "app/status_line.hpp"

namespace bondstatic {

ExitCode solve(const SolveArguments& arguments, Sensitivities sensitivities, Ranks* ranks) {
  if (ranks && sensitivities != Sensitivities::none)
    throw Error(ExitCode::invalid_input,
                "--sensitivities: one process finds them\n    cure: run it without mpirun");
  if (ranks) return solve_on_ranks(arguments, *ranks);
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  StatusLine status;
  status.show("read");
  const Case given = read_case(arguments, arguments.overrides);
  const double reading = std::chrono::duration<double>(Clock::now() - begin).count();
  if (!arguments.folder.empty()) check_result_folder(facts_of(given.model), arguments.folder);

  Answer result = answer(
      given, [&](const std::string& phase) { status.show(phase); }, sensitivities);
  result.resolution = resolution_of(given.model, result.solution.report.threads);
  auto& phases = result.solution.report.phases;
  phases.insert(phases.begin(), {"read", reading});

  const RunInfo run{given.title, given.file, given.resolved, given.si, given.warnings, result.resolution};
  if (!arguments.folder.empty()) {
    status.show("write");
    const DeferredInterrupts guard;
    write_results(given.model, run, result.solution, result.outputs, arguments.folder,
                  DeferredInterrupts::check, [&](double part) { status.show("write", part); });
  }
  status.clear();

  const std::vector<std::string> files =
      arguments.folder.empty() ? std::vector<std::string>{} : result_files(given.model, result.outputs);
  fmt::print("{}", arguments.json ? summary_json(given.model, run, result.solution, result.outputs, files)
                                  : report(given, result, arguments.folder));
  return ExitCode::done;
}

}  // namespace bondstatic
