// The parts of the module; each adds what its file is named for.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace bondstatic {

namespace py = pybind11;

void add_background();
void add_errors();
void add_laws(py::module_& module);
void add_model(py::module_& module);
void add_read(py::module_& module);
void add_state(py::module_& module);
void add_solve(py::module_& module);
void add_system(py::module_& module);
void add_relax(py::module_& module);
void add_fracture_events(py::module_& module);
void add_fracture(py::module_& module);
void add_compare(py::module_& module);
void add_analysis(py::module_& module);
void add_calibrate(py::module_& module);
void add_report(py::module_& module);

}  // namespace bondstatic
