// A curve as a picture (SVG) on a ground of its own, so that it reads on any page.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace bondstatic {

struct PlotAxis {
  std::string name;
  std::string unit;  ///< of SI: a prefix is put before it; "": numbers as they are
};

/// A disc at a point of the curve.
struct PlotDot {
  Eigen::Vector2d at;
  double radius = 1.5;  ///< in pixels
};

/// A ring with words above or beside it.
struct PlotMark {
  Eigen::Vector2d at;
  std::string text;
  bool above = true;
};

struct Plot {
  std::string title;
  std::string note;  ///< below the title
  PlotAxis x, y;
  std::vector<Eigen::Vector2d> curve;  ///< broken where a point is not finite
  std::vector<PlotDot> dots;
  std::vector<PlotMark> marks;
};

std::string plot_svg(const Plot& plot);

/// What an axis shows: both ends and the distance of its ticks are round numbers, zero is one of them.
struct PlotScale {
  double low = 0, high = 1, tick = 0.2;
  int exponent = 0;  ///< numbers at the ticks are in units of ten to this
  std::string label;
};
PlotScale plot_scale(const PlotAxis& axis, double least, double largest);

}  // namespace bondstatic
