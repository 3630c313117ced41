// bs.laws() and bs.strengths(): what `bondstatic laws` lists.
#include <cmath>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/linear_solver.hpp"
#include "bondstatic/strength.hpp"
#include "python/parts.hpp"

namespace bondstatic {

void add_laws(py::module_& module) {
  py::class_<Parameter>(module, "Parameter", "One input of a bond law.")
      .def_readonly("name", &Parameter::name)
      .def_readonly("meaning", &Parameter::meaning)
      .def_property_readonly(
          "unit", [](const Parameter& p) { return si_unit(p.dimension); },
          "SI unit; any other consistent system of units will do. \"\" for a pure number.")
      .def_property_readonly(
          "default",
          [](const Parameter& p) {
            return std::isnan(p.default_value) ? py::object(py::none())
                                               : py::object(py::float_(p.default_value));
          },
          "None where there is no default.")
      .def_readonly("lower", &Parameter::lower, "Values are above it.")
      .def_readonly("upper", &Parameter::upper, "Values are at most that.")
      .def("__repr__", [](const Parameter& p) { return "<Parameter " + p.name + ": " + p.meaning + ">"; });
  py::class_<BondLaw>(module, "Law", "A bond law: what it takes, what it says, where it comes from.")
      .def_readonly("name", &BondLaw::name, "As a case has it.")
      .def_readonly("title", &BondLaw::title, "Name in the literature.")
      .def_readonly("source", &BondLaw::source, "Where it is from.")
      .def_readonly("formulas", &BondLaw::formulas, "As `bondstatic laws NAME` prints them.")
      .def_readonly("parameters", &BondLaw::parameters, "What it takes.")
      .def_readonly("remark", &BondLaw::remark, "What one must know: assumptions.")
      .def("__repr__", [](const BondLaw& law) { return "<Law " + law.name + ": " + law.title + ">"; });
  module.def(
      "laws",
      [] {
        py::dict laws;
        for (const BondLaw& law : bond_laws())
          laws[py::str(law.name)] = py::cast(&law, py::return_value_policy::reference);
        return laws;
      },
      "The bond laws of this build by name, in the order of `bondstatic laws`.");
  py::class_<StrengthCriterion>(module, "Strength", "A strength criterion: what it takes, when bonds break.")
      .def_readonly("name", &StrengthCriterion::name, "As a case has it.")
      .def_readonly("title", &StrengthCriterion::title, "Name in the literature.")
      .def_readonly("source", &StrengthCriterion::source, "Where it is from.")
      .def_readonly("formulas", &StrengthCriterion::formulas, "As `bondstatic laws --strengths` prints them.")
      .def_readonly("parameters", &StrengthCriterion::parameters, "What it takes.")
      .def_property_readonly(
          "scatters",
          [](const StrengthCriterion& criterion) {
            std::vector<std::string> names;
            for (std::size_t p = 0; p < criterion.parameters.size(); ++p)
              if (criterion.scatters[p]) names.push_back(criterion.parameters[p].name);
            return names;
          },
          "Which of them may scatter from bond to bond.")
      .def_readonly("modes", &StrengthCriterion::modes, "In which a bond can fail.")
      .def_readonly("needs_section", &StrengthCriterion::needs_section, "Speaks of stresses.")
      .def_readonly("remark", &StrengthCriterion::remark, "What one must know: assumptions.")
      .def("__repr__", [](const StrengthCriterion& criterion) {
        return "<Strength " + criterion.name + ": " + criterion.title + ">";
      });
  module.def(
      "strengths",
      [] {
        py::dict criteria;
        for (const StrengthCriterion& criterion : strength_criteria())
          criteria[py::str(criterion.name)] = py::cast(&criterion, py::return_value_policy::reference);
        return criteria;
      },
      "The strength criteria of this build by name, in the order of `bondstatic laws --strengths`.");
  module.def(
      "solvers",
      [] {
        py::dict solvers;
        for (const SolverInfo& info : available_solvers()) solvers[py::str(info.name)] = info.description;
        return solvers;
      },
      "The linear solvers of this build by name, best first, and what they are.");
}

}  // namespace bondstatic
