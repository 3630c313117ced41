// Cases of many rows: the tables behind the reading, and that threads change nothing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/case_file.hpp"
#include "bondstatic/error.hpp"
#include "case/same_model.hpp"
#include "io/id_table.hpp"
#include "io/pair_set.hpp"
#include "io/scratch_folder.hpp"

namespace bondstatic::test {
namespace {

TEST(IdTable, IsAMapWhateverTheIds) {
  std::mt19937_64 random(3);
  IdTable table;
  std::map<Index, Index> expected;
  const std::vector<Index> scales{1000, Index(1) << 20, Index(1) << 33, Index(1) << 52};
  for (Index i = 0; i < 20000; ++i) {
    if (i % 5000 == 0) table.expect(5000);
    const Index id = Index(random() % std::uint64_t(scales[random() % scales.size()]));
    ASSERT_EQ(table.add(id, i), expected.emplace(id, i).second) << id;
  }
  EXPECT_EQ(table.size(), Index(expected.size()));
  for (const auto& [id, position] : expected) {
    ASSERT_NE(table.position_of(id), nullptr) << id;
    ASSERT_EQ(*table.position_of(id), position);
    ASSERT_EQ(table.position_of(id + 1) != nullptr, expected.count(id + 1) > 0);
  }
  EXPECT_EQ(table.position_of(-1), nullptr);
}

TEST(PairSet, IsASetOfPairsInEitherOrderBeyond32Bits) {
  constexpr Index particles = 10'000'000;  // particles^2 > 2^46
  std::mt19937_64 random(5);
  PairSet pairs(particles, 10);
  std::set<std::pair<Index, Index>> expected;
  for (int i = 0; i < 30000; ++i) {
    const Index a = particles - 1 - Index(random() % 150), b = Index(random() % 150);
    ASSERT_EQ(pairs.add(a, b), expected.insert(std::minmax(a, b)).second) << a << ' ' << b;
    ASSERT_FALSE(pairs.add(b, a));
  }
}

/// Five thousand particles in a shuffled file of their own, bonded twice over by distance and by a file.
std::string write_case(const ScratchFolder& scratch, const std::string& spoiled_row = "") {
  std::vector<std::string> rows, bonds;
  constexpr int n = 17;
  for (int i = 0; i < n * n * n; ++i)
    rows.push_back(fmt::format("{},{},{},{},{}\n", i + 1, 0.1 * (i % n), 0.1 * (i / n % n), 0.1 * (i / n / n),
                               0.05 + 0.0001 * (i % 5)));
  std::mt19937_64 random(1);
  std::shuffle(rows.begin(), rows.end(), random);
  for (int i = 1; i + n * n + 1 < n * n * n; ++i)
    bonds.push_back(fmt::format("{},{},{}e9\n", i, i + n * n + 1, i));
  std::shuffle(bonds.begin(), bonds.end(), random);
  std::string particles = "id,x,y,z,radius\n", table = "a,b,young\n";
  for (const std::string& row : rows) particles += row;
  for (const std::string& row : bonds) table += row;
  scratch.write("packing.csv", particles);
  scratch.write("bonds.csv", table + spoiled_row);
  return scratch.write("case.toml", R"([[particles]]
file = "packing.csv"
[[bonds]]
law = "timoshenko"
young = 1e9
poisson = 0.2
contact_radius_factor = 1.01
[[bonds]]
law = "timoshenko"
poisson = 0.2
file = "bonds.csv"
existing = "error"
[[supports]]
at = { lowest = { within = 0.01 } }
fix = "all"
)");
}

TEST(LargeCase, IsTheSameOnAnyNumberOfThreads) {
  const ScratchFolder scratch;
  const std::string file = write_case(scratch);
  const Case one = read_case(file, {}, "", Purpose::statics, 1);
  EXPECT_GT(one.model.bonds.size(), 15000u);
  for (const int threads : {2, 4})
    expect_same(one.model, read_case(file, {}, "", Purpose::statics, threads).model);
  const auto properties = bond_properties(one.model), others = bond_properties(one.model, 4);
  for (std::size_t k = 0; k < properties.size(); ++k)
    ASSERT_TRUE(same(properties[k].stiffness.kb, others[k].stiffness.kb) &&
                same(properties[k].stiffness.ks, others[k].stiffness.ks) &&
                same(properties[k].fraction, others[k].fraction));
}

TEST(LargeCase, BondsFormedByDistanceAreSortedByTheirIds) {
  const ScratchFolder scratch;
  const Model model = read_case(write_case(scratch), {}, "", Purpose::statics, 4).model;
  std::pair<Index, Index> before{0, 0};
  for (const Bond& bond : model.bonds) {
    if (bond.block != 0) break;
    const std::pair ids(model.particles[std::size_t(bond.a)].id, model.particles[std::size_t(bond.b)].id);
    ASSERT_LT(ids.first, ids.second);
    ASSERT_LT(before, ids);
    before = ids;
  }
}

TEST(LargeCase, FaultsAreTheSameOnAnyNumberOfThreads) {
  const ScratchFolder scratch;
  for (const std::string row : {"1,2,5e9\n", "7,7,1e9\n", "3,99999,1e9\n", "1,300,-1\n", "1,300\n"}) {
    const std::string file = write_case(scratch, row);
    std::vector<std::string> said;
    for (const int threads : {1, 4}) {
      try {
        read_case(file, {}, "", Purpose::statics, threads);
        ADD_FAILURE() << "no fault for " << row;
      } catch (const InputError& error) {
        said.push_back(error.what());
      }
    }
    ASSERT_EQ(said.size(), 2u);
    EXPECT_EQ(said[0], said[1]);
    EXPECT_NE(said[0].find("bonds.csv:4624:"), std::string::npos) << said[0];
  }
}

}  // namespace
}  // namespace bondstatic::test
