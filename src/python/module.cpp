#include "bondstatic/version.hpp"
#include "python/parts.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace bondstatic;
  module.doc() = "What bondstatic's Python package stands on. Use `import bondstatic`.";
  module.def("version", &version, "Version of the library.");
  add_background();
  add_errors();
  add_laws(module);
  add_model(module);
  add_state(module);
  add_read(module);
  add_solve(module);
  add_system(module);
  add_relax(module);
  add_fracture_events(module);
  add_fracture(module);
  add_compare(module);
  add_analysis(module);
  add_calibrate(module);
  add_report(module);
}
