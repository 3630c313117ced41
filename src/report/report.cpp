#include "bondstatic/report.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "bondstatic/error.hpp"
#include "bondstatic/version.hpp"
#include "io/replace_file.hpp"
#include "report/html.hpp"
#include "report/page_bundle.hpp"
#include "report/result_folder.hpp"
#include "report/scene.hpp"

namespace bondstatic {

namespace {

namespace fs = std::filesystem;

const PageBundle& bundle() {
  const PageBundle* const page = page_bundle();
  if (!page)
    throw Error(ExitCode::invalid_input,
                "this build of bondstatic has no page for reports: npm was not there when it was built\n"
                "    cure: install npm (on Debian: apt install npm), configure and build again");
  return *page;
}

[[noreturn]] void cannot_write(const std::string& what, const std::string& cure) {
  throw Error(ExitCode::invalid_input, what + "\n    cure: " + cure);
}

}  // namespace

bool is_report(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string head(html_head.size(), '\0');
  stream.read(head.data(), std::streamsize(head.size()));
  return stream && head == html_head;
}

void check_report(const std::string& file) {
  bundle();
  const fs::path path(file);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) cannot_write(file + ": is a folder", "name a file");
  if (fs::exists(path, ignored) && !is_report(file))
    cannot_write(file + ": exists, and is no report", "remove it, or name another file: --out FILE");
}

Report write_report(const std::vector<std::string>& folders, const std::string& file) {
  check_report(file);
  const fs::path place = fs::path(file).parent_path();
  if (!place.empty() && !fs::is_directory(place))
    cannot_write(place.string() + ": no such folder", "make it, or name another file: --out FILE");

  PageData data{version(), {}};
  Blocks blocks;
  Report report{file, 0, {}};
  for (const std::string& folder : folders)
    for (FoundRun& found : read_results(folder)) {
      PageRun& run = found.page;
      run.scene = read_scene(found.states, found.si, SceneLimits{}, blocks, run.notes, run.plots);
      for (const std::string& note : run.notes)
        report.notes.push_back(folders.size() > 1 ? folder + ": " + note : note);
      data.runs.push_back(std::move(run));
    }
  const std::string page = html(data, blocks, bundle());
  replace_file(file, page);
  report.bytes = double(page.size());
  return report;
}

}  // namespace bondstatic
