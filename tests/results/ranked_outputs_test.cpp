#include "results/ranked_outputs.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numeric>

#include "bondstatic/error.hpp"
#include "results/pieces.hpp"
#include "support/thread_ranks.hpp"

namespace bondstatic {
namespace {

using test::deal;
using test::restricted;
using test::run_ranks;
using test::Whole;
using test::whole_answer;

struct RankedOutputs : testing::TestWithParam<int> {
  const int count = GetParam();
  const Whole whole = whole_answer({"push", "pull"});
  const Cut cut{whole.model, deal(whole.model, count), count};

  std::vector<OutputValue> found(const std::vector<Output>& outputs) const {
    std::vector<OutputValue> values;
    run_ranks(count, [&](Ranks& ranks) {
      const Piece piece = cut.piece(ranks.rank());
      const auto mine = evaluate_outputs_on_ranks(ranks.rank() == 0 ? outputs : std::vector<Output>{}, piece,
                                                  restricted(whole.solution, piece), ranks);
      if (ranks.rank() == 0)
        values = mine;
      else if (!mine.empty())
        ADD_FAILURE() << "rank " << ranks.rank() << " has outputs, too";
    });
    return values;
  }
};

Output output_of(const std::string& of, std::vector<Index> at, const std::string& load_case = "push",
                 Output::Reduce reduce = Output::Reduce::sum) {
  Output output;
  output.name = of + " of " + load_case;
  output.of = of;
  output.at = std::move(at);
  output.reduce = reduce;
  output.load_case = load_case;
  output.scale = 3;
  return output;
}

std::vector<Index> all_of(std::size_t count) {
  std::vector<Index> all(count);
  std::iota(all.begin(), all.end(), Index(0));
  return all;
}

std::vector<Output> all_kinds(const Model& model) {
  const std::vector<Index> particles = all_of(model.particles.size()), bonds = all_of(model.bonds.size());
  const std::vector<Index> scattered{40, 3, 17, 5, 3, 62, 61, 60, 0};
  using Reduce = Output::Reduce;
  std::vector<Output> outputs{output_of("ux", particles),
                              output_of("u", scattered, "push", Reduce::mean),
                              output_of("reaction_mz", {63}, "pull", Reduce::value),
                              output_of("reaction_fx", particles, "pull"),
                              output_of("y", scattered, "pull", Reduce::max),
                              output_of("uz", {5}, "push", Reduce::value),
                              output_of("sigma", bonds, "push", Reduce::mean),
                              output_of("energy", bonds, "pull"),
                              output_of("fy", {9, 2, 8, 100}, "push", Reduce::sum),
                              output_of("normal_force", bonds, "push", Reduce::max),
                              output_of("energy", {}, "pull"),
                              output_of("work", {}, "push")};
  outputs[0].expected = 1.5;
  outputs[0].tolerance = 1e-3;
  outputs[0].source = "a book";
  for (const Vector3& axis : {Vector3(0, 0, 1), Vector3(1, 0.2, -0.3)})
    for (const char* load_case : {"push", "pull"}) {
      Output young = output_of("apparent_young", {60, 21, 62, 5}, load_case);
      young.base = {0, 7, 1, 2};
      young.axis = axis;
      outputs.push_back(young);
      Output poisson = young;
      poisson.name = "nu of " + std::string(load_case);
      poisson.of = "apparent_poisson";
      poisson.middle = {30, 5, 41, 17, 26, 37, 22};
      outputs.push_back(poisson);
    }
  return outputs;
}

TEST_P(RankedOutputs, AreThoseOfOneProcessBitForBit) {
  const std::vector<Output> outputs = all_kinds(whole.model);
  const auto expected = evaluate_outputs(whole.model, whole.solution, outputs), values = found(outputs);
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(expected[i].value))
      EXPECT_TRUE(std::isnan(values[i].value)) << expected[i].name;
    else
      EXPECT_EQ(std::bit_cast<std::uint64_t>(values[i].value),
                std::bit_cast<std::uint64_t>(expected[i].value))
          << expected[i].name;
    EXPECT_EQ(values[i].name, expected[i].name);
    EXPECT_EQ(values[i].expected, expected[i].expected);
    EXPECT_EQ(values[i].tolerance, expected[i].tolerance);
    EXPECT_EQ(values[i].source, expected[i].source);
  }
}

TEST_P(RankedOutputs, AreNoneWhereNoneAreAskedFor) {
  EXPECT_TRUE(found({}).empty());
}

/// Measured at two particles, which is too few.
Output poisson_of_two() {
  Output output = output_of("apparent_poisson", {60});
  output.base = {1};
  output.middle = {30, 31};
  return output;
}

TEST_P(RankedOutputs, RefuseWhatOneProcessRefusesAndLetTheOthersGo) {
  for (const Output& bad : {output_of("ux", {1}, "twist"), output_of("temperature", {1}),
                            output_of("ux", {1, 2}, "push", Output::Reduce::value), poisson_of_two()}) {
    std::string refusal;
    try {
      evaluate_outputs(whole.model, whole.solution, {bad});
      FAIL() << bad.of << " was not refused";
    } catch (const Error& error) {
      refusal = error.what();
    }
    std::string said;
    run_ranks(count, [&](Ranks& ranks) {
      const Piece piece = cut.piece(ranks.rank());
      try {
        evaluate_outputs_on_ranks({output_of("uy", {2}), bad}, piece, restricted(whole.solution, piece),
                                  ranks);
        if (ranks.rank() == 0) ADD_FAILURE() << bad.of << " was not refused";
      } catch (const Error& error) {
        if (ranks.rank() > 0) throw;
        said = error.what();
      }
      ranks.broadcast("");  // all are here
    });
    EXPECT_EQ(said, refusal);
  }
}

TEST_P(RankedOutputs, LargestDisplacementIsThatOfOneProcess) {
  Whole moved = whole;
  // Of several that move alike the first in the whole model counts, on whichever rank it is.
  auto& push = moved.solution.cases[0].displacement;
  for (const std::size_t p : {61, 30, 12}) push[p] << 0, -3, 4, 0, 0, 0;
  for (Vector6& u : moved.solution.cases[1].displacement) u.setConstant(not_given);
  const auto expected = largest_displacements(moved.model, moved.solution);
  ASSERT_EQ(expected[0].particle, moved.model.particles[12].id);
  ASSERT_FALSE(expected[1].particle);
  run_ranks(count, [&](Ranks& ranks) {
    const Piece piece = cut.piece(ranks.rank());
    const auto largest = largest_displacements_on_ranks(piece, restricted(moved.solution, piece), ranks);
    if (ranks.rank() > 0) {
      EXPECT_TRUE(largest.empty());
      return;
    }
    ASSERT_EQ(largest.size(), expected.size());
    for (std::size_t c = 0; c < expected.size(); ++c) {
      EXPECT_EQ(largest[c].particle, expected[c].particle);
      EXPECT_EQ(largest[c].displacement, expected[c].displacement);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Ranks, RankedOutputs, testing::Values(1, 2, 3, 4, 70));

}  // namespace
}  // namespace bondstatic
