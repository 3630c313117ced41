// Errors as Python exceptions: the classes are Python's (errors.py), the text is that of the command line.
#include "bondstatic/error.hpp"
#include "bondstatic/mechanism.hpp"
#include "python/parts.hpp"

namespace bondstatic {

namespace {

const char* class_of(ExitCode code) {
  switch (code) {
    case ExitCode::invalid_input:
      return "InputError";
    case ExitCode::mechanism:
      return "MechanismError";
    case ExitCode::not_accurate:
      return "AccuracyError";
    case ExitCode::out_of_memory:
      return "OutOfMemoryError";
    default:
      return "Error";
  }
}

py::list faults_of(const InputError& error) {
  const py::object make = py::module_::import("bondstatic.errors").attr("Fault");
  py::list faults;
  for (const Fault& fault : error.faults())
    faults.append(make(fault.place.file, fault.place.line, fault.place.column, fault.message, fault.cure));
  return faults;
}

py::list mechanisms_of(const MechanismError& error) {
  const py::object make = py::module_::import("bondstatic.errors").attr("Mechanism");
  const char* const kinds[] = {"isolated", "floating", "underconstrained", "internal"};
  py::list mechanisms;
  for (const Mechanism& mechanism : error.mechanisms())
    mechanisms.append(
        make(kinds[int(mechanism.kind)], py::cast(mechanism.particles), mechanism.motions.size()));
  return mechanisms;
}

void raise(const Error& error) {
  const py::object type = py::module_::import("bondstatic.errors").attr(class_of(error.code()));
  const py::object raised = type(error.what(), int(error.code()));
  if (const auto* input = dynamic_cast<const InputError*>(&error)) raised.attr("faults") = faults_of(*input);
  if (const auto* mechanism = dynamic_cast<const MechanismError*>(&error))
    raised.attr("mechanisms") = mechanisms_of(*mechanism);
  PyErr_SetObject(type.ptr(), raised.ptr());
}

}  // namespace

void add_errors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise(error);
    }
  });
}

}  // namespace bondstatic
