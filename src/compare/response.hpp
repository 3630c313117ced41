// The case as it answers to any forces: what K^-1 makes of them.
#pragma once

#include <vector>

#include "bondstatic/modes.hpp"
#include "statics/choose.hpp"
#include "statics/held.hpp"
#include "system/natural_form.hpp"

namespace bondstatic {

/// One load case of a model, factorised.
class Response {
 public:
  /// Throws what solve_statics throws.
  Response(const Model& model, const BondNetwork& network, const Boundary& boundary,
           const StaticOptions& options);

  /// Motion under these forces on the free degrees of freedom, with nothing prescribed; zero elsewhere.
  BodyVectors<double> to(const BodyVectors<double>& forces);

  const FreeDofs& dofs() const { return held_.dofs; }
  std::vector<Mode> lowest_modes(const BodyMasses& masses, Index count);

 private:
  const BondNetwork& network_;
  Incidence incidence_;
  Held held_;
  int threads_;
  Chosen chosen_;
  double pivot_ratio_ = 1;
};

}  // namespace bondstatic
