// What stands behind Python's Model.
#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <optional>

#include "formats/foreign_model.hpp"
#include "python/arrays.hpp"
#include "python/edited_model.hpp"

namespace bondstatic {

struct PythonModel {
  EditedModel edited;
  /// Bonds that were listed when the model was made, by particle ids: bond() gives them their law.
  std::shared_ptr<const ForeignModel> listed;
};

/// The value of a table's key is these model positions instead of a selector; absent: the table is as it is.
using Positions = std::optional<ArrayOf<Index>>;

}  // namespace bondstatic
