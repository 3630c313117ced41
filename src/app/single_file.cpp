#include "app/single_file.hpp"

#include "app/interrupt.hpp"
#include "io/file_set.hpp"
#include "io/stale_staging.hpp"

namespace bondstatic {

void check_single_file(const std::string& folder, const std::string& name) {
  sweep_stale_staging(folder);
  check_writable(folder, {name}, {name});
}

void write_single_file(const std::string& folder, const std::string& name, const std::string& content) {
  const DeferredInterrupts guard;
  FileSet files(folder, DeferredInterrupts::check);
  files.supersede({name});
  files.create(name).append(content);
  files.commit();
}

}  // namespace bondstatic
