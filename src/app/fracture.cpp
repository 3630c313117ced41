#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/checkpoint.hpp"
#include "app/fracture_report.hpp"
#include "app/interrupt.hpp"
#include "app/run_case.hpp"
#include "app/status_line.hpp"
#include "app/terminal.hpp"
#include "io/replace_file.hpp"
#include "results/fracture_checkpoint.hpp"

namespace bondstatic {

namespace {

namespace fs = std::filesystem;

/// What is expected is the static answer, not the last state of a run.
std::vector<OutputValue> outputs_of(const Case& given, const State& state) {
  std::vector<OutputValue> values;
  for (const Output& output : given.outputs)
    values.push_back({output.name, evaluate_output(given.model, state, output), std::nullopt, 0, ""});
  return values;
}

/// A run that goes on from a checkpoint comes again to events that its record knows.
void note_outputs(const Case& given, std::size_t event, const State& state, FractureRecord& record) {
  for (std::size_t i = 0; i < given.outputs.size(); ++i) {
    std::vector<double>& column = record.outputs[i].values;
    column.resize(event);
    column.push_back(evaluate_output(given.model, state, given.outputs[i]));
  }
}

/// Of a run that was to go farther before it was stopped than it now is.
void forget_later(FractureRecord& record, std::size_t events) {
  for (HistoryColumn& column : record.outputs) column.values.resize(std::min(column.values.size(), events));
  std::erase_if(record.states, [&](Index state) { return state > Index(events); });
}

}  // namespace

ExitCode fracture(const LongRunArguments& arguments) {
  const SolveArguments& options = arguments.solve;
  const std::string& folder = options.folder;
  const Case given = read_case(options, options.overrides, Purpose::fracture);
  const fs::path file = fs::path(folder) / fracture_checkpoint_file;
  KeptFracture kept = unpacked(checkpoint_to_resume(arguments, file), file.string(), given.outputs);
  if (!folder.empty()) check_fracture_folder(folder, kept.record);

  StatusLine status;
  Throttle throttle;
  // Once bonds break a signal waits for the next event, so that what was found can be written.
  std::unique_ptr<DeferredInterrupts> guard;
  const auto hold_signals = [&] {
    if (!guard) guard = std::make_unique<DeferredInterrupts>();
  };
  FractureHooks hooks;
  hooks.resume = std::move(kept.run);
  hooks.resume_name = file.string();
  hooks.keep_every = arguments.checkpoint_every;
  hooks.progress = [&](const FractureProgress& progress) {
    hold_signals();
    if (throttle.due()) status.show(progress_text(progress));
    return !DeferredInterrupts::waiting();
  };
  if (!given.outputs.empty())
    hooks.probe = [&](std::size_t event, const State& state) {
      hold_signals();
      note_outputs(given, event, state, kept.record);
    };
  if (!folder.empty()) {
    hooks.show = [&](std::size_t, const State& state, const std::vector<Index>& break_event) {
      hold_signals();
      show_fracture(given.model, state, break_event, kept.record, folder);
    };
    hooks.keep = [&](const std::string& run) {
      hold_signals();
      fs::create_directories(folder);
      replace_file(file, packed({run, kept.record}, given.outputs));
    };
  }
  StaticOptions solve = given.solve;
  solve.progress = [&](const std::string& phase) { status.show(phase); };
  const Fracture found = fracture(given.model, given.fracture, solve, hooks);
  status.clear();
  forget_later(kept.record, found.events.size());

  const std::vector<OutputValue> outputs =
      found.last.displacement.empty() ? std::vector<OutputValue>{} : outputs_of(given, found.last);
  const RunInfo run{given.title, given.file, given.resolved, given.si, given.warnings};
  std::vector<std::string> files;
  if (!folder.empty()) {
    hold_signals();
    write_fracture(given.model, run, given.fracture, found, kept.record, outputs, folder);
    files = fracture_files(kept.record);
  }
  fmt::print("{}", options.json ? fracture_json(given.model, run, given.fracture, found, outputs, files)
                                : fracture_report(given, found, outputs, folder, files));
  std::fflush(stdout);  // a signal that waits ends the program without that
  if (found.end == FractureEnd::interrupted) end_interrupted(arguments, file);
  return ExitCode::done;
}

}  // namespace bondstatic
