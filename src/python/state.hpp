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
  /// Of which it is, for what follows from both; null where bonds have turned with the motion.
  const Model* model = nullptr;
  const std::vector<Index>* break_event = nullptr;  ///< as in Fracture; null: all bonds are whole
};

}  // namespace bondstatic
