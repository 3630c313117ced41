// What stands behind Python's Solution.
#pragma once

#include <memory>

#include "bondstatic/case_file.hpp"
#include "bondstatic/statics.hpp"
#include "python/background.hpp"
#include "python/python_model.hpp"

namespace bondstatic {

/// Model and answer, which views into them keep.
struct Solved {
  std::shared_ptr<const Model> model;
  StaticOptions options;
  StaticSolution solution;
};

/// The options of [solve] by keyword; what is not given is as in `base`.
StaticOptions solve_options(const py::dict& given, StaticOptions base);

/// Tells each phase to the callback, through the watch.
std::function<void(const std::string&)> phases_to(Watch& watch, Callback callback);

}  // namespace bondstatic
