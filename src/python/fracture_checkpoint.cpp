#include "python/fracture_checkpoint.hpp"

#include <fmt/format.h>

#include "bondstatic/error.hpp"
#include "io/archive.hpp"
#include "io/replace_file.hpp"

namespace bondstatic {

namespace {

const ArchiveFormat format{"fracture checkpoint of Python", 1};

std::uint64_t fingerprint_of(const std::vector<Output>& outputs) {
  Archive f;
  for (const Output& o : outputs)
    f(o.name, o.of, o.at, o.base, o.axis, o.middle, o.reduce, o.scale, o.load_case);
  return f.checksum();
}

void describe_all(Archive& archive, KeptRun& kept) {
  archive(kept.run);
  for (HistoryColumn& column : kept.outputs) archive(column.values);
}

}  // namespace

KeptRun kept_run(const std::filesystem::path& path, bool resume, const std::vector<Output>& outputs) {
  KeptRun kept;
  for (const Output& output : outputs) kept.outputs.push_back({output.name, {}});
  if (path.empty()) {
    if (resume)
      throw Error(ExitCode::invalid_input,
                  "resume without a checkpoint\n    cure: add checkpoint=\"FILE\", which the run has left");
    return kept;
  }
  const auto content = read_whole_file(path);
  if (!content) return kept;
  if (!resume)
    throw Error(ExitCode::invalid_input,
                fmt::format("{}: an unfinished run lies here\n    cure: add resume=True to go on with it, or "
                            "remove the file to start anew",
                            path.string()));
  Archive archive(format, *content, path.string());
  std::uint64_t asked = 0;
  archive(asked);
  if (asked != fingerprint_of(outputs))
    throw Error(ExitCode::invalid_input,
                fmt::format("{}: belongs to a run with other outputs\n    cure: ask for the same outputs, or "
                            "remove the file to start anew",
                            path.string()));
  describe_all(archive, kept);
  archive.expect_end();
  return kept;
}

void remove_kept(const std::filesystem::path& path) {
  std::error_code ignored;  // the next run will say that it lies here
  std::filesystem::remove(path, ignored);
}

void keep_run(const std::filesystem::path& path, const KeptRun& kept, const std::vector<Output>& outputs) {
  Archive archive(format);
  std::uint64_t asked = fingerprint_of(outputs);
  KeptRun copy = kept;
  archive(asked);
  describe_all(archive, copy);
  replace_file(path, archive.finish());
}

}  // namespace bondstatic
