// The state of a model under one load case, however it was found: by a static solve or at the end of a run.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/model.hpp"

namespace bondstatic {

/// What one bond carries. Force and moment are what the bond does to particle b, reduced to the contact
/// point, global axes (-q of bond.hpp); normal_force is positive in tension.
struct BondResult {
  Vector6 force = Vector6::Zero();
  double normal_force = 0;
  double shear_force = 0;
  double twisting_moment = 0;  ///< signed: moment . e_x
  double bending_moment = 0;
  double sigma = not_given;  ///< NaN where the bond has no section
  double tau = not_given;
  double energy = 0;  ///< delta^T C delta / 2
};

/// Of a bond between particles that are left out: NaN throughout.
inline BondResult left_out_bond() {
  BondResult none;
  none.force.setConstant(not_given);
  for (double* value : {&none.normal_force, &none.shear_force, &none.twisting_moment, &none.bending_moment,
                        &none.sigma, &none.tau, &none.energy})
    *value = not_given;
  return none;
}

struct State {
  std::string name;                   ///< of the load case
  std::vector<Vector6> displacement;  ///< by particle; NaN where left out
  std::vector<Vector6>
      reaction;  ///< what the support does to the particle; zero where free, NaN where left out
  std::vector<BondResult> bonds;  ///< NaN where left out
  double energy = 0;              ///< strain energy of all bonds
  /// Of the loads, of moved supports and of the cell's strain, through the whole motion (at rest = 2 energy).
  double work = 0;
  Matrix3 strain = Matrix3::Zero();  ///< mean strain of a periodic cell; displacements have it in them
  /// Mean stress of a periodic cell, tension positive: sum of force times branch over the cell's volume.
  Matrix3 stress = Matrix3::Constant(not_given);
};

}  // namespace bondstatic
