// The afternoon version: Eigen triplets of full 12x12 matrices, scalar ordering, SimplicialLDLT, no
// refinement.
#pragma once

#include <Eigen/Core>

#include "bondstatic/model.hpp"

namespace bondstatic::bench {

/// Displacements (6 a particle) of a model whose supports prescribe zero, in its first load case.
Eigen::VectorXd solve_naively(const Model& model);

}  // namespace bondstatic::bench
