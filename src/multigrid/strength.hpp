// How well a link keeps its two bodies together.
#pragma once

#include "multigrid/rigid_link.hpp"

namespace bondstatic::multigrid {

/// The weakest resistance of a link, rotations measured at its length, and a little of all the others, so
/// that bonds without moments still count among themselves. A clump moved as one must not span a hinge: what
/// the hinge lets through would be left to the smoother.
double strength(const Link& link);
double strength(const RigidLink<float>& link);
double strength(const RigidLink<double>& link);

}  // namespace bondstatic::multigrid
