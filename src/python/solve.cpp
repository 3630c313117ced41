#include "python/solve.hpp"

#include "bondstatic/output.hpp"
#include "case/solve_options.hpp"
#include "python/model_steps.hpp"
#include "python/node_of.hpp"
#include "python/parts.hpp"
#include "python/state.hpp"

namespace bondstatic {

namespace {

std::shared_ptr<Solved> solve(const PythonModel& model, const StaticOptions& options,
                              const py::object& progress) {
  const auto solved = std::make_shared<Solved>();
  solved->model = model.edited.kept();
  solved->options = options;
  run_watched([solved, callback = Callback(progress)](Watch& watch) {
    StaticOptions watched = solved->options;
    watched.progress = phases_to(watch, callback);
    solved->solution = solve_statics(*solved->model, watched);
  });
  return solved;
}

py::dict report_of(const Solved& solved) {
  const StaticReport& report = solved.solution.report;
  py::dict facts, phases;
  for (const Phase& phase : report.phases) {
    const py::str name(phase.name);
    phases[name] = phase.seconds + (phases.contains(name) ? phases[name].cast<double>() : 0.0);
  }
  facts["solver"] = report.solver;
  facts["solver_reason"] = report.solver_reason;
  facts["threads"] = report.threads;
  facts["unknowns"] = report.analysis.unknowns;
  facts["matrix_entries"] = report.analysis.matrix_entries;
  facts["factor_entries"] = report.analysis.factor_entries;
  facts["factorisations"] = report.factorisations;
  facts["iterations"] = report.iterations;
  facts["predicted_bytes"] = report.analysis.predicted_bytes;
  facts["peak_bytes"] = report.peak_bytes;
  facts["seconds"] = phases;
  facts["dropped"] = report.dropped;
  facts["warnings"] = report.warnings;
  return facts;
}

py::object effective_of(const Solved& solved) {
  if (!solved.solution.effective) return py::none();
  const EffectiveStiffness& effective = *solved.solution.effective;
  py::dict facts;
  facts["stiffness"] = matrix(effective.stiffness);
  facts["voigt"] = matrix(effective.voigt);
  facts["volume"] = effective.volume;
  facts["asymmetry"] = effective.asymmetry;
  facts["young"] = effective.isotropic.young;
  facts["poisson"] = effective.isotropic.poisson;
  facts["misfit"] = effective.isotropic.misfit;
  return facts;
}

std::vector<double> evaluate(const Solved& solved, const std::vector<Output>& outputs) {
  expect_outputs_of(*solved.model, outputs);
  std::vector<double> values;
  for (const OutputValue& value : evaluate_outputs(*solved.model, solved.solution, outputs))
    values.push_back(value.value);
  return values;
}

}  // namespace

StaticOptions solve_options(const py::dict& given, StaticOptions base) {
  Reading reading;
  Node table = node_of(given, "solve");
  std::vector<std::string> backend_options;
  if (table.find("backend_options")) {
    if (const auto texts = read_texts(reading, *table.find("backend_options"), "backend_options"))
      base.backend_options = *texts;
    table.items.remove_if([](const Node& item) { return item.key == "backend_options"; });
  }
  const auto has = [&](const char* key) { return table.find(key) != nullptr; };
  const bool solver = has("solver"), tolerance = has("tolerance"), unsupported = has("unsupported"),
             memory = has("memory_limit"), threads = has("threads");
  const StaticOptions asked = read_solve_options(reading, table);
  if (!reading.faults.empty()) throw InputError(reading.faults);
  if (solver) base.solver = asked.solver;
  if (tolerance) base.tolerance = asked.tolerance;
  if (unsupported) base.unsupported = asked.unsupported;
  if (memory) base.memory_limit = asked.memory_limit;
  if (threads) base.threads = asked.threads;
  return base;
}

std::function<void(const std::string&)> phases_to(Watch& watch, Callback callback) {
  return [&watch, callback](const std::string& phase) { watch.tell([callback, phase] { callback(phase); }); };
}

void add_solve(py::module_& module) {
  py::class_<StaticOptions>(module, "SolveOptions")
      .def(py::init<>())
      .def(
          "with_",
          [](const StaticOptions& base, const py::dict& given) { return solve_options(given, base); },
          py::arg("given"), "These options with some of them replaced.")
      .def_readonly("solver", &StaticOptions::solver)
      .def_readonly("threads", &StaticOptions::threads)
      .def_readonly("tolerance", &StaticOptions::tolerance)
      .def_property_readonly("drops",
                             [](const StaticOptions& o) { return o.unsupported == Unsupported::drop; });

  py::class_<Solved, std::shared_ptr<Solved>>(module, "Solved")
      .def_property_readonly("load_cases", [](const Solved& s) { return s.model->load_cases; })
      .def(
          "state",
          [](const std::shared_ptr<Solved>& s, std::size_t load_case) {
            const LoadCaseResult& result = s->solution.cases.at(load_case);
            return PythonState{s, &result, &result.accuracy, s->model.get()};
          },
          py::arg("load_case"))
      .def_readonly("options", &Solved::options)
      .def_property_readonly("report", &report_of)
      .def_property_readonly("effective", &effective_of)
      .def("evaluate", &evaluate, py::arg("outputs"));
  module.def("solve", &solve, py::arg("model"), py::arg("options"), py::arg("progress"));
}

}  // namespace bondstatic
