#include "bondstatic/error.hpp"

#include <fmt/format.h>

namespace bondstatic {

namespace {

std::string listing(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) text += (text.empty() ? "" : "\n") + to_string(fault);
  return text;
}

}  // namespace

std::string to_string(const Fault& fault) {
  std::string text = fault.place.file;
  if (fault.place.line > 0) text += fmt::format(":{}:{}", fault.place.line, fault.place.column);
  if (!text.empty()) text += ": ";
  text += fault.message;
  if (!fault.cure.empty()) text += "\n    cure: " + fault.cure;
  return text;
}

InputError::InputError(std::vector<Fault> faults)
    : Error(ExitCode::invalid_input, listing(faults)), faults_(std::move(faults)) {}

}  // namespace bondstatic
