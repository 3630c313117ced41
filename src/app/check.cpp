#include <fmt/format.h>

#include <chrono>

#include "app/commands.hpp"
#include "app/relax_report.hpp"
#include "app/run_case.hpp"
#include "app/single_file.hpp"
#include "app/status_line.hpp"

namespace bondstatic {

namespace {

constexpr const char* certificate_file = "certificate.json";

}  // namespace

ExitCode check(const SolveArguments& arguments) {
  const Case given = read_case(arguments, arguments.overrides, Purpose::dynamics);
  if (!arguments.folder.empty()) check_single_file(arguments.folder, certificate_file);
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
  if (!arguments.folder.empty()) write_single_file(arguments.folder, certificate_file, json);
  fmt::print("{}", arguments.json ? json : certificate_report(given, certificate));
  return certificate.agrees() ? ExitCode::done : ExitCode::not_accurate;
}

}  // namespace bondstatic
