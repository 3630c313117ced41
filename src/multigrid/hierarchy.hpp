// All levels, from the model's own packing to one that is small enough to be solved at once.
#pragma once

#include <vector>

#include "multigrid/clumps.hpp"
#include "multigrid/coarsest.hpp"
#include "multigrid/level.hpp"

namespace bondstatic::multigrid {

/// Which bodies form clumps on each level, and how rows are numbered: kept while only stiffness changes.
struct Plan {
  std::vector<Clumps> clumps;        ///< of each level but the coarsest
  std::vector<Numbering> numbering;  ///< of each level; empty: nothing is planned yet
};

template <class Scalar>
struct Hierarchy {
  std::vector<Level<Scalar>> levels;
  Coarsest coarsest;
  Units units;
};

/// Follows `plan`, or makes it where it is empty. At least one body must have unknowns.
template <class Scalar>
Hierarchy<Scalar> build_hierarchy(const BondNetwork& network, const Incidence& incidence,
                                  const FreeDofs& dofs, int threads, Plan& plan);

extern template Hierarchy<float> build_hierarchy(const BondNetwork&, const Incidence&, const FreeDofs&, int,
                                                 Plan&);
extern template Hierarchy<double> build_hierarchy(const BondNetwork&, const Incidence&, const FreeDofs&, int,
                                                  Plan&);

}  // namespace bondstatic::multigrid
