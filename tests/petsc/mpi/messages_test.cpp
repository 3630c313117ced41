// What ranks say to each other. Run by any number of ranks: all run all tests, in the same order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "petsc/mpi_ranks.hpp"
#include "solver/petsc_module.hpp"

namespace bondstatic::test {
namespace {

constexpr std::size_t short_piece = 1000;

/// The module's, and the same with messages in pieces of 1000 bytes.
std::vector<std::unique_ptr<Ranks>> both() {
  std::vector<std::unique_ptr<Ranks>> list;
  list.push_back(petsc_module().join_ranks());
  list.push_back(join_mpi_ranks(short_piece));
  return list;
}

/// Different for each rank and at each byte's place; any byte occurs, zero as well.
std::string text_of(int rank, std::size_t size) {
  std::string text(size, '\0');
  for (std::size_t i = 0; i < size; ++i) text[i] = char(i * (7 + std::size_t(rank)) + i / 251 + 31);
  return text;
}

// Beside lengths around that of a piece: nothing, and more than MPI sends without asking.
constexpr std::size_t sizes[] = {0, 1, 999, 1000, 1001, 3000, 1'234'567};

/// Each rank's has another length.
std::size_t size_of(std::size_t turn, int rank) {
  return sizes[(turn + std::size_t(rank)) % std::size(sizes)];
}

TEST(MpiMessages, ScatterGivesEachRankItsOwnTheFirstRankLast) {
  for (const auto& ranks : both())
    for (std::size_t turn = 0; turn < std::size(sizes); ++turn) {
      std::vector<int> asked;
      const std::string mine = ranks->scatter([&](int rank) {
        asked.push_back(rank);
        return text_of(rank, size_of(turn, rank));
      });
      EXPECT_EQ(mine, text_of(ranks->rank(), size_of(turn, ranks->rank())));
      std::vector<int> order;
      if (ranks->rank() == 0) {
        order.resize(std::size_t(ranks->size()));
        std::iota(order.begin(), order.end(), 1);
        order.back() = 0;
      }
      EXPECT_EQ(asked, order);
    }
}

TEST(MpiMessages, GatherGivesAllToTheFirstRankInTheirOrder) {
  for (const auto& ranks : both())
    for (std::size_t turn = 0; turn < std::size(sizes); ++turn) {
      const auto all = ranks->gather(text_of(ranks->rank(), size_of(turn, ranks->rank())));
      ASSERT_EQ(all.size(), ranks->rank() == 0 ? std::size_t(ranks->size()) : 0u);
      for (std::size_t r = 0; r < all.size(); ++r) EXPECT_EQ(all[r], text_of(int(r), size_of(turn, int(r))));
    }
}

TEST(MpiMessages, BroadcastGivesAllWhatTheFirstRankGave) {
  for (const auto& ranks : both())
    for (const std::size_t size : sizes)
      EXPECT_EQ(ranks->broadcast(text_of(ranks->rank(), ranks->rank() == 0 ? size : 5)), text_of(0, size));
}

TEST(MpiMessages, AllGatherGivesAllToAllInTheirOrder) {
  for (const auto& ranks : both())
    for (const std::size_t size : {0, 1, 124, 125, 126, 1000}) {  // 125 are a piece
      std::vector<double> mine(size), expected;
      for (int r = 0; r < ranks->size(); ++r)
        for (std::size_t i = 0; i < size; ++i) {
          expected.push_back(r + double(i) / 1024);
          if (r == ranks->rank()) mine[i] = expected.back();
        }
      EXPECT_EQ(ranks->all_gather(mine), expected);
    }
}

TEST(MpiMessages, ParcelsGoBothWaysBetweenAnyTwo) {
  for (const auto& ranks : both())
    for (std::size_t turn = 0; turn < std::size(sizes); ++turn) {
      // From each to the ranks above it long ones, to those below one byte less; nothing to itself.
      const auto size = [&](int from, int to) {
        const std::size_t bytes = size_of(turn, from + to);
        return bytes > 0 && from > to ? bytes - 1 : bytes;
      };
      std::vector<std::string> sent, taken;
      for (int other = 0; other < ranks->size(); ++other) {
        sent.push_back(text_of(ranks->rank() + 3 * other, size(ranks->rank(), other)));
        taken.emplace_back(size(other, ranks->rank()), '\0');
      }
      std::vector<Ranks::Parcel> out, in;
      for (int other = 0; other < ranks->size(); ++other) {
        if (other == ranks->rank()) continue;
        out.push_back({other, std::as_writable_bytes(std::span(sent[std::size_t(other)]))});
        in.push_back({other, std::as_writable_bytes(std::span(taken[std::size_t(other)]))});
      }
      ranks->exchange(out, in);
      for (int other = 0; other < ranks->size(); ++other) {
        if (other == ranks->rank()) continue;
        EXPECT_EQ(taken[std::size_t(other)], text_of(other + 3 * ranks->rank(), size(other, ranks->rank())));
      }
    }
}

TEST(MpiMessages, AgreeingComesBetweenThem) {
  const auto say_nothing = [](const RankStatus&) {};
  for (const auto& ranks : both()) {
    EXPECT_EQ(ranks->broadcast("before"), "before");
    EXPECT_EQ(ranks->agree({}, say_nothing).code, ExitCode::done);
    const int last = ranks->size() - 1;
    RankStatus mine;
    if (ranks->rank() == last) mine = {ExitCode::mechanism, "of the last"};
    const RankStatus agreed = ranks->agree(mine, say_nothing);
    EXPECT_EQ(agreed.code, ExitCode::mechanism);
    EXPECT_EQ(agreed.message, "of the last");
    EXPECT_EQ(ranks->broadcast("after"), "after");
  }
}

}  // namespace
}  // namespace bondstatic::test
