// Particles gathered into the rigid bodies that they must move as.
#pragma once

#include <vector>

#include "bondstatic/model.hpp"
#include "mechanism/constraint.hpp"

namespace bondstatic {

struct RigidBody {
  std::vector<Index> particles;  ///< model positions, ascending
  Vector3 centre = Vector3::Zero();
  double size = 0;  ///< lever arms are measured in it; positive
};

/// Centre: mean of the particle centres. Size: largest distance from it of a particle or of a constraint's
/// point; for a single particle without lever arms its radius.
std::vector<RigidBody> make_bodies(const Model& model, std::vector<std::vector<Index>> members,
                                   const std::vector<Constraint>& constraints);

/// Six columns: the scaled rigid motions of the whole (about `centre`, in lengths of `size`) as scaled
/// motions of the body.
Matrix6 restrict_motion(const RigidBody& body, const Vector3& centre, double size);

}  // namespace bondstatic
