// Calibration of a case file, or of models that Python made.
#include <fmt/format.h>
#include <pybind11/eigen.h>

#include "bondstatic/calibration.hpp"
#include "bondstatic/case_file.hpp"
#include "calibration/ceres_module.hpp"
#include "case/named_parameter.hpp"
#include "python/background.hpp"
#include "python/model_steps.hpp"
#include "python/parts.hpp"
#include "python/python_model.hpp"
#include "solver/machine.hpp"

namespace bondstatic {

namespace {

/// All that calibrate() takes.
struct Problem {
  std::vector<CalibrationTest> tests;
  std::vector<CalibrationParameter> parameters;
  std::vector<CalibrationTarget> targets;
  CalibrationOptions options;
  std::vector<std::string> warnings;
};

CalibrationResult calibrated(std::function<Problem()> make, const py::object& progress) {
  const auto result = std::make_shared<CalibrationResult>();
  run_watched([result, make = std::move(make), callback = Callback(progress)](Watch& watch) {
    ceres_module();  // where it is not there, nothing is read in vain
    Problem problem = make();
    problem.options.progress = [&](int evaluation, double cost) {
      watch.tell([callback, evaluation, cost] { callback(evaluation, cost); });
    };
    for (CalibrationTest& test : problem.tests)
      test.solve.progress = [&](const std::string&) { watch.tell([] {}); };
    *result = calibrate(problem.tests, problem.parameters, problem.targets, problem.options);
    result->warnings.insert(result->warnings.begin(), problem.warnings.begin(), problem.warnings.end());
  });
  return std::move(*result);
}

CalibrationResult calibrate_case(const std::string& file, const std::vector<std::string>& overrides,
                                 const py::object& progress) {
  return calibrated(
      [file, overrides] {
        CalibrationProblem read = read_calibration(file, overrides, cores_at_hand());
        return Problem{std::move(read.tests), std::move(read.parameters), std::move(read.targets),
                       std::move(read.options), std::move(read.warnings)};
      },
      progress);
}

struct GivenTest {
  std::string name;
  std::shared_ptr<const Model> model;
  StaticOptions solve;
  std::vector<Output> outputs;
};

CalibrationResult calibrate_models(
    const std::vector<std::tuple<std::string, PythonModel*, StaticOptions, std::vector<Output>>>& given,
    const std::vector<CalibrationParameter>& parameters, const std::vector<CalibrationTarget>& targets,
    const CalibrationOptions& options, const py::object& progress) {
  std::vector<GivenTest> tests;
  for (const auto& [name, model, solve, outputs] : given) {
    expect_outputs_of(model->edited.model(), outputs);
    tests.push_back({name, model->edited.kept(), solve, outputs});
  }
  return calibrated(
      [tests, parameters, targets, options] {
        Problem problem{{}, parameters, targets, options, {}};
        for (const GivenTest& test : tests) {
          CalibrationTest made{test.name, *test.model, test.solve, test.outputs, {}};
          for (const CalibrationParameter& parameter : parameters)
            made.parameters.push_back(find_parameter(made.model, parameter.name).places);
          problem.tests.push_back(std::move(made));
        }
        return problem;
      },
      progress);
}

}  // namespace

void add_calibrate(py::module_& module) {
  py::class_<CalibrationParameter>(module, "CalibrationParameter")
      .def(py::init([](std::string name, double lower, double upper, double start, bool logarithmic) {
             return CalibrationParameter{std::move(name), start, lower, upper, logarithmic};
           }),
           py::arg("name"), py::arg("lower"), py::arg("upper"), py::arg("start"), py::arg("logarithmic"));
  py::class_<CalibrationTarget>(module, "CalibrationTarget")
      .def(py::init([](std::string output, std::string test, double wanted, double tolerance, double weight) {
             return CalibrationTarget{std::move(output), std::move(test), wanted, tolerance, weight};
           }),
           py::arg("output"), py::arg("test"), py::arg("wanted"), py::arg("tolerance"), py::arg("weight"));
  py::class_<CalibrationOptions>(module, "CalibrationOptions")
      .def(py::init([](const std::string& loss, int most_evaluations) {
             CalibrationOptions options;
             options.loss = loss == "huber" ? Loss::huber : loss == "cauchy" ? Loss::cauchy : Loss::squares;
             options.most_evaluations = most_evaluations;
             return options;
           }),
           py::arg("loss"), py::arg("most_evaluations"));

  py::class_<CalibratedParameter>(module, "CalibratedParameter", "A parameter as it was found.")
      .def_readonly("name", &CalibratedParameter::name)
      .def_readonly("value", &CalibratedParameter::value)
      .def_readonly("lower_95", &CalibratedParameter::lower_95,
                    "95 % interval; NaN where the tests cannot tell.")
      .def_readonly("upper_95", &CalibratedParameter::upper_95,
                    "95 % interval; NaN where the tests cannot tell.")
      .def_readonly("at_bound", &CalibratedParameter::at_bound, "The bound holds it, the targets pull on.")
      .def("__repr__", [](const CalibratedParameter& p) {
        return fmt::format("<{} = {:.10g}, 95 % from {:.6g} to {:.6g}>", p.name, p.value, p.lower_95,
                           p.upper_95);
      });
  py::class_<AchievedTarget>(module, "AchievedTarget", "A target, and what came of it.")
      .def_readonly("output", &AchievedTarget::output)
      .def_readonly("test", &AchievedTarget::test)
      .def_readonly("wanted", &AchievedTarget::wanted)
      .def_readonly("achieved", &AchievedTarget::achieved)
      .def_readonly("residual", &AchievedTarget::residual, "Over the tolerance.")
      .def("__repr__", [](const AchievedTarget& t) {
        return fmt::format("<{}: wanted {:.10g}, achieved {:.10g}>", t.output, t.wanted, t.achieved);
      });
  py::class_<Unidentified>(module, "Unidentified", "A direction of parameters that the targets do not see.")
      .def_readonly("direction", &Unidentified::direction)
      .def_readonly("sentence", &Unidentified::sentence)
      .def("__repr__", [](const Unidentified& u) { return "<Unidentified: " + u.sentence + ">"; });
  py::class_<CalibrationStep>(module, "CalibrationStep", "One evaluation of all tests.")
      .def_readonly("parameters", &CalibrationStep::parameters)
      .def_readonly("cost", &CalibrationStep::cost, "Half the sum of squares that is made small.")
      .def_readonly("seconds", &CalibrationStep::seconds)
      .def_readonly("accepted", &CalibrationStep::accepted);
  py::class_<CalibrationResult>(module, "Calibration",
                                "What a calibration found, and what the tests can tell of it.")
      .def_readonly("converged", &CalibrationResult::converged, "A minimum was found.")
      .def_readonly("reached", &CalibrationResult::reached, "Every target is met within its tolerance.")
      .def_readonly("reason", &CalibrationResult::reason, "Why it ended, a sentence.")
      .def_readonly("parameters", &CalibrationResult::parameters, "What was found, CalibratedParameter each.")
      .def_readonly("targets", &CalibrationResult::targets, "What was wanted, AchievedTarget each.")
      .def_readonly("correlation", &CalibrationResult::correlation,
                    "(p, p), of the parameters; NaN where they cannot be told apart.")
      .def_readonly("singular_values", &CalibrationResult::singular_values,
                    "(p,), of the scaled Jacobian, descending.")
      .def_readonly("unidentified", &CalibrationResult::unidentified,
                    "Directions of parameters that the targets do not see, with a sentence each.")
      .def_readonly("history", &CalibrationResult::history, "Every evaluation.")
      .def_readonly("solves", &CalibrationResult::solves, "Evaluations times tests.")
      .def_readonly("warnings", &CalibrationResult::warnings, "Of the cases and of the solves.")
      .def_property_readonly(
          "values",
          [](const CalibrationResult& result) {
            py::dict values;
            for (const CalibratedParameter& parameter : result.parameters)
              values[py::str(parameter.name)] = parameter.value;
            return values;
          },
          "The parameters by name.")
      .def("__repr__", [](const CalibrationResult& result) {
        return fmt::format("<bondstatic.Calibration: {}; {} solves>", result.reason, result.solves);
      });
  module.def("calibrate_case", &calibrate_case, py::arg("file"), py::arg("overrides"), py::arg("progress"));
  module.def("calibrate_models", &calibrate_models, py::arg("tests"), py::arg("parameters"),
             py::arg("targets"), py::arg("options"), py::arg("progress"));
}

}  // namespace bondstatic
