// Which bond breaks first, and what follows.
#include "bondstatic/output.hpp"
#include "python/background.hpp"
#include "python/fracture_checkpoint.hpp"
#include "python/fracture_options.hpp"
#include "python/fractured.hpp"
#include "python/model_steps.hpp"
#include "python/parts.hpp"
#include "python/solve.hpp"

namespace bondstatic {

namespace {

/// What the work needs, which belongs to it.
struct Job {
  std::shared_ptr<Fractured> result;
  FractureOptions options;
  StaticOptions solve;
  std::vector<Output> outputs;
  Callback progress, on_state;
  std::filesystem::path checkpoint;
  double checkpoint_every = 0;
  KeptFracture kept;
  bool stopped = false;
};

/// A state that is shown, on its own.
struct Shown {
  std::shared_ptr<const Model> model;
  State state;
  std::vector<Index> break_event;
};

bool goes_on(const std::shared_ptr<Job>& job, const FractureProgress& now, Watch& watch) {
  watch.stop_on_interrupt();
  if (job->progress)
    watch.ask([job, now] {
      const py::object said = job->progress(now.events, now.breaks, now.factor, now.load, now.displacement);
      job->stopped = said.is(py::bool_(false));
    });
  else
    watch.tell([] {});  // learns whether anybody waits
  return !job->stopped && !watch.interrupted();
}

void show(const std::shared_ptr<Job>& job, std::size_t events, const State& state,
          const std::vector<Index>& break_event, Watch& watch) {
  const auto shown = std::make_shared<const Shown>(Shown{job->result->model, state, break_event});
  watch.ask([job, events, shown] {
    const std::vector<Index>& broken = shown->break_event;
    job->on_state(Index(events), PythonState{shown, &shown->state, nullptr, shown->model.get(), &broken},
                  view_of_items<Index>(shown, broken, broken.data()));
  });
}

/// A run that goes on from a checkpoint comes again to events that its outputs know.
void note_outputs(Job& job, std::size_t event, const State& state) {
  for (std::size_t i = 0; i < job.outputs.size(); ++i) {
    std::vector<double>& column = job.kept.record.outputs[i].values;
    column.resize(event);
    column.push_back(evaluate_output(*job.result->model, state, job.outputs[i]));
  }
}

void work(const std::shared_ptr<Job>& job, Watch& watch) {
  Fractured& result = *job->result;
  FractureHooks hooks;
  hooks.resume = std::move(job->kept.run);
  hooks.resume_name = job->checkpoint.string();
  hooks.keep_every = job->checkpoint_every;
  hooks.progress = [&](const FractureProgress& now) { return goes_on(job, now, watch); };
  if (!job->outputs.empty())
    hooks.probe = [&](std::size_t event, const State& state) { note_outputs(*job, event, state); };
  if (job->on_state)
    hooks.show = [&](std::size_t events, const State& state, const std::vector<Index>& break_event) {
      show(job, events, state, break_event, watch);
    };
  if (!job->checkpoint.empty())
    hooks.keep = [&](const std::string& run) {
      keep_run(job->checkpoint, {run, job->kept.record}, job->outputs);
    };
  result.fracture = fracture(*result.model, job->options, job->solve, hooks);
  result.interrupted = watch.interrupted() && result.fracture.end == FractureEnd::interrupted;
  const auto& events = result.fracture.events;
  result.outputs = std::move(job->kept.record.outputs);
  for (HistoryColumn& column : result.outputs) column.values.resize(events.size(), not_given);
  for (std::size_t e = 0; e < events.size(); ++e)
    for (const BrokenBond& broken : events[e].bonds)
      result.broken.push_back(
          {Index(e), broken.bond, result.model->bonds[std::size_t(broken.bond)].id, broken.utilisation});
  if (!job->checkpoint.empty() && result.fracture.end != FractureEnd::interrupted)
    remove_kept(job->checkpoint);
}

std::shared_ptr<Fractured> run(PythonModel& model, const PythonFractureOptions& options,
                               const StaticOptions& solve, const std::vector<Output>& outputs,
                               const py::object& progress, const py::object& on_state,
                               const std::string& checkpoint, double checkpoint_every, bool resume) {
  const auto job = std::make_shared<Job>();
  job->options = read_for(model, options);
  job->result = std::make_shared<Fractured>();
  job->result->model = model.edited.kept();
  job->solve = solve;
  expect_outputs_of(*job->result->model, outputs);
  job->outputs = outputs;
  job->progress = Callback(progress);
  job->on_state = Callback(on_state);
  job->checkpoint = checkpoint;
  job->checkpoint_every = checkpoint_every;
  job->kept = kept_run(checkpoint, resume, outputs);
  run_watched([job](Watch& watch) { work(job, watch); });
  return job->result;
}

}  // namespace

void add_fracture(py::module_& module) {
  py::class_<PythonFractureOptions>(module, "FractureOptions")
      .def(py::init<>())
      .def("with_", &PythonFractureOptions::with, py::arg("given"),
           "These options with some of them replaced; infinity takes a limit away.");
  module.def("fracture", &run, py::arg("model"), py::arg("options"), py::arg("solve"), py::arg("outputs"),
             py::arg("progress"), py::arg("on_state"), py::arg("checkpoint"), py::arg("checkpoint_every"),
             py::arg("resume"));
}

}  // namespace bondstatic
