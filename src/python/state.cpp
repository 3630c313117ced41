#include "python/state.hpp"

#include <fmt/format.h>

#include "bondstatic/error.hpp"
#include "python/parts.hpp"
#include "results/bond_utilisation.hpp"

namespace bondstatic {

namespace {

struct PythonBonds {
  PythonState of;
  const std::vector<BondResult>& results() const { return of.state->bonds; }
};

py::array column(const PythonBonds& bonds, double BondResult::*member) {
  const auto& results = bonds.results();
  return view_of_items<double>(bonds.of.owner, results,
                               results.empty() ? nullptr : &(results.front().*member));
}

py::array half_of_force(const PythonBonds& bonds, int from) {
  const auto& results = bonds.results();
  return view_of_items<double>(bonds.of.owner, results,
                               results.empty() ? nullptr : results.front().force.data() + from, 3);
}

py::array utilisation_of(const PythonBonds& bonds) {
  const PythonState& of = bonds.of;
  if (!of.model)
    throw Error(ExitCode::invalid_input,
                "utilisation is of bonds that stand as in the model, those of a run through time have moved\n"
                "    cure: ask for it in a state of solve() or fracture()");
  const std::vector<Index> whole(of.break_event ? 0 : of.model->bonds.size(), -1);
  return taken(bond_utilisations(*of.model, *of.state, of.break_event ? *of.break_event : whole));
}

py::array vectors(const PythonState& state, const std::vector<Vector6>& values, int from, int width) {
  return view_of_items<double>(state.owner, values, values.empty() ? nullptr : values.front().data() + from,
                               width);
}

py::dict accuracy_of(const PythonState& state) {
  py::dict facts;
  if (!state.accuracy) return facts;
  const Accuracy& accuracy = *state.accuracy;
  facts["backward_error"] = accuracy.backward_error;
  facts["forward_error"] = accuracy.forward_error;
  facts["refinements"] = accuracy.refinements;
  facts["force_balance"] = accuracy.force_balance;
  facts["moment_balance"] = accuracy.moment_balance;
  facts["energy_balance"] = accuracy.energy_balance;
  return facts;
}

}  // namespace

void add_state(py::module_& module) {
  py::class_<PythonBonds> bonds(module, "Bonds",
                                R"(What the bonds carry, one row a bond, in the model's order.

All arrays are read-only views without a copy; NaN where a bond is left out with its body.)");
  bonds.def("__len__", [](const PythonBonds& b) { return b.results().size(); })
      .def("__repr__",
           [](const PythonBonds& b) { return fmt::format("<bondstatic.Bonds: {}>", b.results().size()); })
      .def_property_readonly(
          "force", [](const PythonBonds& b) { return half_of_force(b, 0); },
          "(m, 3), force: what the bond does to its particle b, global axes.")
      .def_property_readonly(
          "moment", [](const PythonBonds& b) { return half_of_force(b, 3); },
          "(m, 3), force x length: likewise, at the contact point.");
  const auto add = [&](const char* name, double BondResult::*member, const char* meaning) {
    bonds.def_property_readonly(
        name, [member](const PythonBonds& b) { return column(b, member); }, meaning);
  };
  add("normal_force", &BondResult::normal_force, "(m,), force: positive in tension.");
  add("shear_force", &BondResult::shear_force, "(m,), force: magnitude.");
  add("twisting_moment", &BondResult::twisting_moment,
      "(m,), force x length: about the axis from a to b, signed.");
  add("bending_moment", &BondResult::bending_moment, "(m,), force x length: magnitude.");
  add("sigma", &BondResult::sigma,
      "(m,), force / length^2: largest normal stress at the section's edge, tension positive; NaN without a "
      "section.");
  add("tau", &BondResult::tau, "(m,), force / length^2: largest shear stress; NaN without a section.");
  add("energy", &BondResult::energy, "(m,), force x length: strain energy.");
  bonds.def_property_readonly(
      "utilisation", &utilisation_of,
      "(m,): what the bond's strength is used to, 1 where it breaks; NaN without a strength, or broken. An "
      "array of its own, made anew each time.");

  py::class_<PythonState>(module, "State",
                          R"(The state of rest under one load case, rows in the model's order.

All arrays are read-only views without a copy, which live as long as they are used; NaN where a particle is left
out.)")
      .def_property_readonly(
          "name", [](const PythonState& s) { return s.state->name; },
          "Of the load case; \"\" where it has none.")
      .def_property_readonly(
          "displacement", [](const PythonState& s) { return vectors(s, s.state->displacement, 0, 6); },
          "(n, 6): ux, uy, uz in length, rx, ry, rz in radians, global axes.")
      .def_property_readonly(
          "rotation", [](const PythonState& s) { return vectors(s, s.state->displacement, 3, 3); },
          "(n, 3), radians: the last three columns of displacement.")
      .def_property_readonly(
          "reaction", [](const PythonState& s) { return vectors(s, s.state->reaction, 0, 6); },
          "(n, 6): fx, fy, fz in force, mx, my, mz in force x length: what the support does to the "
          "particle; zero where free.")
      .def_property_readonly(
          "bonds", [](const PythonState& s) { return PythonBonds{s}; }, "What the bonds carry.")
      .def_property_readonly(
          "accuracy", &accuracy_of,
          "backward_error, forward_error (a bound, relative to the largest displacement), balances; "
          "empty for a run through time.")
      .def_property_readonly(
          "energy", [](const PythonState& s) { return s.state->energy; },
          "Strain energy of all bonds, force x length.")
      .def_property_readonly(
          "work", [](const PythonState& s) { return s.state->work; },
          "Of loads, moved supports and the cell's strain; twice the energy at rest.")
      .def_property_readonly(
          "strain", [](const PythonState& s) { return matrix(s.state->strain); },
          "(3, 3): mean strain of a periodic cell, tensor components.")
      .def_property_readonly(
          "stress", [](const PythonState& s) { return matrix(s.state->stress); },
          "(3, 3), force / length^2: mean stress of a periodic cell, tension positive; else NaN.")
      .def("__repr__", [](const PythonState& s) {
        return fmt::format("<bondstatic.State{}: {} particles, {} bonds>",
                           s.state->name.empty() ? "" : " \"" + s.state->name + "\"",
                           s.state->displacement.size(), s.state->bonds.size());
      });
}

}  // namespace bondstatic
