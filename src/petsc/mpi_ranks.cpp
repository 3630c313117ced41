#include "petsc/mpi_ranks.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <thread>

#include "petsc/messages.hpp"
#include "petsc/mpi_lifetime.hpp"

namespace bondstatic {

namespace {

using Clock = std::chrono::steady_clock;

// A failed rank waits this long for the others; higher ranks longer, so that of several that fail in
// different places only one speaks.
std::chrono::milliseconds patience(int rank) {
  return std::chrono::milliseconds(2000 + 500 * rank);
}

// A rank may wait here for minutes, while another reads a case or writes results: it sleeps meanwhile, so
// that the others have the machine.
void wait_asleep(MPI_Request& request) {
  for (int done = 0;;) {
    check_mpi(MPI_Test(&request, &done, MPI_STATUS_IGNORE));
    if (done) return;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

class MpiRanks final : public Ranks {
 public:
  explicit MpiRanks(std::size_t longest_piece) : longest_(longest_piece) {
    start_mpi();
    // Apart from PETSc's messages. agree() is apart from the others', too: a rank that failed arrives there
    // while others are still in the middle of something.
    check_mpi(MPI_Comm_dup(MPI_COMM_WORLD, &world_));
    check_mpi(MPI_Comm_dup(MPI_COMM_WORLD, &agreeing_));
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
    check_mpi(MPI_Iallreduce(MPI_IN_PLACE, &first_failed, 1, MPI_INT, MPI_MIN, agreeing_, &request));
    const auto begin = Clock::now();
    for (int arrived = 0;;) {
      check_mpi(MPI_Test(&request, &arrived, MPI_STATUS_IGNORE));
      if (arrived) break;
      if (failed && Clock::now() - begin > patience(rank_)) {
        say(mine);
        MPI_Abort(agreeing_, int(mine.code));
      }
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    if (first_failed == size_) return {};
    return told_by(first_failed, mine);
  }

  std::string scatter(const std::function<std::string(int rank)>& made) override {
    if (rank_ != 0) return received_from(0);
    for (int other = 1; other < size_; ++other) send(made(other), other);
    return made(0);
  }

  std::vector<std::string> gather(const std::string& mine) override {
    if (rank_ != 0) {
      send(mine, 0);
      return {};
    }
    std::vector<std::string> all{mine};
    for (int other = 1; other < size_; ++other) all.push_back(received_from(other));
    return all;
  }

  std::string broadcast(const std::string& of_first) override {
    std::string text = rank_ == 0 ? of_first : "";
    std::uint64_t size = text.size();
    MPI_Request request = MPI_REQUEST_NULL;
    check_mpi(MPI_Ibcast(&size, 1, MPI_UINT64_T, 0, world_, &request));
    wait_asleep(request);
    text.resize(size);
    for (std::size_t at = 0; at < size; at += longest_)
      check_mpi(MPI_Bcast(text.data() + at, int(std::min(longest_, size - at)), MPI_BYTE, 0, world_));
    return text;
  }

  std::vector<double> all_gather(std::span<const double> mine) override {
    const std::size_t most = longest_ / sizeof(double), ranks = std::size_t(size_);
    std::vector<double> all(mine.size() * ranks), piece;
    for (std::size_t at = 0; at < mine.size(); at += most) {
      const std::size_t count = std::min(most, mine.size() - at);
      piece.resize(count * ranks);
      check_mpi(MPI_Allgather(mine.data() + at, int(count), MPI_DOUBLE, piece.data(), int(count), MPI_DOUBLE,
                              world_));
      for (std::size_t r = 0; r < ranks; ++r)
        std::copy_n(&piece[r * count], count, &all[r * mine.size() + at]);
    }
    return all;
  }

  void exchange(std::span<const Parcel> sent, std::span<const Parcel> taken) override {
    Messages messages(world_, longest_);
    for (const Parcel& parcel : taken)
      messages.receive(parcel.bytes.data(), parcel.bytes.size(), parcel.rank);
    for (const Parcel& parcel : sent) messages.send(parcel.bytes.data(), parcel.bytes.size(), parcel.rank);
    messages.wait();
  }

 private:
  void send(const std::string& text, int to) const {
    const std::uint64_t size = text.size();
    check_mpi(MPI_Send(&size, 1, MPI_UINT64_T, to, size_tag, world_));
    Messages messages(world_, longest_);
    messages.send(text.data(), text.size(), to);
    messages.wait();
  }

  std::string received_from(int other) const {
    std::uint64_t size = 0;
    MPI_Request request = MPI_REQUEST_NULL;
    check_mpi(MPI_Irecv(&size, 1, MPI_UINT64_T, other, size_tag, world_, &request));
    wait_asleep(request);
    std::string text(size, '\0');
    Messages messages(world_, longest_);
    messages.receive(text.data(), size, other);
    messages.wait();
    return text;
  }

  RankStatus told_by(int teller, const RankStatus& mine) const {
    int head[2] = {int(mine.code), int(mine.message.size())};
    check_mpi(MPI_Bcast(head, 2, MPI_INT, teller, agreeing_));
    std::string text = mine.message;
    text.resize(std::size_t(head[1]));
    check_mpi(MPI_Bcast(text.data(), head[1], MPI_CHAR, teller, agreeing_));
    return {ExitCode(head[0]), text};
  }

  static constexpr int size_tag = 0;  // other than that of the contents

  std::size_t longest_;
  MPI_Comm world_ = MPI_COMM_NULL, agreeing_ = MPI_COMM_NULL;  // live as long as MPI
  int rank_ = 0, size_ = 1, neighbours_ = 1;
};

}  // namespace

std::unique_ptr<Ranks> join_mpi_ranks() {
  return join_mpi_ranks(longest_message);
}

std::unique_ptr<Ranks> join_mpi_ranks(std::size_t longest_piece) {
  return std::make_unique<MpiRanks>(longest_piece);
}

}  // namespace bondstatic
