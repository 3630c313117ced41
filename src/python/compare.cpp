// A DEM run's end state beside the static answer.
#include "bondstatic/compare.hpp"

#include <fmt/format.h>
#include <pybind11/eigen.h>

#include "compare/read_run.hpp"
#include "python/parts.hpp"
#include "python/solve.hpp"
#include "results/comparison.hpp"

namespace bondstatic {

namespace {

using Solution = std::shared_ptr<const Solved>;

const State& state_of(const Solved& solved, std::size_t load_case) {
  return solved.solution.cases.at(load_case);
}

Comparison compared(const Solution& solved, std::size_t load_case, std::function<RunState()> run,
                    double tolerance, const py::object& progress) {
  const auto result = std::make_shared<Comparison>();
  run_watched([result, solved, load_case, run = std::move(run), tolerance,
               callback = Callback(progress)](Watch& watch) {
    StaticOptions options = solved->options;
    options.progress = phases_to(watch, callback);
    *result = compare(*solved->model, state_of(*solved, load_case), Index(load_case), run(), options,
                      {.tolerance = tolerance});
  });
  return std::move(*result);
}

Comparison compare_files(const Solution& solved, std::size_t load_case, const std::string& file,
                         std::optional<Index> step, const std::string& bonds,
                         const std::vector<std::string>& bond_columns,
                         const std::vector<std::string>& bond_force, double tolerance,
                         const py::object& progress) {
  const BondForceFile of_bonds{bonds, bond_columns, bond_force_columns(bond_force)};
  const auto run = [=] {
    const State& statics = state_of(*solved, load_case);
    RunState read = read_run(*solved->model, statics, file, step);
    if (!of_bonds.file.empty()) read_bond_forces(*solved->model, statics, of_bonds, step, read);
    return read;
  };
  return compared(solved, load_case, run, tolerance, progress);
}

/// (n, 6), or (n, 3) without rotations.
Comparison compare_motion(const Solution& solved, std::size_t load_case, const ArrayOf<double>& motion,
                          double tolerance, const py::object& progress) {
  const State& statics = state_of(*solved, load_case);
  RunState run;
  run.name = "motion";
  run.has_rotations = motion.shape(1) == 6;
  run.displacement.assign(statics.displacement.size(), Vector6::Constant(not_given));
  for (std::size_t p = 0; p < run.displacement.size(); ++p) {
    auto known = run.displacement[p].head(motion.shape(1));
    for (py::ssize_t i = 0; i < motion.shape(1); ++i) known[i] = motion.at(py::ssize_t(p), i);
    if (!known.allFinite() && statics.displacement[p].allFinite())
      throw InputError({{{"compare", 0, 0},
                         fmt::format("motion[{}] is not finite", p),
                         "give the motion of every particle that is not left out"}});
  }
  return compared(
      solved, load_case, [run] { return run; }, tolerance, progress);
}

py::dict unbalance_of(const Comparison& comparison) {
  py::dict facts;
  for (const auto& [name, number] : numbers_of(comparison.unbalance)) facts[name] = number;
  return facts;
}

py::dict fields_of(const Comparison& comparison) {
  py::dict fields;
  for (const FieldComparison& field : comparison.fields) fields[py::str(field.field)] = py::cast(field);
  return fields;
}

}  // namespace

void add_compare(py::module_& module) {
  py::class_<FieldComparison>(module, "ComparedField", "One field of a run beside the static one.")
      .def_readonly("field", &FieldComparison::field)
      .def_readonly("static_norm", &FieldComparison::static_norm)
      .def_readonly("run_norm", &FieldComparison::run_norm)
      .def_readonly("difference", &FieldComparison::difference, "Norm of the difference, relative.")
      .def_readonly("largest", &FieldComparison::largest, "Largest difference over the largest magnitude.")
      .def_readonly("at", &FieldComparison::at,
                    "Where that is: row of Model.x, or of Model.bonds; -1 of the energy.")
      .def_readonly("of_bond", &FieldComparison::of_bond)
      .def_readonly("scale", &FieldComparison::scale, "Brings the static field nearest to the run's.")
      .def_readonly("misfit", &FieldComparison::misfit, "What is left then, relative.")
      .def("__repr__", [](const FieldComparison& f) {
        return fmt::format("<{}: relative difference {:.3g}>", f.field, f.difference);
      });
  py::class_<Suspect>(module, "Suspect", "A thing that could be different from what the model says.")
      .def_readonly("what", &Suspect::what)
      .def_readonly("text", &Suspect::text)
      .def_readonly("factors", &Suspect::factors,
                    "Times the model's; of a contact point, where it is in parts of the length.")
      .def_readonly("left", &Suspect::left, "Of the difference with it, over the static displacement.")
      .def("__repr__",
           [](const Suspect& s) { return fmt::format("<Suspect: {}, leaves {:.3g}>", s.text, s.left); });
  py::class_<Comparison>(module, "Comparison", "A run's end state beside the static answer.")
      .def_property_readonly(
          "verdict", [](const Comparison& c) { return name_of(c.verdict); },
          "\"same state\", \"still moving\", \"different model\" or \"still moving, or a different model\".")
      .def_property_readonly(
          "same", [](const Comparison& c) { return c.verdict == CompareVerdict::same_state; },
          "It is the same state.")
      .def_readonly("reason", &Comparison::reason, "One sentence.")
      .def_readonly("step", &Comparison::step, "Of the run.")
      .def_property_readonly("fields", &fields_of, "ComparedField by name: displacement, rotation, ...")
      .def_readonly("suspects", &Comparison::suspects, "Best first; empty where nothing had to be explained.")
      .def_property_readonly("unbalance", &unbalance_of,
                             "What the run's state carries that rest does not, relative; NaN where the run "
                             "does not tell.")
      .def_readonly("missing", &Comparison::missing, "Ids of the model that the run lacks.")
      .def_readonly("unknown", &Comparison::unknown, "Ids of the run that the model lacks.")
      .def_readonly("notes", &Comparison::notes, "What was assumed of the run's files.")
      .def("__repr__", [](const Comparison& c) {
        return fmt::format("<bondstatic.Comparison: {}: {}>", name_of(c.verdict), c.reason);
      });
  module.def("compare_files", &compare_files, py::arg("solved"), py::arg("load_case"), py::arg("file"),
             py::arg("step"), py::arg("bonds"), py::arg("bond_columns"), py::arg("bond_force"),
             py::arg("tolerance"), py::arg("progress"));
  module.def("compare_motion", &compare_motion, py::arg("solved"), py::arg("load_case"), py::arg("motion"),
             py::arg("tolerance"), py::arg("progress"));
}

}  // namespace bondstatic
