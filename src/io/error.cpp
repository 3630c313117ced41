#include "bondstatic/error.hpp"

#include <fmt/format.h>

namespace bondstatic {

namespace {

std::string listing(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) text += (text.empty() ? "" : "\n") + to_string(fault);
  return text;
}

// Control characters of a broken file would cut the message short or steer the terminal.
std::string visible(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool control = (static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f;
    result += control ? fmt::format("\\x{:02x}", static_cast<unsigned char>(c)) : std::string(1, c);
  }
  return result;
}

}  // namespace

std::string to_string(const Fault& fault) {
  std::string text = visible(fault.place.file);
  if (fault.place.line > 0) text += fmt::format(":{}:{}", fault.place.line, fault.place.column);
  if (!text.empty()) text += ": ";
  text += visible(fault.message);
  if (!fault.cure.empty()) text += "\n    cure: " + visible(fault.cure);
  return text;
}

InputError::InputError(std::vector<Fault> faults)
    : Error(ExitCode::invalid_input, listing(faults)), faults_(std::move(faults)) {}

}  // namespace bondstatic
