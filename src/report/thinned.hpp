// Curves of so many points that nobody could see them all.
#pragma once

#include "report/page_data.hpp"

namespace bondstatic {

inline constexpr int parts_of_thin_series = 5000;

/// Leaves the first, the last, the lowest and the highest point of each part of a line of more than four
/// times as many points, in their order, so that no peak is lost; true where it did. Bars, points and series
/// with intervals stay as they are.
bool thin(PageSeries& series);

}  // namespace bondstatic
