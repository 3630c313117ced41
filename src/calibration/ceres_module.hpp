// Ceres brings a dozen libraries, a second BLAS (ATLAS) among them, that must not come before the one that
// the solvers use, nor cost every start of the program milliseconds. It is in a module of its own
// (libbondstatic_ceres.so) that is loaded when something is calibrated (io/module_file.hpp).
#pragma once

#include "calibration/least_squares.hpp"

namespace bondstatic {

/// To be counted up with every change to the types that cross.
inline constexpr int ceres_module_abi = 1;

/// What the module's entry point, `bondstatic_ceres_module`, returns a pointer to.
struct CeresModule {
  int abi;
  const char* version;
  Minimum (*minimise)(const LeastSquares& problem);
  /// t such that |T| <= t with that probability, T of Student's distribution.
  double (*student_t)(double probability, double degrees_of_freedom);
};

/// Loads the module at the first call. Throws Error (invalid_input) that says how to come by one where there
/// is none, or one of another version.
const CeresModule& ceres_module();

}  // namespace bondstatic
