#include "results/fracture_checkpoint.hpp"

#include <fmt/format.h>

#include "bondstatic/error.hpp"
#include "io/archive.hpp"
#include "results/output_fingerprint.hpp"

namespace bondstatic {

namespace {

const ArchiveFormat format{"fracture checkpoint", 1};

}  // namespace

static void describe(Archive& archive, HistoryColumn& column) {
  archive(column.name, column.values);
}

static void describe(Archive& archive, KeptFracture& kept) {
  archive(kept.run, kept.record.outputs, kept.record.states);
}

std::string packed(const KeptFracture& kept, const std::vector<Output>& outputs) {
  Archive archive(format);
  const std::uint64_t asked = fingerprint_of(outputs);
  archive(asked, kept);
  return archive.finish();
}

KeptFracture unpacked(const std::string& content, const std::string& shown,
                      const std::vector<Output>& outputs) {
  KeptFracture kept;
  if (content.empty()) {
    for (const Output& output : outputs) kept.record.outputs.push_back({output.name, {}});
    return kept;
  }
  Archive archive(format, content, shown);
  std::uint64_t asked = 0;
  archive(asked, kept);
  archive.expect_end();
  if (asked != fingerprint_of(outputs))
    throw Error(ExitCode::invalid_input, fmt::format("{}: belongs to a run with other [[outputs]]\n    "
                                                     "cure: ask for the same outputs, or "
                                                     "remove the file to start anew",
                                                     shown));
  return kept;
}

}  // namespace bondstatic
