#include "python/fracture_checkpoint.hpp"

#include <fmt/format.h>

#include "bondstatic/error.hpp"
#include "io/replace_file.hpp"

namespace bondstatic {

KeptFracture kept_run(const std::filesystem::path& path, bool resume, const std::vector<Output>& outputs) {
  if (path.empty()) {
    if (resume)
      throw Error(ExitCode::invalid_input,
                  "resume without a checkpoint\n    cure: add checkpoint=\"FILE\", which the run has left");
    return unpacked("", "", outputs);
  }
  const auto content = read_whole_file(path);
  if (!content) return unpacked("", "", outputs);
  if (!resume)
    throw Error(ExitCode::invalid_input,
                fmt::format("{}: an unfinished run lies here\n    cure: add resume=True to go on with it, or "
                            "remove the file to start anew",
                            path.string()));
  return unpacked(*content, path.string(), outputs);
}

void remove_kept(const std::filesystem::path& path) {
  std::error_code ignored;  // the next run will say that it lies here
  std::filesystem::remove(path, ignored);
}

void keep_run(const std::filesystem::path& path, const KeptFracture& kept,
              const std::vector<Output>& outputs) {
  replace_file(path, packed(kept, outputs));
}

}  // namespace bondstatic
