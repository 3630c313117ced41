// Keyword arguments as the tree that case files are read from, so that the readers of cases check them, too:
// one set of words, units, defaults and messages.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "case/node.hpp"

namespace bondstatic {

namespace py = pybind11;

/// `caller` stands in messages where files have their name. None members of tables are left out; arrays of
/// numpy and other sequences are lists. Throws py::type_error for what no case could say.
Node node_of(const py::handle& value, const std::string& caller);

}  // namespace bondstatic
