// One table of particle quantities and one of bond quantities: the columns of the files and what outputs may
// name. A derivative that cannot be told where the state is (of a magnitude that is rounding) is nothing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/model.hpp"
#include "bondstatic/sensitivity.hpp"
#include "bondstatic/state.hpp"

namespace bondstatic {

struct ParticleRow {
  const Particle& particle;
  const Vector6& displacement;
  const Vector6& reaction;
};

/// d(quantity)/d(displacement, reaction of its particle).
struct ParticleSlope {
  Vector6 displacement = Vector6::Zero();
  Vector6 reaction = Vector6::Zero();
};

struct ParticleQuantity {
  std::string name;
  std::string meaning;
  double (*of)(const ParticleRow&);
  ParticleSlope (*slope)(const ParticleRow&);
  bool column = true;  ///< stands in particles.csv
};

/// What slopes of bond quantities depend on.
struct BondRow {
  const BondResult& result;
  Vector3 axis;   ///< e_x, from a to b
  double radius;  ///< of the section
};

struct BondQuantity {
  std::string name;
  std::string meaning;
  double (*of)(const BondResult&);
  std::optional<BondWeight> (*slope)(const BondRow&);  ///< of no bond yet
};

/// In the order of the columns; the id, which is no number to compute with, comes before them.
const std::vector<ParticleQuantity>& particle_quantities();

/// In the order of the columns; id, a and b come before them.
const std::vector<BondQuantity>& bond_quantities();

double value_at(const ParticleQuantity& quantity, const Model& model, const State& state, Index particle);
ParticleSlope slope_at(const ParticleQuantity& quantity, const Model& model, const State& state,
                       Index particle);
std::optional<BondWeight> slope_at(const BondQuantity& quantity, const Model& model, const State& state,
                                   const std::vector<BondProperties>& properties, Index bond);

/// Null where there is none of that name.
const ParticleQuantity* find_particle_quantity(const std::string& name);
const BondQuantity* find_bond_quantity(const std::string& name);

}  // namespace bondstatic
