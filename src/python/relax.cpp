// The explicit run to rest.
#include <set>

#include "bondstatic/case_file.hpp"
#include "bondstatic/relaxation.hpp"
#include "case/dynamic_options.hpp"
#include "python/background.hpp"
#include "python/node_of.hpp"
#include "python/parts.hpp"
#include "python/solve.hpp"
#include "python/state.hpp"

namespace bondstatic {

namespace {

struct Relaxed {
  std::shared_ptr<const Model> model;
  Relaxation relaxation;
};

/// The options of [dynamics] by keyword; what is not given is as in `base`.
RelaxOptions relax_options(const RelaxOptions& base, const py::dict& given) {
  Reading reading;
  Node table = node_of(given, "relax");
  std::set<std::string> keys;
  for (const Node& item : table.items) keys.insert(item.key);
  const RelaxOptions asked = read_dynamic_options(reading, table);
  if (!reading.faults.empty()) throw InputError(reading.faults);
  RelaxOptions options = base;
  const auto take = [&](const char* key, auto RelaxOptions::*option) {
    if (keys.contains(key)) options.*option = asked.*option;
  };
  take("kinematics", &RelaxOptions::kinematics);
  take("particle_damping", &RelaxOptions::particle_damping);
  take("bond_damping", &RelaxOptions::bond_damping);
  take("safety", &RelaxOptions::time_step);  // none: safety counts
  take("safety", &RelaxOptions::safety);
  take("time_step", &RelaxOptions::time_step);
  take("ramp", &RelaxOptions::ramp);
  take("ramp_time", &RelaxOptions::ramp_time);
  take("velocity_limit", &RelaxOptions::velocity_limit);
  take("force_limit", &RelaxOptions::force_limit);
  take("hold_time", &RelaxOptions::hold_time);
  take("max_steps", &RelaxOptions::max_steps);
  take("record_interval", &RelaxOptions::record_interval);
  take("save_interval", &RelaxOptions::save_interval);
  return options;
}

/// A state on the way, while Python looks at it.
struct OnTheWay {
  std::shared_ptr<const Relaxed> of;
  State state;
  std::vector<Vector6> velocity;
};

void show(const Callback& on_state, double time, const std::shared_ptr<const OnTheWay>& shown) {
  const double* const first = shown->velocity.empty() ? nullptr : shown->velocity.front().data();
  on_state(time, PythonState{shown, &shown->state, nullptr},
           view_of_items<double>(shown, shown->velocity, first, 3));
}

std::shared_ptr<Relaxed> run(const PythonModel& given, const RelaxOptions& options,
                             const StaticOptions& solve, double load_factor, const py::object& progress,
                             const py::object& on_state) {
  const auto relaxed = std::make_shared<Relaxed>();
  relaxed->model = given.edited.kept();
  run_watched([relaxed, options, solve, load_factor, callback = Callback(progress),
               shows = Callback(on_state)](Watch& watch) {
    RelaxOptions asked = options;
    asked.load_factor = load_factor;
    RelaxHooks hooks;
    hooks.progress = [&](const RelaxProgress& now) {
      watch.tell(
          [callback, now] { callback(now.load_case, now.step, now.unrest.unbalanced, now.unrest.fastest); });
      return true;
    };
    if (shows)
      hooks.show = [&](const State& state, const std::vector<Vector6>& velocity,
                       const std::vector<SavedState>& saved) {
        const auto shown = std::make_shared<const OnTheWay>(OnTheWay{relaxed, state, velocity});
        watch.ask([shows, shown, time = saved.back().time] { show(shows, time, shown); });
      };
    relaxed->relaxation = relax(*relaxed->model, asked, solve, hooks);
  });
  return relaxed;
}

const RelaxedCase& case_of(const Relaxed& relaxed, std::size_t load_case) {
  return relaxed.relaxation.cases.at(load_case);
}

py::dict history_of(const std::shared_ptr<Relaxed>& relaxed, std::size_t load_case) {
  py::dict history;
  for (const HistoryColumn& column : case_of(*relaxed, load_case).history)
    history[py::str(column.name)] = view_of_items<double>(relaxed, column.values, column.values.data());
  return history;
}

py::dict report_of(const Relaxed& relaxed, std::size_t load_case) {
  const RelaxedCase& run = case_of(relaxed, load_case);
  py::dict facts;
  facts["at_rest"] = run.end == RunEnd::at_rest;
  facts["steps"] = run.steps;
  facts["time"] = run.time;
  facts["time_step"] = run.plan.time_step;
  facts["critical_time_step"] = run.plan.critical_time_step;
  facts["highest_frequency"] = run.plan.highest;
  facts["lowest_frequencies"] = run.plan.lowest;
  facts["predicted_steps"] = run.plan.predicted_steps;
  facts["best_particle_damping"] = run.plan.best_particle_damping;
  facts["unbalanced"] = run.unrest.unbalanced;
  facts["fastest"] = run.unrest.fastest;
  facts["seconds"] = run.seconds;
  return facts;
}

}  // namespace

void add_relax(py::module_& module) {
  py::class_<RelaxOptions>(module, "RelaxOptions")
      .def(py::init<>())
      .def("with_", &relax_options, py::arg("given"), "These options with some of them replaced.");
  py::class_<Relaxed, std::shared_ptr<Relaxed>>(module, "Relaxed")
      .def_property_readonly("load_cases", [](const Relaxed& r) { return r.model->load_cases; })
      .def_property_readonly("at_rest", [](const Relaxed& r) { return r.relaxation.at_rest(); })
      .def_property_readonly("warnings", [](const Relaxed& r) { return r.relaxation.warnings; })
      .def(
          "state",
          [](const std::shared_ptr<Relaxed>& r, std::size_t c) {
            return PythonState{r, &case_of(*r, c).state, nullptr};
          },
          py::arg("load_case"))
      .def("history", &history_of, py::arg("load_case"))
      .def("report", &report_of, py::arg("load_case"));
  module.def("relax", &run, py::arg("model"), py::arg("options"), py::arg("solve"), py::arg("load_factor"),
             py::arg("progress"), py::arg("on_state"));
}

}  // namespace bondstatic
