#include "calibration/least_squares.hpp"

#include "calibration/ceres_module.hpp"

namespace bondstatic {

Minimum minimise(const LeastSquares& problem) {
  return ceres_module().minimise(problem);
}

}  // namespace bondstatic
