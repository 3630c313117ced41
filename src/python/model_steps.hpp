// The steps in which Python makes a model. Each reads what case files say in a block, given by keyword, with
// the readers of cases; they return warnings and throw InputError.
#pragma once

#include <pybind11/stl.h>

#include <map>
#include <string>
#include <vector>

#include "bondstatic/output.hpp"
#include "python/python_model.hpp"

namespace bondstatic {

using Warnings = std::vector<std::string>;

Warnings add_supports(PythonModel& self, const py::dict& given, const Positions& at);
Warnings add_loads(PythonModel& self, const py::dict& given, const Positions& at);
Warnings add_group(PythonModel& self, const py::dict& given, const Positions& at);

/// Values of single bonds under the names of parameters, or contact_point.
using Columns = std::map<std::string, ArrayOf<double>>;

/// A block of bonds; returns how many they are. `strengths`: likewise, under the names of the criterion's
/// parameters. `listed`: those that the model lists, not by distance.
std::pair<Index, Warnings> add_bonds(PythonModel& self, const py::dict& given, const Columns& columns,
                                     const Columns& strengths, bool listed);

/// Parameters of laws; `columns` for single bonds of a block. `block` -1: every block whose law takes all of
/// them.
void set_parameters(PythonModel& self, const py::dict& given, const Columns& columns, Index block);
py::dict parameters_of(const PythonModel& self, Index block);

/// `places`: positions for the keys at, base, middle of [[outputs]].
Output output_of(PythonModel& self, const py::dict& given, const std::map<std::string, Positions>& places);

/// Throws InputError where an output is of another model, whose particles or bonds are not there.
void expect_outputs_of(const Model& model, const std::vector<Output>& outputs);

/// Gives a periodic cell what goes without saying.
void complete_cell(PythonModel& self);

}  // namespace bondstatic
