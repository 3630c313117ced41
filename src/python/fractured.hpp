// What stands behind Python's Fracture.
#pragma once

#include <memory>
#include <vector>

#include "bondstatic/fracture.hpp"
#include "bondstatic/relaxation.hpp"
#include "python/state.hpp"

namespace bondstatic {

struct BrokenRow {
  Index event = 0;
  Index row = 0;  ///< of Model::bonds
  Index id = 0;
  double utilisation = 0;
};

/// Model and answer, which views into them keep.
struct Fractured {
  std::shared_ptr<const Model> model;
  Fracture fracture;
  std::vector<HistoryColumn> outputs;  ///< just before each event
  std::vector<BrokenRow> broken;       ///< of all events
  bool interrupted = false;            ///< by Ctrl-C
};

}  // namespace bondstatic
