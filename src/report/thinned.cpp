#include "report/thinned.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace bondstatic {

bool thin(PageSeries& series) {
  const std::size_t count = series.y.size(), parts = parts_of_thin_series;
  const bool line = series.draw == PageSeries::Draw::line ||
                    series.draw == PageSeries::Draw::line_and_points ||
                    series.draw == PageSeries::Draw::steps;
  if (!line || !series.low.empty() || count <= 4 * parts) return false;
  std::vector<double> x, y;
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t begin = part * count / parts, end = (part + 1) * count / parts;
    std::size_t lowest = begin, highest = begin, gap = begin;
    for (std::size_t i = begin; i < end; ++i) {
      if (std::isnan(series.y[i])) gap = i;
      if (!(series.y[i] >= series.y[lowest])) lowest = std::isnan(series.y[i]) ? lowest : i;
      if (!(series.y[i] <= series.y[highest])) highest = std::isnan(series.y[i]) ? highest : i;
    }
    for (const std::size_t i : std::set<std::size_t>{begin, lowest, highest, gap, end - 1}) {
      x.push_back(series.x[i]);
      y.push_back(series.y[i]);
    }
  }
  series.x = std::move(x);
  series.y = std::move(y);
  return true;
}

}  // namespace bondstatic
