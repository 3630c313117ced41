// All solvers of the build on packings that grow: a Markdown table, growth exponents and a plot.
#pragma once

#include <string>
#include <vector>

namespace bondstatic::bench {

struct Campaign {
  bool million = false;                        ///< a million particles, too
  bool quick = false;                          ///< 1,000 and 8,000 particles only
  std::vector<std::string> packings, solvers;  ///< only these; empty: all
  double longest = 900;                        ///< seconds that one measurement may take
  std::string plot;                            ///< SVG file
};

void compare_solvers(const Campaign& campaign);

}  // namespace bondstatic::bench
