// [fracture] by keyword.
#pragma once

#include "bondstatic/case_file.hpp"
#include "case/node.hpp"
#include "python/python_model.hpp"

namespace bondstatic {

/// As it was given: what it says is of a model, whose load cases it names.
struct PythonFractureOptions {
  Node table;

  /// These with some of them replaced. Infinity takes a limit away.
  PythonFractureOptions with(const py::dict& given) const;
};

/// The table of a case that was read; empty where it has none.
PythonFractureOptions fracture_options_of(const Case& given);

/// Throws InputError where the table is not what it should be, or the model's load cases do not go with it.
FractureOptions read_for(PythonModel& model, PythonFractureOptions options);

}  // namespace bondstatic
