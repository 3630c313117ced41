#include "petsc/mpi_ranks.hpp"

#include <chrono>
#include <thread>

#include "petsc/mpi_lifetime.hpp"

namespace bondstatic {

namespace {

using Clock = std::chrono::steady_clock;

// A failed rank waits this long for the others; higher ranks longer, so that of several that fail in
// different places only one speaks.
std::chrono::milliseconds patience(int rank) {
  return std::chrono::milliseconds(2000 + 500 * rank);
}

class MpiRanks final : public Ranks {
 public:
  MpiRanks() {
    start_mpi();
    // Apart from PETSc's messages, so that a rank may arrive here while others are still solving.
    check_mpi(MPI_Comm_dup(MPI_COMM_WORLD, &world_));
    check_mpi(MPI_Comm_rank(world_, &rank_));
    check_mpi(MPI_Comm_size(world_, &size_));
    MPI_Comm machine = MPI_COMM_NULL;
    check_mpi(MPI_Comm_split_type(world_, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &machine));
    check_mpi(MPI_Comm_size(machine, &neighbours_));
    MPI_Comm_free(&machine);
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  int on_this_machine() const override { return neighbours_; }

  RankStatus agree(const RankStatus& mine, void (*say)(const RankStatus&)) override {
    const bool failed = mine.code != ExitCode::done;
    int first_failed = failed ? rank_ : size_;
    MPI_Request request = MPI_REQUEST_NULL;
    check_mpi(MPI_Iallreduce(MPI_IN_PLACE, &first_failed, 1, MPI_INT, MPI_MIN, world_, &request));
    const auto begin = Clock::now();
    for (int arrived = 0;;) {
      check_mpi(MPI_Test(&request, &arrived, MPI_STATUS_IGNORE));
      if (arrived) break;
      if (failed && Clock::now() - begin > patience(rank_)) {
        say(mine);
        MPI_Abort(world_, int(mine.code));
      }
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    if (first_failed == size_) return {};
    return told_by(first_failed, mine);
  }

 private:
  RankStatus told_by(int teller, const RankStatus& mine) const {
    int head[2] = {int(mine.code), int(mine.message.size())};
    check_mpi(MPI_Bcast(head, 2, MPI_INT, teller, world_));
    std::string text = mine.message;
    text.resize(std::size_t(head[1]));
    check_mpi(MPI_Bcast(text.data(), head[1], MPI_CHAR, teller, world_));
    return {ExitCode(head[0]), text};
  }

  MPI_Comm world_ = MPI_COMM_NULL;  // lives as long as MPI
  int rank_ = 0, size_ = 1, neighbours_ = 1;
};

}  // namespace

std::unique_ptr<Ranks> join_mpi_ranks() {
  return std::make_unique<MpiRanks>();
}

}  // namespace bondstatic
