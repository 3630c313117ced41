// What a periodic packing is as a material: the mean stress that each mean strain takes, from the static
// answers of a cell.
//
// Stress and strain in Voigt's order (xx, yy, zz, yz, xz, xy); shear strains are engineering ones, twice the
// tensor's component, so that stress = stiffness * strain.
#pragma once

#include "bondstatic/types.hpp"

namespace bondstatic {

/// The isotropic stiffness nearest to a given one, in the norm that rotations of the axes leave alone.
struct IsotropicFit {
  double young = 0;
  double poisson = 0;
  double misfit = 0;  ///< |stiffness - isotropic one| over |stiffness|
};
IsotropicFit isotropic_fit(const Matrix6& stiffness);

struct EffectiveStiffness {
  double volume = 0;     ///< of the cell
  Matrix6 stiffness;     ///< symmetric
  double asymmetry = 0;  ///< |stiffness - its transpose| over |stiffness| as it came out of the solves
  Matrix6 voigt;         ///< upper bound: every particle moves with the mean strain and none turns
  IsotropicFit isotropic;
};

/// (xx, yy, zz, yz, xz, xy) of a symmetric tensor, shear once and twice.
Vector6 voigt_of_stress(const Matrix3& stress);
Vector6 voigt_of_strain(const Matrix3& strain);

}  // namespace bondstatic
