#pragma once

#include "calibration/least_squares.hpp"

namespace bondstatic {

Minimum minimise_by_ceres(const LeastSquares& problem);

}  // namespace bondstatic
