// What a run of another code needs to know of a model: its time step, and how long until it is at rest.
#pragma once

#include <span>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/model.hpp"
#include "bondstatic/relaxation.hpp"
#include "bondstatic/state.hpp"

namespace bondstatic {

struct RunNumbers {
  double time_step = 0;
  Index steps = 0;
  double particle_damping = 0;
  std::vector<std::string> remarks;
};

/// Of the model's only load case, whose static answer is `state`. The time step is the safe part of the
/// critical one; the run lasts until a motion like the static answer, whose frequency is Rayleigh's quotient
/// (nothing is factorised for it), has died out under Cundall's damping to nine digits, and half as long
/// again.
RunNumbers run_numbers(const Model& model, std::span<const BondProperties> properties, const State& state,
                       const RelaxOptions& options, int threads);

}  // namespace bondstatic
