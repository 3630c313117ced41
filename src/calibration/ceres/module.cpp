// The one symbol that the module shows.
#include <boost/math/distributions/students_t.hpp>

#include "calibration/ceres/minimise.hpp"
#include "calibration/ceres_module.hpp"

namespace {

double student_t(double probability, double degrees_of_freedom) {
  return quantile(boost::math::students_t(degrees_of_freedom), (1 + probability) / 2);
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const bondstatic::CeresModule* bondstatic_ceres_module() {
  static const bondstatic::CeresModule module{bondstatic::ceres_module_abi, BONDSTATIC_VERSION,
                                              bondstatic::minimise_by_ceres, student_t};
  return &module;
}
