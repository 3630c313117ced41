// Several ranks as threads of the test's process, without MPI.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "system/ranks.hpp"

namespace bondstatic::test {

/// Where the threads meet and what they leave there for each other. A rank that has left for good, by an
/// exception or too early, would leave the others waiting: they get an exception, too.
class MeetingPlace {
 public:
  explicit MeetingPlace(int ranks)
      : bytes(std::size_t(ranks)), numbers(bytes.size()), status(bytes.size()), parcels(bytes.size()) {}

  int ranks() const { return int(bytes.size()); }

  void wait_for_all() {
    std::unique_lock lock(mutex_);
    const long round = round_;
    if (++arrived_ == ranks()) {
      arrived_ = 0;
      ++round_;
      changed_.notify_all();
      return;
    }
    changed_.wait(lock, [&] { return round_ != round || left_; });
    if (round_ == round) throw std::logic_error("a rank waits for one that has left");
  }

  void leave(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    left_ = true;
    if (failure && !first_failure_) first_failure_ = failure;
    changed_.notify_all();
  }

  std::exception_ptr first_failure() const { return first_failure_; }

  // One a rank, written by that rank alone.
  std::vector<std::string> bytes;
  std::vector<std::vector<double>> numbers;
  std::vector<RankStatus> status;
  std::vector<std::span<const Ranks::Parcel>> parcels;

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int arrived_ = 0;
  long round_ = 0;
  bool left_ = false;
  std::exception_ptr first_failure_;
};

class ThreadRanks final : public Ranks {
 private:
  /// What `read` finds when all have written; none writes again before all have read.
  template <class Read>
  auto met(Read read) {
    place_.wait_for_all();
    auto found = read();
    place_.wait_for_all();
    return found;
  }

 public:
  ThreadRanks(MeetingPlace& place, int rank) : place_(place), rank_(std::size_t(rank)) {}

  int rank() const override { return int(rank_); }
  int size() const override { return place_.ranks(); }
  int on_this_machine() const override { return size(); }

  RankStatus agree(const RankStatus& mine, void (*)(const RankStatus&)) override {
    place_.status[rank_] = mine;
    return met([&] {
      for (const RankStatus& one : place_.status)
        if (one.code != ExitCode::done) return one;
      return RankStatus{};
    });
  }

  std::string scatter(const std::function<std::string(int rank)>& made) override {
    if (rank_ == 0)
      for (int r = 0; r < size(); ++r) place_.bytes[std::size_t(r)] = made(r);
    return met([&] { return place_.bytes[rank_]; });
  }

  std::vector<std::string> gather(const std::string& mine) override {
    place_.bytes[rank_] = mine;
    return met([&] { return rank_ == 0 ? place_.bytes : std::vector<std::string>{}; });
  }

  std::string broadcast(const std::string& of_first) override {
    if (rank_ == 0) place_.bytes[0] = of_first;
    return met([&] { return place_.bytes[0]; });
  }

  std::vector<double> all_gather(std::span<const double> mine) override {
    place_.numbers[rank_].assign(mine.begin(), mine.end());
    return met([&] {
      std::vector<double> all;
      for (const std::vector<double>& one : place_.numbers) {
        if (one.size() != mine.size()) throw std::logic_error("ranks give different numbers to all_gather");
        all.insert(all.end(), one.begin(), one.end());
      }
      return all;
    });
  }

  void exchange(std::span<const Parcel> sent, std::span<const Parcel> taken) override {
    place_.parcels[rank_] = sent;
    met([&] {
      for (const Parcel& parcel : taken) {
        const auto& theirs = place_.parcels[std::size_t(parcel.rank)];
        const auto mine = std::find_if(theirs.begin(), theirs.end(),
                                       [&](const Parcel& one) { return one.rank == int(rank_); });
        if (mine == theirs.end() || mine->bytes.size() != parcel.bytes.size())
          throw std::logic_error("a rank waits for a parcel that is not sent, or not of this size");
        std::copy(mine->bytes.begin(), mine->bytes.end(), parcel.bytes.begin());
      }
      return true;
    });
  }

 private:
  MeetingPlace& place_;
  std::size_t rank_;
};

/// Runs `each` as `ranks` threads and waits for all of them; rethrows what failed first.
inline void run_ranks(int ranks, const std::function<void(Ranks&)>& each) {
  MeetingPlace place(ranks);
  std::vector<std::thread> threads;
  for (int rank = 0; rank < ranks; ++rank)
    threads.emplace_back([&place, &each, rank] {
      std::exception_ptr failure;
      try {
        ThreadRanks mine(place, rank);
        each(mine);
      } catch (...) {
        failure = std::current_exception();
      }
      place.leave(failure);
    });
  for (std::thread& thread : threads) thread.join();
  if (place.first_failure()) std::rethrow_exception(place.first_failure());
}

}  // namespace bondstatic::test
