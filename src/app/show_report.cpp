#include "app/show_report.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/commands.hpp"
#include "app/interrupt.hpp"
#include "app/status_line.hpp"
#include "app/terminal.hpp"

namespace bondstatic {

void tell(const Report& report, std::FILE* stream) {
  fmt::print(stream, "  report    {} ({}), for any browser\n", report.file, bytes_text(report.bytes));
  for (const std::string& note : report.notes) fmt::print(stream, "            {}\n", note);
}

ExitCode show_report(const ReportArguments& arguments) {
  const std::vector<std::string>& folders = arguments.folders;
  const std::string file = !arguments.file.empty() ? arguments.file
                           : folders.size() == 1
                               ? (std::filesystem::path(folders.front()) / report_file).string()
                               : std::string(report_file);
  check_report(file);
  StatusLine status;
  status.show("report");
  const DeferredInterrupts guard;
  const Report report = write_report(folders, file);
  status.clear();
  tell(report, stdout);
  return ExitCode::done;
}

}  // namespace bondstatic
