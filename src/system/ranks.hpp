// Several processes that are one run, as the rest of the program sees them. MPI itself is known only to the
// module that solver/petsc_module.hpp loads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bondstatic/error.hpp"

namespace bondstatic {

/// How one rank ended a part of the work.
struct RankStatus {
  ExitCode code = ExitCode::done;
  std::string message;  ///< with a code other than done
};

class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// Ranks on this machine, at least 1.
  virtual int on_this_machine() const = 0;

  /// Called by all ranks when they have done with a part, well or not. Returns the same on all of them: done
  /// where all are, else the status of the lowest rank that failed. A rank that failed waits a few seconds
  /// for the others to arrive; where they do not, because they wait for it in the middle of a solve, it says
  /// what happened by `say` and ends all of them with its exit code.
  virtual RankStatus agree(const RankStatus& mine, void (*say)(const RankStatus&)) = 0;

  // What follows is called by all ranks in the same order. Any number of bytes.

  /// What rank 0 makes for each rank: it is asked for one rank after the other, and sent at once.
  virtual std::string scatter(const std::function<std::string(int rank)>& made) = 0;
  /// Of all ranks, in their order, at rank 0; empty elsewhere.
  virtual std::vector<std::string> gather(const std::string& mine) = 0;
  /// Of rank 0, everywhere.
  virtual std::string broadcast(const std::string& of_first) = 0;
  /// Of all ranks, one after the other in their order, everywhere; all give as many.
  virtual std::vector<double> all_gather(std::span<const double> mine) = 0;

  /// What goes to another rank, or comes from it. Both know how much it is.
  struct Parcel {
    int rank = 0;
    std::span<std::byte> bytes;
  };
  /// Sends and takes, at most one of each for a pair of ranks. Returns when all has been taken and what was
  /// sent may be overwritten.
  virtual void exchange(std::span<const Parcel> sent, std::span<const Parcel> taken) = 0;
};

}  // namespace bondstatic
