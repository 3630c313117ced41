#include "app/with_report.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/interrupt.hpp"
#include "app/show_report.hpp"
#include "bondstatic/report.hpp"

namespace bondstatic {

ExitCode with_report(const SolveArguments& arguments, const std::function<ExitCode()>& command) {
  const std::string& folder = arguments.folder;
  if (arguments.report && folder.empty())
    throw Error(ExitCode::invalid_input,
                "--report shows the results that --out writes\n    cure: give --out DIR, too");
  const std::string file = (std::filesystem::path(folder) / report_file).string();
  if (arguments.report) check_report(file);
  const ExitCode code = command();
  if (!folder.empty() && is_report(file)) std::filesystem::remove(file);
  if (arguments.report) {
    const DeferredInterrupts guard;
    tell(write_report({folder}, file), arguments.json ? stderr : stdout);
  }
  return code;
}

}  // namespace bondstatic
