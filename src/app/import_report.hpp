// What `import` says of its work.
#pragma once

#include <string>
#include <vector>

#include "formats/import_files.hpp"
#include "formats/packing_facts.hpp"

namespace bondstatic {

struct ImportReport {
  const Imported& imported;
  PackingFacts facts;
  std::vector<std::string> to_be_filled_in;
  std::vector<std::string> written;  ///< paths
};

std::string import_report(const ImportReport& report);
std::string import_json(const ImportReport& report);

}  // namespace bondstatic
