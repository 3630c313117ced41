// What the bonds of a state tell as a whole: how many carry how much, and into which directions. Directions
// as in the analysis of fabric (Rothenburg and Bathurst 1989, Geotechnique 39(4), 601-614): E(theta) and the
// mean normal force f_n(theta), of bonds projected onto a plane.
#pragma once

#include <string>
#include <vector>

#include "report/page_data.hpp"
#include "report/read_grid.hpp"

namespace bondstatic {

/// Adds a histogram of the normal forces, tension and compression apart, and for each coordinate plane that
/// the model extends in, a rose of the mean |normal force|; where `with_directions`, roses of the number of
/// bonds, and of those that broke. `load_case` is named in the titles unless it is "". Bonds that are left
/// out, or broken, carry nothing and count nowhere else.
void add_force_plots(const Grid& grid, const std::string& load_case, bool with_directions, bool si,
                     std::vector<PagePlot>& plots);

}  // namespace bondstatic
