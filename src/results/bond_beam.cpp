#include "results/bond_beam.hpp"

#include <algorithm>
#include <cmath>

namespace bondstatic {

namespace {

double shear_part(double poisson) {
  return 20 * (1 + poisson) / 9;
}

/// Deflection of Timoshenko's beam of n bonds in the unit of the header.
double beam_deflection(const BondBeam& bond, double n) {
  return 16 * std::pow(n * bond.slenderness, 2) / 3 + shear_part(bond.poisson);
}

/// What the bond adds to it, but for the part that changes its sign with the end that is held.
double excess(const BondBeam& bond) {
  return bond.kappa - beam_kappa(bond.slenderness, bond.poisson) +
         16 * std::pow(bond.slenderness * bond.offset, 2);
}

double tilt(const BondBeam& bond) {
  return 16 * bond.slenderness * bond.slenderness * bond.offset;
}

}  // namespace

double beam_kappa(double slenderness, double poisson) {
  return 4 * slenderness * slenderness / 3 + shear_part(poisson);
}

double deflection_error(const BondBeam& bond, double bonds_in_row) {
  return (excess(bond) + tilt(bond)) / beam_deflection(bond, bonds_in_row);
}

double bonds_for_tolerance(const BondBeam& bond, double tolerance) {
  const double most = std::abs(excess(bond)) + std::abs(tilt(bond));
  const double bending = most / tolerance - shear_part(bond.poisson);
  return std::max(1.0, std::ceil(std::sqrt(std::max(0.0, 3 * bending) / 16) / bond.slenderness));
}

double halved_error(const BondBeam& bond, double bonds_in_row) {
  return (bond.kappa - beam_kappa(bond.slenderness / 2, bond.poisson)) / beam_deflection(bond, bonds_in_row);
}

}  // namespace bondstatic
