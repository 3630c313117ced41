// What could be different from the case: each suspect takes the place of what the case says, and is judged by
// the residual that it leaves, as the motion K^-1 r of the case.
#pragma once

#include <vector>

#include "bondstatic/compare.hpp"
#include "compare/finite_forces.hpp"
#include "compare/response.hpp"

namespace bondstatic {

/// The run's state as the explanations need it.
struct Explained {
  double difference = 0;          ///< |u - u_static| over |u_static|, free degrees of freedom
  double left = 0;                ///< |K^-1 r| over |u_static| with the case's own bonds, finite kinematics
  std::vector<Suspect> suspects;  ///< ascending by what they leave
};

/// `motion`: of every particle, rotations too. `boundary`: of the load case.
Explained explain(const Model& model, const BondNetwork& network, const Boundary& boundary,
                  Response& response, const State& statics, const BodyVectors<double>& motion);

}  // namespace bondstatic
