// Lines over two logarithmic axes, as SVG.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace bondstatic::bench {

struct Line {
  std::string label;
  std::string colour_of;                          ///< lines that share it share a colour
  std::vector<std::pair<double, double>> points;  ///< positive
};

struct Plot {
  std::string title, x, y;
  std::vector<Line> lines;
};

std::string svg(const Plot& plot);

}  // namespace bondstatic::bench
