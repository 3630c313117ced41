// Models built in code for tests, and the loads and supports that every test writes.
#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/model.hpp"

namespace bondstatic::test {

using Values = std::vector<std::pair<std::string, double>>;

/// A block of the given law with the parameters named; defaults filled in. Throws std::logic_error on
/// complaints.
BondBlock block(const std::string& law, const Values& values, ContactPoint contact_point = {});

/// Appends a particle, ids from 1; returns its position.
Index add_particle(Model& model, const Vector3& position, double radius);

/// Appends a bond of block `block`, ids from 1.
void add_bond(Model& model, Index a, Index b, Index block = 0);

/// Appends a bond of block 0 between any two particles whose centres are nearer than `reach`.
void bond_within(Model& model, double reach);

void fix_all(Model& model, Index particle, const Vector6& value = Vector6::Zero());
void load(Model& model, Index particle, const Vector6& force, Index load_case = every_case);

/// `bonds` equal bonds from `from` to `to`, first particle held.
Model chain(const BondBlock& block, const Vector3& from, const Vector3& to, Index bonds, double radius);

/// Disordered packing in a cube: particles on a jittered cubic lattice of unit pitch, radii uniform in
/// [smallest, 2 smallest]; lattice neighbours and all pairs nearer than 1.3 bonded. Where the block's law
/// resists all motions every bond follows it; else lattice neighbours get Timoshenko bonds (block 1) so that
/// the packing is sound.
Model random_packing(std::mt19937_64& random, int edge, const BondBlock& block, double smallest = 0.3);

Vector6 vector6(double x, double y, double z, double rx = 0, double ry = 0, double rz = 0);

}  // namespace bondstatic::test
