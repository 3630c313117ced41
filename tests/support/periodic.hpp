// Periodic models built in code, and their six unit strains.
#pragma once

#include <random>
#include <vector>

#include "bondstatic/effective_stiffness.hpp"
#include "bondstatic/model.hpp"

namespace bondstatic::test {

/// Bonds of block 0 wherever spheres of contact_radius_factor times the radius touch across faces or inside;
/// the translation of one particle held; the six unit strains as load cases.
Model periodic_model(const std::vector<Vector3>& points, const std::vector<double>& radii, const Cell& cell,
                     const BondBlock& block, double contact_radius_factor = 1.0);

/// Disordered: edge^3 particles on a jittered cubic lattice of unit pitch in a cube of that edge.
Model periodic_packing(std::mt19937_64& random, int edge, const BondBlock& block);

/// The same matter in a cell of as many cells along each edge.
Model repeated(const Model& model, const std::array<int, 3>& times);

/// Everything turned by a rotation matrix, the cell with it.
Model turned(const Model& model, const Matrix3& rotation);

/// Of `rotation` applied to the matter: c'_ijkl = R_ip R_jq R_kr R_ls c_pqrs, in Voigt's notation.
Matrix6 turned_stiffness(const Matrix6& stiffness, const Matrix3& rotation);

}  // namespace bondstatic::test
