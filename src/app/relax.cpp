#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/checkpoint.hpp"
#include "app/commands.hpp"
#include "app/interrupt.hpp"
#include "app/relax_report.hpp"
#include "app/report.hpp"
#include "app/run_case.hpp"
#include "app/status_line.hpp"
#include "app/terminal.hpp"
#include "io/replace_file.hpp"
#include "results/output_fingerprint.hpp"
#include "results/relaxation_series.hpp"

namespace bondstatic {

namespace {

namespace fs = std::filesystem;

Probes outputs_as_probes(const Case& given, const State& state) {
  Probes probes;
  for (const Output& output : given.outputs)
    if (output.load_case == state.name)
      probes.emplace_back(output.name, evaluate_output(given.model, state, output));
  return probes;
}

std::size_t load_case_of(const Model& model, const State& state) {
  const auto& names = model.load_cases;
  return std::size_t(std::find(names.begin(), names.end(), state.name) - names.begin());
}

}  // namespace

ExitCode relax(const LongRunArguments& arguments) {
  const SolveArguments& options = arguments.solve;
  const Case given = read_case(options, options.overrides, Purpose::dynamics);
  const fs::path file = fs::path(options.folder) / checkpoint_file;
  if (!options.folder.empty()) check_relaxation_folder(given.model, given.relax, options.folder);

  StatusLine status;
  Throttle throttle;
  RelaxHooks hooks;
  hooks.resume = checkpoint_to_resume(arguments, file);
  hooks.resume_name = file.string();
  hooks.keep_every = arguments.checkpoint_every;
  hooks.probe_fingerprint = fingerprint_of(given.outputs);
  if (!given.outputs.empty())
    hooks.probe = [&](const State& state) { return outputs_as_probes(given, state); };
  std::vector<std::vector<SavedState>> shown;
  if (!options.folder.empty()) {
    if (hooks.resume.empty()) keep_shown_relaxation(given.model, shown, options.folder);
    hooks.resumed = [&](const std::vector<std::vector<SavedState>>& saved) {
      check_shown_relaxation(given.model, saved, options.folder);
      shown = saved;
    };
    hooks.show = [&](const State& state, const std::vector<Vector6>& velocity,
                     const std::vector<SavedState>& saved) {
      show_relaxation(given.model, state, velocity, saved, options.folder);
      shown.resize(given.model.load_cases.size());
      shown[load_case_of(given.model, state)] = saved;
    };
    hooks.keep = [&](const std::string& content) {
      fs::create_directories(options.folder);
      replace_file(file, content);
      keep_shown_relaxation(given.model, shown, options.folder);
    };
  }
  // While bodies move a signal waits for the next look, so that the run can be kept; a plan is soon made
  // again.
  std::unique_ptr<DeferredInterrupts> guard;
  hooks.phase = [&](bool planning) {
    if (planning) status.show("plan");
    guard = planning ? nullptr : std::make_unique<DeferredInterrupts>();
  };
  hooks.progress = [&](const RelaxProgress& progress) {
    if (throttle.due()) status.show(progress_text(progress));
    return !DeferredInterrupts::waiting();
  };
  const Relaxation relaxation = relax(given.model, given.relax, given.solve, hooks);
  status.clear();
  if (DeferredInterrupts::waiting()) end_interrupted(arguments, file);

  std::vector<const State*> states;
  for (const RelaxedCase& relaxed : relaxation.cases) states.push_back(&relaxed.state);
  const auto outputs = evaluate_outputs(given.model, states, given.outputs);
  const RunInfo run{given.title, given.file, given.resolved, given.si, given.warnings};
  std::vector<std::string> files;
  std::string written;
  if (!options.folder.empty()) {
    // A signal now waits until all is written: what took hours to run takes seconds to keep.
    write_relaxation(given.model, run, relaxation, outputs, options.folder);
    files = relaxation_files(given.model, relaxation);
    written = wrapped(written_text(options.folder, files, relaxation_kind), 12);
  }
  guard.reset();
  fmt::print("{}", options.json ? relaxation_json(given.model, run, relaxation, outputs, files)
                                : relaxation_report(given, relaxation, outputs, written));
  if (relaxation.at_rest()) return ExitCode::done;
  std::string reasons;
  for (const RelaxedCase& relaxed : relaxation.cases)
    if (relaxed.end != RunEnd::at_rest)
      reasons += (reasons.empty() ? "" : "\n") + unrest_text(given, relaxed);
  throw AccuracyError(reasons + (options.folder.empty() ? "" : ", and go on with --resume"));
}

}  // namespace bondstatic
