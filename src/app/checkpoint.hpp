// What the commands share that run for long, keep checkpoints and go on from them.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "app/commands.hpp"

namespace bondstatic {

/// Content of the checkpoint to go on from; "" where the run starts anew. Throws Error (invalid_input) where
/// one lies there unasked, or --resume has no folder to look in.
std::string checkpoint_to_resume(const LongRunArguments& arguments, const std::filesystem::path& file);

/// Says what keeps the run, if anything, and throws what the program ends with after a signal.
[[noreturn]] void end_interrupted(const LongRunArguments& arguments, const std::filesystem::path& file);

/// At most ten lines a second.
class Throttle {
 public:
  bool due();

 private:
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace bondstatic
