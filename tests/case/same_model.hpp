// Equality of models to the last bit; NaN equals NaN.
#pragma once

#include <gtest/gtest.h>

#include <bit>

#include "bondstatic/model.hpp"

namespace bondstatic::test {

inline bool same(double left, double right) {
  return std::bit_cast<std::uint64_t>(left) == std::bit_cast<std::uint64_t>(right);
}

template <class Vector>
bool same_vector(const Vector& left, const Vector& right) {
  bool equal = left.size() == right.size();
  for (decltype(left.size()) i = 0; equal && i < left.size(); ++i) equal = same(left[i], right[i]);
  return equal;
}

using OwnValues = std::map<std::size_t, std::vector<double>>;

inline bool same_columns(const OwnValues& left, const OwnValues& right) {
  bool equal = left.size() == right.size();
  for (const auto& [parameter, values] : left)
    equal = equal && right.count(parameter) && same_vector(values, right.at(parameter));
  return equal;
}

inline bool same_strength(const std::optional<BondStrength>& left, const std::optional<BondStrength>& right) {
  if (!left || !right) return left.has_value() == right.has_value();
  return left->criterion == right->criterion && same_vector(left->parameters, right->parameters) &&
         same_columns(left->overrides, right->overrides) && left->scatter == right->scatter &&
         same_vector(left->spread, right->spread) && left->seed == right->seed &&
         left->together == right->together;
}

inline void expect_same(const Model& left, const Model& right) {
  ASSERT_EQ(left.particles.size(), right.particles.size());
  for (std::size_t i = 0; i < left.particles.size(); ++i) {
    const Particle &l = left.particles[i], &r = right.particles[i];
    ASSERT_TRUE(l.id == r.id && same_vector(l.position, r.position) && same(l.radius, r.radius) &&
                same(l.density, r.density))
        << "particle " << i;
  }
  ASSERT_EQ(left.blocks.size(), right.blocks.size());
  for (std::size_t i = 0; i < left.blocks.size(); ++i) {
    const BondBlock &l = left.blocks[i], &r = right.blocks[i];
    const bool equal =
        l.law == r.law && same_vector(l.parameters, r.parameters) && same_vector(l.fractions, r.fractions) &&
        l.contact_point.kind == r.contact_point.kind && same(l.contact_point.value, r.contact_point.value) &&
        same_columns(l.overrides, r.overrides) && same_strength(l.strength, r.strength);
    ASSERT_TRUE(equal) << "block " << i;
  }
  ASSERT_EQ(left.bonds.size(), right.bonds.size());
  for (std::size_t i = 0; i < left.bonds.size(); ++i) {
    const Bond &l = left.bonds[i], &r = right.bonds[i];
    ASSERT_TRUE(l.id == r.id && l.a == r.a && l.b == r.b && same_vector(l.branch, r.branch) &&
                l.block == r.block && l.in_block == r.in_block)
        << "bond " << i;
  }
  ASSERT_EQ(left.cell.has_value(), right.cell.has_value());
  if (left.cell) {
    ASSERT_TRUE(left.cell->origin == right.cell->origin && left.cell->edges == right.cell->edges &&
                left.cell->periodic == right.cell->periodic);
  }
  ASSERT_EQ(left.strains.size(), right.strains.size());
  for (std::size_t i = 0; i < left.strains.size(); ++i)
    ASSERT_TRUE(left.strains[i].value == right.strains[i].value &&
                left.strains[i].load_case == right.strains[i].load_case);
  ASSERT_EQ(left.supports.size(), right.supports.size());
  for (std::size_t i = 0; i < left.supports.size(); ++i) {
    const Support &l = left.supports[i], &r = right.supports[i];
    ASSERT_TRUE(l.particle == r.particle && l.fixed == r.fixed && same_vector(l.value, r.value) &&
                l.load_case == r.load_case)
        << "support " << i;
  }
  ASSERT_EQ(left.loads.size(), right.loads.size());
  for (std::size_t i = 0; i < left.loads.size(); ++i) {
    const Load &l = left.loads[i], &r = right.loads[i];
    ASSERT_TRUE(l.particle == r.particle && same_vector(l.force, r.force) && l.load_case == r.load_case)
        << "load " << i;
  }
  EXPECT_EQ(left.load_cases, right.load_cases);
}

}  // namespace bondstatic::test
