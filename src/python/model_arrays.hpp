// Models of arrays.
#pragma once

#include <memory>
#include <optional>

#include "python/python_model.hpp"

namespace bondstatic {

/// `bonds`: pairs of ids, which are only listed; `cell` as in a case file, or None. Throws InputError with
/// the rows that are at fault.
std::unique_ptr<PythonModel> model_of(const ArrayOf<double>& x, const ArrayOf<double>& radius,
                                      const ArrayOf<Index>& ids,
                                      const std::optional<ArrayOf<double>>& density,
                                      const std::optional<ArrayOf<Index>>& bonds, const py::object& cell);

/// Rows of ids. Throws InputError where there is no such particle.
py::array positions_of(const PythonModel& self, const ArrayOf<Index>& ids);

}  // namespace bondstatic
