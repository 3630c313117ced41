// One table of particle quantities and one of bond quantities: the columns of the files and what outputs may
// name.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/model.hpp"
#include "bondstatic/state.hpp"

namespace bondstatic {

struct ParticleRow {
  const Particle& particle;
  const Vector6& displacement;
  const Vector6& reaction;
};

struct ParticleQuantity {
  std::string name;
  std::string meaning;
  double (*of)(const ParticleRow&);
  bool column = true;  ///< stands in particles.csv
};

struct BondQuantity {
  std::string name;
  std::string meaning;
  double (*of)(const BondResult&);
};

/// In the order of the columns; the id, which is no number to compute with, comes before them.
const std::vector<ParticleQuantity>& particle_quantities();

/// In the order of the columns; id, a and b come before them.
const std::vector<BondQuantity>& bond_quantities();

double value_at(const ParticleQuantity& quantity, const Model& model, const State& state, Index particle);

/// Null where there is none of that name.
const ParticleQuantity* find_particle_quantity(const std::string& name);
const BondQuantity* find_bond_quantity(const std::string& name);

}  // namespace bondstatic
