// Motions of a single body, or of a whole that moves as one, that its constraints leave free.
#pragma once

#include "mechanism/rigid_bodies.hpp"

namespace bondstatic {

/// Columns: orthonormal basis of the scaled motions that cost at most the strain `free_strain`; `rows` (n x
/// 6) are unit forms of the scaled motion.
Eigen::MatrixXd free_motions(Eigen::MatrixXd rows);

/// Appends constraints to the ground that hold body `number` against the scaled motions in the columns, so
/// that what has been reported is not found again.
void hold(std::vector<Constraint>& constraints, Index number, const RigidBody& body,
          const Eigen::MatrixXd& motions);

}  // namespace bondstatic
