#include "calibration/ceres_module.hpp"

#include "io/module_file.hpp"

namespace bondstatic {

namespace {

constexpr ModuleFile file{.name = "calibration",
                          .file = "libbondstatic_ceres.so",
                          .entry = "bondstatic_ceres_module",
                          .abi = ceres_module_abi,
                          .package = "libceres-dev and libboost-dev",
                          .option = "BONDSTATIC_CALIBRATION"};

}  // namespace

const CeresModule& ceres_module() {
  static const CeresModule& module = *static_cast<const CeresModule*>(load_module(file));
  return module;
}

}  // namespace bondstatic
