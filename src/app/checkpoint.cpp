#include "app/checkpoint.hpp"

#include <fmt/format.h>

#include "app/interrupt.hpp"
#include "io/replace_file.hpp"

namespace bondstatic {

std::string checkpoint_to_resume(const LongRunArguments& arguments, const std::filesystem::path& file) {
  if (arguments.solve.folder.empty()) {
    if (arguments.resume)
      throw Error(ExitCode::invalid_input,
                  "--resume without --out: checkpoints lie beside the results\n    cure: add --out DIR");
    return "";
  }
  const auto content = read_whole_file(file);
  if (content && !arguments.resume)
    throw Error(
        ExitCode::invalid_input,
        fmt::format(
            "{}: an unfinished run lies here\n    cure: add --resume to go on with it, or remove the file "
            "to start anew",
            file.string()));
  if (!content && arguments.resume)
    fmt::print(stderr, "{}: not there, starting from the beginning\n", file.string());
  return content.value_or("");
}

void end_interrupted(const LongRunArguments& arguments, const std::filesystem::path& file) {
  if (!arguments.solve.folder.empty() && std::filesystem::exists(file))
    fmt::print(stderr, "bondstatic: stopped; {} keeps the run, go on with --resume\n", file.string());
  DeferredInterrupts::check();
  throw Error(ExitCode::internal, "the run stopped without a signal");
}

bool Throttle::due() {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < std::chrono::milliseconds(100)) return false;
  last_ = now;
  return true;
}

}  // namespace bondstatic
