// Results as one HTML file.
#include "bondstatic/report.hpp"

#include <fmt/format.h>

#include "python/background.hpp"
#include "python/parts.hpp"

namespace bondstatic {

namespace {

std::shared_ptr<Report> write(const std::vector<std::string>& folders, const std::string& file) {
  const auto report = std::make_shared<Report>();
  run_watched([report, folders, file](Watch&) { *report = write_report(folders, file); });
  return report;
}

}  // namespace

void add_report(py::module_& module) {
  py::class_<Report, std::shared_ptr<Report>>(module, "Report", "An HTML file that shows results.")
      .def_readonly("file", &Report::file, "Where it lies.")
      .def_readonly("bytes", &Report::bytes, "How large it is.")
      .def_readonly("notes", &Report::notes, "What it leaves out, of which folder.")
      .def(
          "__fspath__", [](const Report& report) { return report.file; }, "The file: a report is a path.")
      .def("__repr__", [](const Report& r) {
        return fmt::format("<bondstatic.Report: {}, {:.0f} bytes>", r.file, r.bytes);
      });
  module.def("report", &write, py::arg("folders"), py::arg("file"));
}

}  // namespace bondstatic
