// One bond beside the Timoshenko beam of the same E, nu and r; formulas in bondstatic/resolution.hpp.
#pragma once

#include "bondstatic/bond_law.hpp"

namespace bondstatic {

struct BondBeam {
  double slenderness = 0;  ///< L/2r
  double kappa = 0;        ///< kn/ks
  double poisson = 0;
  double offset = 0;  ///< d: of the contact point from mid-length towards the held end, over the length
};

/// 4/3 lambda^2 + 20/9 (1 + nu)
double beam_kappa(double slenderness, double poisson);

/// e_n
double deflection_error(const BondBeam& bond, double bonds_in_row);

/// Smallest n from which |e_n| <= tolerance, whichever end is held.
double bonds_for_tolerance(const BondBeam& bond, double tolerance);

/// e of the same row made of twice as many bonds with half the length and the same kappa, contact points at
/// mid-length.
double halved_error(const BondBeam& bond, double bonds_in_row);

}  // namespace bondstatic
