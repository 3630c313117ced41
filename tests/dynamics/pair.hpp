// Two particles and one bond: the smallest model that has all six relative motions.
#pragma once

#include <memory>

#include "bondstatic/dynamics.hpp"
#include "support/models.hpp"

namespace bondstatic::test {

/// Bond axes in space: columns e_x (from a to b), e_y, e_z.
inline Matrix3 skew_axes() {
  Matrix3 axes;
  axes.col(0) = Vector3(0.6, 0.64, 0.48);
  axes.col(1) = Vector3(-0.64, 0.6, 0).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

inline Vector6 turned(const Matrix3& by, const Vector6& v) {
  Vector6 result;
  result << by * v.head<3>(), by * v.tail<3>();
  return result;
}

/// Unequal radii, centres `length` apart along the first of `axes`; no supports.
inline Model pair(const BondBlock& block, const Matrix3& axes, double length, double radius_a,
                  double radius_b) {
  const Vector3 origin(0.1, -0.2, 0.3);
  Model model;
  model.blocks.push_back(block);
  add_particle(model, origin, radius_a);
  add_particle(model, origin + length * axes.col(0), radius_b);
  add_bond(model, 0, 1);
  return model;
}

inline ExplicitRun explicit_run(const Model& model, const DynamicOptions& options, Index load_case = 0) {
  return {model, bond_properties(model), load_case, {}, options};
}

inline void give_density(Model& model, double density) {
  for (Particle& particle : model.particles) particle.density = density;
}

/// Degrees of freedom that are held: letters x y z, u v w for the rotations about them.
inline void hold(Model& model, Index particle, const std::string& dofs,
                 const Vector6& value = Vector6::Zero()) {
  Support support{particle, {}, value, every_case};
  for (const char c : dofs) support.fixed[std::string("xyzuvw").find(c)] = true;
  model.supports.push_back(support);
}

}  // namespace bondstatic::test
