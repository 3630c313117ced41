// A state of rest as Python sees it: every array is a view of the library's own memory.
#pragma once

#include <memory>
#include <string>

#include "bondstatic/statics.hpp"
#include "python/arrays.hpp"

namespace bondstatic {

struct PythonState {
  Owner owner;  ///< of the state
  const State* state = nullptr;
  const Accuracy* accuracy = nullptr;  ///< null of a run's
};

}  // namespace bondstatic
