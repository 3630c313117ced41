// Events and broken bonds of a fracture as columns.
#include <fmt/format.h>

#include "python/fractured.hpp"
#include "python/parts.hpp"
#include "results/fracture_words.hpp"

namespace bondstatic {

namespace {

using Of = std::shared_ptr<const Fractured>;

struct PythonEvents {
  Of of;
};

struct PythonBroken {
  Of of;
};

py::array modes_of(const PythonBroken& broken) {
  py::list modes;
  for (const FractureEvent& event : broken.of->fracture.events)
    for (const BrokenBond& bond : event.bonds) modes.append(mode_name(*broken.of->model, bond));
  return py::module_::import("numpy").attr("array")(modes, py::arg("dtype") = "str");
}

void add_events(py::module_& module) {
  py::class_<PythonEvents> events(module, "FractureEvents", R"(What happened, one row an event, in its order.

An event are the bonds that break together. All arrays are read-only views without a copy; NaN where nothing that
carries is left after it.)");
  events.def("__len__", [](const PythonEvents& e) { return e.of->fracture.events.size(); })
      .def("__repr__", [](const PythonEvents& e) {
        return fmt::format("<bondstatic.FractureEvents: {}>", e.of->fracture.events.size());
      });
  const auto add = [&]<class T>(const char* name, T FractureEvent::*member, const char* meaning) {
    events.def_property_readonly(
        name,
        [member](const PythonEvents& e) {
          const auto& all = e.of->fracture.events;
          return view_of_items<T>(e.of, all, all.empty() ? nullptr : &(all.front().*member));
        },
        meaning);
  };
  add("factor", &FractureEvent::factor, "Times the pattern, when they break.");
  add("load", &FractureEvent::load, "While they still carry. Force, unless the pattern is of another kind.");
  add("displacement", &FractureEvent::displacement, "Likewise: load d(displacement) is the pattern's work.");
  add("factor_after", &FractureEvent::factor_after, "When they are gone, what is controlled held constant.");
  add("load_after", &FractureEvent::load_after, "Likewise.");
  add("displacement_after", &FractureEvent::displacement_after, "Likewise.");
  add("runner_up", &FractureEvent::runner_up, "Largest utilisation among the bonds that stay, before.");
  add("released", &FractureEvent::released, "Energy, force x length.");
  add("strain_energy", &FractureEvent::strain_energy, "Of all bonds, after.");
  add("work", &FractureEvent::work, "Of all loads and prescribed motions since the preload was on, after.");
  add("dissipated", &FractureEvent::dissipated, "Sum of released.");
  add("avalanche", &FractureEvent::avalanche, "From 1 on: which events follow from one another.");
}

void add_broken(py::module_& module) {
  py::class_<PythonBroken> broken(module, "BrokenBonds",
                                  "The bonds that broke, one row each, in the order of events.");
  broken.def("__len__", [](const PythonBroken& b) { return b.of->broken.size(); })
      .def("__repr__",
           [](const PythonBroken& b) {
             return fmt::format("<bondstatic.BrokenBonds: {}>", b.of->broken.size());
           })
      .def_property_readonly("mode", &modes_of, "Names of the failure modes: \"tension\", \"shear\", ...");
  const auto add = [&]<class T>(const char* name, T BrokenRow::*member, const char* meaning) {
    broken.def_property_readonly(
        name,
        [member](const PythonBroken& b) {
          const auto& all = b.of->broken;
          return view_of_items<T>(b.of, all, all.empty() ? nullptr : &(all.front().*member));
        },
        meaning);
  };
  add("event", &BrokenRow::event, "Row of the events.");
  add("row", &BrokenRow::row, "Row of Model.bonds.");
  add("id", &BrokenRow::id, "As in Model.bond_ids.");
  add("utilisation", &BrokenRow::utilisation,
      "1 to rounding; more where the bond before it took load away and nothing waits for it to break.");
}

PythonState last_of(const std::shared_ptr<Fractured>& f) {
  return {f, &f->fracture.last, nullptr, f->model.get(), &f->fracture.break_event};
}

py::dict report_of(const Fractured& fractured) {
  const FractureReport& report = fractured.fracture.report;
  py::dict facts;
  facts["solver"] = report.first.solver;
  facts["solver_reason"] = report.first.solver_reason;
  facts["threads"] = report.first.threads;
  facts["unknowns"] = report.first.analysis.unknowns;
  facts["factorisations"] = report.factorisations;
  facts["analyses"] = report.analyses;
  facts["backward_error"] = report.backward_error;
  facts["forward_error"] = report.forward_error;
  facts["energy_balance"] = report.energy_balance;
  facts["seconds"] = report.seconds;
  facts["dropped"] = report.first.dropped;
  return facts;
}

std::vector<std::string> warnings_of(const Fractured& fractured) {
  std::vector<std::string> warnings = fractured.fracture.report.first.warnings;
  const auto& own = fractured.fracture.warnings;
  warnings.insert(warnings.end(), own.begin(), own.end());
  if (fractured.interrupted)
    warnings.push_back(fmt::format("stopped by Ctrl-C after {} events: this is what was found until then",
                                   fractured.fracture.events.size()));
  return warnings;
}

py::dict outputs_of(const std::shared_ptr<Fractured>& fractured) {
  py::dict outputs;
  for (const HistoryColumn& column : fractured->outputs)
    outputs[py::str(column.name)] = view_of_items<double>(fractured, column.values, column.values.data());
  return outputs;
}

}  // namespace

void add_fracture_events(py::module_& module) {
  add_events(module);
  add_broken(module);
  py::class_<SeparatedBody>(module, "SeparatedBody", "Particles that hung on nothing any more.")
      .def_property_readonly(
          "particles", [](const SeparatedBody& body) { return taken(std::vector<Index>(body.particles)); },
          "Their ids.")
      .def_property_readonly(
          "event", [](const SeparatedBody& body) { return Index(body.event); },
          "Row of the event after which they did.")
      .def("__repr__", [](const SeparatedBody& body) {
        return fmt::format("<SeparatedBody: {} particles, event {}>", body.particles.size(), body.event);
      });
  py::class_<Fractured, std::shared_ptr<Fractured>>(module, "Fractured")
      .def_property_readonly("events", [](const std::shared_ptr<Fractured>& f) { return PythonEvents{f}; })
      .def_property_readonly("broken", [](const std::shared_ptr<Fractured>& f) { return PythonBroken{f}; })
      .def_property_readonly("break_event",
                             [](const std::shared_ptr<Fractured>& f) {
                               const std::vector<Index>& events = f->fracture.break_event;
                               return view_of_items<Index>(f, events, events.data());
                             })
      .def_property_readonly("separated", [](const Fractured& f) { return f.fracture.separated; })
      .def_property_readonly("end", [](const Fractured& f) { return name_of(f.fracture.end); })
      .def_property_readonly("reason", [](const Fractured& f) { return f.fracture.reason; })
      .def_property_readonly("last", &last_of)
      .def_property_readonly("outputs", &outputs_of)
      .def_property_readonly("report", &report_of)
      .def_property_readonly("warnings", &warnings_of);
}

}  // namespace bondstatic
