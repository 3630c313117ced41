// Bonds of a run, eight to a pack: structure of arrays inside a pack, so that eight bonds advance at once,
// and packs one after another, so that a bond's numbers lie together in the cache.
//
// Signs are those of [Chen2022] Eq. 6-7 and Table 8: relative velocity is that of a less that of b, so the
// force (F_cx > 0: compression) acts on b and its opposite on a. Forces and moments are kept in the bond's
// own axes e_x (from a to b), e_y, e_z, which carry them along where kinematics are finite.
#pragma once

#include <span>
#include <vector>

#include "bondstatic/dynamics.hpp"

namespace bondstatic {

inline constexpr int pack_size = 8;

struct alignas(64) Lanes {
  double at[pack_size] = {};

  double& operator[](int lane) { return at[lane]; }
  double operator[](int lane) const { return at[lane]; }
};

struct BondPack {
  Index a[pack_size], b[pack_size];  ///< bodies; lanes without a bond name the ghost body twice
  Lanes branch[3];                   ///< x_b - x_a at the start
  Lanes kn, ks, kt, kb, coupling;
  Lanes feedback;          ///< 0 where twisting and bending moments stay in the bond
  Lanes start_arm, share;  ///< contact point: start_arm + share * (length - start_length) from a
  Lanes start_length;

  Lanes axis[3], side[3];  ///< e_x, e_y
  Lanes length;
  Lanes force[3], moment[3];  ///< in the bond's axes
};

/// The viscous part, where there is one.
struct DashpotPack {
  Lanes cn, cs, ct, cb;
  Lanes force[3], moment[3];  ///< of the latest half step, in the bond's axes
};

/// What the bonds of a pack do to their two bodies: force on b (its opposite acts on a), moments on both.
struct EndForces {
  Lanes force[3], moment_a[3], moment_b[3];
};

/// Contact point as Eq. 1-2 have it: where it is the middle of gap or beam, half of any stretch falls on
/// either side of it; at a fraction of the branch, that fraction does. (A point where sections change divides
/// the branch in a ratio, too.)
double stretch_share(const Model& model, const Bond& bond, double fraction);

/// Packs of the bonds in the model's order without those of bodies left out; `ghost` is the number of a body
/// that nobody looks at.
std::vector<BondPack> bond_packs(const Model& model, std::span<const BondProperties> properties,
                                 const std::vector<bool>& left_out, Index ghost,
                                 std::vector<Index>& bond_of_lane);

}  // namespace bondstatic
