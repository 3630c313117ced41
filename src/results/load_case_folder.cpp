#include "results/load_case_folder.hpp"

#include <fmt/format.h>

namespace bondstatic {

std::string load_case_folder(const std::vector<std::string>& load_cases, const std::string& name) {
  if (load_cases.size() <= 1) return "";
  if (name.empty()) return "unnamed";
  std::string folder;
  for (const char c : name) {
    const unsigned byte = static_cast<unsigned char>(c);
    const bool unsafe =
        byte < 32 || byte == 127 || c == '/' || c == '\\' || c == '%' || (c == '.' && folder.empty());
    folder += unsafe ? fmt::format("%{:02X}", byte) : std::string(1, c);
  }
  return folder;
}

}  // namespace bondstatic
