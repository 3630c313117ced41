#include "report/result_folder.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "bondstatic/error.hpp"
#include "bondstatic/results.hpp"
#include "io/nearest_name.hpp"
#include "io/text_file.hpp"
#include "report/pages.hpp"

namespace bondstatic {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& folder, const std::string& found, const std::string& cure) {
  throw Error(ExitCode::invalid_input, fmt::format("{}: {}\n    cure: {}", folder, found, cure));
}

bool is_there(const std::string& folder, const char* name) {
  std::error_code ignored;
  return fs::exists(fs::path(folder) / name, ignored);
}

/// What is there of the names that lie beside it, so that a misspelt folder is found.
std::string likely_folder(const std::string& folder) {
  const fs::path path = fs::path(folder).lexically_normal();
  const fs::path name = path.has_filename() ? path.filename() : path.parent_path().filename();
  const fs::path beside = path.has_filename() ? path.parent_path() : path.parent_path().parent_path();
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(beside.empty() ? "." : beside, ignored))
    if (entry.is_directory(ignored)) names.push_back(entry.path().filename().string());
  const std::string nearest = nearest_name(name.string(), names);
  return nearest.empty() ? "" : (beside / nearest).string();
}

void check_folder(const std::string& folder) {
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return;
  if (fs::exists(folder, ignored)) {
    const std::string above = fs::path(folder).parent_path().string();
    refuse(folder, "is a file where a folder of results must be",
           "give the folder it lies in: " + (above.empty() ? "." : above));
  }
  const std::string likely = likely_folder(folder);
  refuse(folder, "is not there",
         likely.empty() ? "let a command write a folder, e.g. `bondstatic solve CASE --out DIR`"
                        : "did you mean " + likely + "?");
}

[[noreturn]] void refuse_empty(const std::string& folder) {
  for (const char* checkpoint : {checkpoint_file, fracture_checkpoint_file})
    if (is_there(folder, checkpoint))
      refuse(folder, fmt::format("has no results yet, but the {} of a run that was interrupted", checkpoint),
             fmt::format("bring it to its end: `bondstatic {} CASE --out {} --resume`",
                         checkpoint == std::string(checkpoint_file) ? "relax" : "fracture", folder));
  if (is_there(folder, "case.toml"))
    refuse(folder, "has a case, but no results",
           fmt::format("`bondstatic solve {}/case.toml --out DIR`", folder));
  refuse(folder,
         "has no results: summary.json (solve, relax, fracture, compare), certificate.json (check), "
         "calibration.json or sweep.csv",
         "let a command write there, e.g. `bondstatic solve CASE --out DIR`");
}

std::string cure_of(const char* command) {
  return fmt::format("write it anew: `bondstatic {} CASE --out DIR`", command);
}

FoundRun summary_page(const std::string& folder, const std::string& file) {
  const JsonValue summary = JsonValue::read(file, cure_of("solve"));
  if (summary.has("comparison")) return compare_page(folder, JsonValue::read(file, cure_of("compare")));
  if (summary.has("at_rest")) return relax_page(folder, JsonValue::read(file, cure_of("relax")));
  if (summary.has("breaks")) return fracture_page(folder, JsonValue::read(file, cure_of("fracture")));
  return solve_page(folder, summary);
}

std::string resolved_case(const std::string& folder, const std::string& kind) {
  const bool calibrated = kind == "calibrate";
  if (kind == "check" || kind == "sweep") return "";
  const fs::path file = fs::path(folder) / (calibrated ? "calibrated.toml" : "case.resolved.toml");
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return "";
  std::vector<Fault> faults;
  auto text = read_text_file(file.string(), {}, faults);
  if (!text) throw InputError(std::move(faults));
  return std::move(*text);
}

}  // namespace

std::vector<FoundRun> read_results(const std::string& folder) {
  check_folder(folder);
  const auto path = [&](const char* name) { return (fs::path(folder) / name).string(); };
  std::vector<FoundRun> runs;
  if (is_there(folder, "summary.json")) runs.push_back(summary_page(folder, path("summary.json")));
  if (is_there(folder, "certificate.json"))
    runs.push_back(check_page(folder, JsonValue::read(path("certificate.json"), cure_of("check"))));
  if (is_there(folder, "calibration.json"))
    runs.push_back(calibrate_page(folder, JsonValue::read(path("calibration.json"), cure_of("calibrate"))));
  if (is_there(folder, "sweep.csv")) runs.push_back(sweep_page(folder));
  if (runs.empty()) refuse_empty(folder);
  for (FoundRun& run : runs) {
    run.page.folder = folder;
    run.page.resolved_case = resolved_case(folder, run.page.kind);
  }
  return runs;
}

}  // namespace bondstatic
