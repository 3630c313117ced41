#include "dynamics/bond_pack.hpp"

#include <cmath>

namespace bondstatic {

namespace {

void set(Lanes (&lanes)[3], int lane, const Vector3& value) {
  for (int i = 0; i < 3; ++i) lanes[i][lane] = value[i];
}

/// Unit axes even where no bond is, so that its arithmetic stays finite.
BondPack empty_pack(Index ghost) {
  BondPack pack;
  for (int lane = 0; lane < pack_size; ++lane) {
    pack.a[lane] = pack.b[lane] = ghost;
    set(pack.branch, lane, Vector3::UnitX());
    set(pack.axis, lane, Vector3::UnitX());
    set(pack.side, lane, Vector3::UnitY());
    pack.start_length[lane] = pack.length[lane] = 1;
  }
  return pack;
}

/// Perpendicular to the axis; which direction it is does not matter, as C is the same from all sides.
Vector3 side_of(const Vector3& axis) {
  int least = 0;
  axis.cwiseAbs().minCoeff(&least);
  return axis.cross(Vector3::Unit(least)).normalized();
}

}  // namespace

double stretch_share(const Model& model, const Bond& bond, double fraction) {
  const BondBlock& block = model.blocks[std::size_t(bond.block)];
  if (!block.fractions.empty() && !std::isnan(block.fractions[std::size_t(bond.in_block)])) return fraction;
  ContactPoint::Kind kind = block.contact_point.kind;
  if (kind == ContactPoint::Kind::of_law) kind = find_bond_law(block.law)->contact_point.kind;
  const bool ratio = kind == ContactPoint::Kind::fraction || kind == ContactPoint::Kind::section_change;
  return ratio ? fraction : 0.5;
}

std::vector<BondPack> bond_packs(const Model& model, std::span<const BondProperties> properties,
                                 const std::vector<bool>& left_out, Index ghost,
                                 std::vector<Index>& bond_of_lane) {
  bond_of_lane.clear();
  for (std::size_t k = 0; k < model.bonds.size(); ++k)
    if (!left_out[std::size_t(model.bonds[k].a)]) bond_of_lane.push_back(Index(k));
  const std::size_t count = bond_of_lane.size();
  std::vector<BondPack> packs((count + pack_size - 1) / pack_size, empty_pack(ghost));
  for (std::size_t slot = 0; slot < count; ++slot) {
    const auto k = std::size_t(bond_of_lane[slot]);
    const Bond& bond = model.bonds[k];
    const BondProperties& of = properties[k];
    BondPack& pack = packs[slot / pack_size];
    const int lane = int(slot % pack_size);
    const double length = bond.branch.norm();
    const Vector3 axis = bond.branch / length;
    pack.a[lane] = bond.a;
    pack.b[lane] = bond.b;
    set(pack.branch, lane, bond.branch);
    set(pack.axis, lane, axis);
    set(pack.side, lane, side_of(axis));
    pack.start_length[lane] = pack.length[lane] = length;
    pack.start_arm[lane] = of.fraction * length;
    pack.share[lane] = stretch_share(model, bond, of.fraction);
    pack.kn[lane] = of.stiffness.kn;
    pack.ks[lane] = of.stiffness.ks;
    pack.kt[lane] = of.stiffness.kt;
    pack.kb[lane] = of.stiffness.kb;
    pack.coupling[lane] = of.stiffness.coupling;
    pack.feedback[lane] = of.moments_fed_back ? 1 : 0;
  }
  return packs;
}

}  // namespace bondstatic
