#include <fmt/format.h>

#include <chrono>

#include "app/commands.hpp"
#include "app/interrupt.hpp"
#include "app/relax_report.hpp"
#include "app/run_case.hpp"
#include "app/terminal.hpp"
#include "io/file_set.hpp"
#include "io/stale_staging.hpp"

namespace bondstatic {

namespace {

constexpr const char* certificate_file = "certificate.json";

void write_certificate(const std::string& folder, const std::string& json) {
  const DeferredInterrupts guard;
  FileSet files(folder, DeferredInterrupts::check);
  files.supersede({certificate_file});
  files.create(certificate_file).append(json);
  files.commit();
}

}  // namespace

ExitCode check(const SolveArguments& arguments) {
  const Case given = read_case(arguments, arguments.overrides, Purpose::dynamics);
  if (!arguments.folder.empty()) {
    sweep_stale_staging(arguments.folder);
    check_writable(arguments.folder, {certificate_file}, {certificate_file});
  }
  StatusLine status;
  auto last = std::chrono::steady_clock::time_point{};
  const Certificate certificate =
      check(given.model, given.solve, given.relax, [&](const std::string& part, const RelaxProgress* run) {
        const auto now = std::chrono::steady_clock::now();
        if (run && now - last < std::chrono::milliseconds(100)) return true;
        last = now;
        status.show(run ? fmt::format("{}: {}", part, progress_text(*run)) : part);
        return true;
      });
  status.clear();
  const RunInfo run{given.title, given.file, given.resolved, given.si, given.warnings};
  const std::string json = certificate_json(given.model, run, certificate);
  if (!arguments.folder.empty()) write_certificate(arguments.folder, json);
  fmt::print("{}", arguments.json ? json : certificate_report(given, certificate));
  return certificate.agrees() ? ExitCode::done : ExitCode::not_accurate;
}

}  // namespace bondstatic
