// What bonds of finite kinematics ask for, part by part of their stiffness.
#pragma once

#include <array>

#include "bondstatic/network.hpp"
#include "system/natural_form.hpp"

namespace bondstatic {

enum StiffnessPart { normal_part, shear_part, twisting_part, bending_part };
inline constexpr std::size_t stiffness_parts = 4;
inline constexpr const char* stiffness_part_names[] = {"normal stiffness", "shear stiffness",
                                                       "twisting stiffness", "bending stiffness"};

using PartForces = std::array<BodyVectors<double>, stiffness_parts>;

/// Forces that must act on the bodies from outside, as gather_forces(), at the state `motion` (rotation
/// vectors; `strain` of the cell beside it). Bonds turn as in DEM codes: the normal force lies along the line
/// of the centres and follows its length, the contact point turns with both particles, relative rotation is
/// that of R_b R_a^T. To first order in the motion this is B^T C B u; a coupling of shear and bending counts
/// as shear.
PartForces finite_forces(const BondNetwork& network, const BodyVectors<double>& motion,
                         const Matrix3& strain);

BodyVectors<double> sum_of(const PartForces& parts);

}  // namespace bondstatic
