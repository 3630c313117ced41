#include "io/archive.hpp"
#include "model/piece.hpp"

namespace bondstatic {

void describe(Archive& archive, Particle& p) {
  archive(p.id, p.position, p.radius, p.density);
}

void describe(Archive& archive, ContactPoint& c) {
  archive(c.kind, c.value);
}

void describe(Archive& archive, std::map<std::size_t, std::vector<double>>& overrides) {
  std::vector<std::size_t> parameters;
  for (const auto& [parameter, column] : overrides) parameters.push_back(parameter);
  archive(parameters);
  for (const std::size_t parameter : parameters) archive(overrides[parameter]);
}

void describe(Archive& archive, BondBlock& b) {
  archive(b.law, b.parameters, b.contact_point, b.overrides, b.fractions);
}

void describe(Archive& archive, Bond& b) {
  archive(b.id, b.a, b.b, b.branch, b.block, b.in_block);
}

void describe(Archive& archive, Support& s) {
  archive(s.particle, s.fixed, s.value, s.load_case);
}

void describe(Archive& archive, Load& l) {
  archive(l.particle, l.force, l.load_case);
}

void describe(Archive& archive, Strain& s) {
  archive(s.value, s.load_case);
}

void describe(Archive& archive, Cell& c) {
  archive(c.origin, c.edges, c.periodic);
}

void describe(Archive& archive, Piece& piece) {
  Model& m = piece.model;
  archive(m.particles, m.blocks, m.bonds, m.supports, m.loads, m.load_cases, m.cell, m.strains);
  archive(piece.own, piece.particle, piece.bond, piece.owner);
}

}  // namespace bondstatic
