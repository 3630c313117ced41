// How far the bonds of a model are from beams: what a law leaves out or adds against the Timoshenko beam of
// the same E, nu and r, which law `timoshenko` is exactly for any number of bonds ([Chen2022] sections 3.3 to
// 4.3). From lengths and stiffness alone; nothing is solved.
//
// Known for the laws with a round section whose kn = E A/L and kb = E I/L: parallel, pfc-parallel,
// euler-bernoulli, obermayr, edem-v2 with torque feedback (E = kn L/A where stiffness is given), and
// timoshenko where it is asked for another contact point than its own. They agree with the beam in axial and
// bending stiffness, and differ in kappa = kn/ks, in the contact point at t L, and where kappa is given in
// kt. With the bond's slenderness lambda = L/2r,
//
//     kappa of the beam     4/3 lambda^2 + 20/9 (1 + nu)                         ([Chen2022] Eq. 34)
//
// A row of n equal bonds, one end held, a force across the other end, bends by
//
//     F/ks n + F/kb sum of (n L - x_i)^2, x_i the contact points      = F (nL)^3/3EI (1 - 1/4n^2) + n F/ks
//
// at t = 1/2. With the contact point d L off mid-length, positive towards the held end, and every second bond
// turned round (particles large and small in turn, as in [Chen2022] case 5) F/kb L^2 n (d^2 + d) comes on
// top. Against F (nL)^3/3EI + 10/9 F nL/GA (Eq. 29) the deflection has a relative error of
//
//     e_n = (kappa - kappa of the beam + 16 lambda^2 (d^2 + d)) / (16/3 (n lambda)^2 + 20/9 (1 + nu)),
//
// negative where the row is too stiff. Euler-Bernoulli bonds lack shear deformation: -Phi/(4 n^2 + Phi) with
// Phi = 5 (1 + nu)/(3 lambda^2).
//
// A packing is no row; there a difference is one between bond laws, not an error of the packing.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/model.hpp"

namespace bondstatic {

/// nu of the beam that bonds are compared to where nothing says it.
inline constexpr double assumed_poisson = 0.25;

/// Values of single bonds, by nearest rank.
struct Spread {
  double smallest = 0;
  double lower_quartile = 0;
  double median = 0;
  double upper_quartile = 0;
  double largest = 0;

  double largest_magnitude() const { return smallest + largest < 0 ? -smallest : largest; }
};

/// Of the bonds of one [[bonds]] block.
struct BlockResolution {
  Index block = 0;  ///< position in Model::blocks
  std::string law;
  Index bonds = 0;    ///< that this is about
  Index in_rows = 0;  ///< of them, those that meet at most one other bond at either end
  /// Of them, those that are told no nu, which is then assumed: pfc-parallel, edem-v2, kappa given.
  Index poisson_assumed = 0;

  Spread slenderness;  ///< lambda = L/2r
  Spread poisson;      ///< nu of the beam
  Spread row;          ///< n of the unbranched row of bonds that the bond stands in
  Spread deflection;   ///< e_n with that n; each bond counts twice, held at either end
  Spread single;       ///< the same with n = 1
  Spread enough;       ///< smallest n from which |e_n| <= 1 %, at either end
  double coarse = 0;   ///< part of the bonds with |e_n| > 1 % in their row, at the worse end

  Spread transverse;  ///< ks / ks of the beam - 1: stiffness against moving the ends across, without turning
  Spread twisting;    ///< kt / kt of the beam - 1
  Spread offset;      ///< |d|, of the contact point from mid-length, as a part of the length
  Spread kappa;       ///< kn/ks
  Spread beam_kappa;  ///< of the beam: what makes a bond with its contact point at mid-length exact

  std::vector<std::string> advice;  ///< what to change, a sentence each

  /// Beams, fibres, frames; else a packing.
  bool is_of_rows() const { return 2 * in_rows > bonds; }
};

/// For each block that it knows, in the order of the blocks; `poisson` stands in where it is not said. Throws
/// what bond_properties() throws.
std::vector<BlockResolution> resolution_of(const Model& model, int threads = 1,
                                           double poisson = assumed_poisson);

}  // namespace bondstatic
