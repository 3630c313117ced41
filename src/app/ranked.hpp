// A run as several processes under an MPI launcher: all of them read and solve, rank 0 alone speaks and
// writes, and an error of any of them is the error of all.
#pragma once

#include <functional>

#include "bondstatic/case_file.hpp"
#include "solver/launched.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

/// Another rank failed, and all know it.
class AgreedError : public Error {
 public:
  explicit AgreedError(const RankStatus& status) : Error(status.code, status.message) {}
};

/// Prints the message of a status to standard error, once the answer so far is out.
void say(const RankStatus& status);

/// What a command came to; the message is whole, as say() prints it. Catches everything.
RankStatus status_of(const std::function<ExitCode()>& command);

/// Runs the command on all ranks that were launched and returns what they agree on, after rank 0 has said
/// it. Standard output of the other ranks leads nowhere.
ExitCode run_ranked(const Launched& launch, const std::function<ExitCode(Ranks*)>& command);

/// Ends this rank where another failed: to be called where all ranks come by. Null: a run of one process.
void agree(Ranks* ranks);

/// Chooses a solver that runs on ranks where the case leaves it open, and threads that share the machine.
/// Throws Error (invalid_input) where the case's solver knows nothing of ranks.
void prepare_for_ranks(StaticOptions& options, const Ranks* ranks);

/// Throws Error (invalid_input) for a command that is one process.
void refuse_ranks(const Ranks* ranks, const std::string& command);

/// This process speaks and writes: rank 0, or the only one.
inline bool is_first(const Ranks* ranks) {
  return !ranks || ranks->rank() == 0;
}

}  // namespace bondstatic
