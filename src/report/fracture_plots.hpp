// Curves of a run of fracture.
#pragma once

#include <string>
#include <vector>

#include "report/fracture_history.hpp"
#include "report/page_data.hpp"

namespace bondstatic {

/// How load and displacement of the pattern are called, and their units in SI (results/fracture_words.hpp).
struct CurveWords {
  std::string load = "load", load_unit, displacement = "displacement", displacement_unit;
};

/// `from_zero`: nothing displaces before the first break but the pattern.
void put_fracture_plots(std::vector<PagePlot>& plots, const FractureHistory& history, const CurveWords& words,
                        bool from_zero, bool si);

}  // namespace bondstatic
