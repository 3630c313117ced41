// Between vectors of the unknowns and vectors by body.
#pragma once

#include <Eigen/Core>

#include "system/natural_form.hpp"

namespace bondstatic {

/// Calls visit(body, dof, unknown) for every unknown in order.
template <class Visit>
void for_each_unknown(const FreeDofs& dofs, Visit visit) {
  Index unknown = 0;
  for (std::size_t p = 0; p < dofs.free.size(); ++p)
    for (int i = 0; i < 6; ++i)
      if (dofs.is_free(Index(p), i)) visit(p, i, unknown++);
}

/// The same in no order, by several threads at once.
template <class Visit>
void for_each_unknown(const FreeDofs& dofs, int threads, Visit visit) {
  const Index bodies = Index(dofs.free.size());
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1 && bodies > worth_threads)
  for (Index p = 0; p < bodies; ++p) {
    Index unknown = dofs.first[std::size_t(p)];
    for (int i = 0; i < 6; ++i)
      if (dofs.is_free(p, i)) visit(std::size_t(p), i, unknown++);
  }
}

/// Forces as the solver wants them: moments divided by the length that its rotations are multiplied by.
template <class Scalar>
Eigen::VectorXd to_unknowns(const BodyVectors<Scalar>& forces, const FreeDofs& dofs, double length,
                            int threads = 1) {
  Eigen::VectorXd values(dofs.unknowns());
  for_each_unknown(dofs, threads, [&](std::size_t p, int i, Index unknown) {
    values[unknown] = forces[p].template cast<double>()[i] / (i < 3 ? 1 : length);
  });
  return values;
}

}  // namespace bondstatic
