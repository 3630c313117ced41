// What `export` answers, as a user reads it and as JSON.
#pragma once

#include <string>

#include "bondstatic/case_file.hpp"
#include "formats/write/export_formats.hpp"

namespace bondstatic {

struct ExportAnswer {
  const Case& given;
  std::string format;
  std::string load_case;  ///< "" where the case names none
  std::string folder;
  bool relaxed = false;
  ExportNotes notes;
};

std::string export_report(const ExportAnswer& answer);
/// The list of files lets the next export to the folder know what it may replace.
std::string export_json(const ExportAnswer& answer);

}  // namespace bondstatic
