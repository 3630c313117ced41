#include <algorithm>
#include <cmath>

#include "modes/eigenpairs.hpp"
#include "modes/masses.hpp"
#include "system/unknowns.hpp"

namespace bondstatic {

namespace {

// The solver's unknowns are rotations times a length: M^1/2 in them, by unknown.
Eigen::VectorXd solver_weights(const Eigen::VectorXd& roots, const FreeDofs& dofs, double length) {
  Eigen::VectorXd weights = roots;
  for_each_unknown(dofs, [&](std::size_t, int i, Index n) { weights[n] /= i < 3 ? 1 : length; });
  return weights;
}

Mode mode_of(const BondNetwork& network, const FreeDofs& dofs, const Eigen::VectorXd& roots,
             Eigen::VectorXd y) {
  Index largest = 0;
  y.cwiseAbs().maxCoeff(&largest);
  y /= std::copysign(y.norm(), y[largest]);
  Mode mode;
  mode.shape.resize(std::size_t(network.bodies));
  motion_of(y.data(), roots, dofs, mode.shape);
  mode.frequency = std::sqrt(twice_energy(network, mode.shape));
  return mode;
}

// K^-1 f. An iterative solver's first answer is good to a few digits: what it leaves is formed and solved for
// once more.
Eigen::VectorXd solved(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                       LinearSolver& solver, const Eigen::VectorXd& force) {
  Eigen::VectorXd x = solver.solve(force).col(0);
  if (!solver.iterative()) return x;
  const double length = network.rotation_length;
  BodyVectors<double> motion(dofs.free.size(), Vector6::Zero());
  for_each_unknown(dofs, [&](std::size_t p, int i, Index n) { motion[p][i] = x[n] / (i < 3 ? 1 : length); });
  const auto q = link_resultants<double>(network, motion, 1);
  const Eigen::VectorXd left =
      force - to_unknowns(gather_forces<double>(network, incidence, q, 1), dofs, length);
  return x + solver.solve(left).col(0);
}

}  // namespace

std::vector<Mode> lowest_modes(const BondNetwork& network, const FreeDofs& dofs, const BodyMasses& masses,
                               LinearSolver& factorised, Index count) {
  const Index n = dofs.unknowns();
  count = std::min(count, n);
  if (count <= 0) return {};
  const Eigen::VectorXd roots = mass_roots(masses, dofs);
  const Eigen::VectorXd weights = solver_weights(roots, dofs, network.rotation_length);
  const Incidence incidence = link_incidence(network);
  const Operator flexibility = [&](const double* x, double* y) {
    const Eigen::VectorXd force = weights.cwiseProduct(Eigen::Map<const Eigen::VectorXd>(x, n));
    Eigen::Map<Eigen::VectorXd>(y, n) =
        weights.cwiseProduct(solved(network, incidence, dofs, factorised, force));
  };
  const EigenPairs pairs = largest_eigenpairs(n, flexibility, count);
  std::vector<Mode> modes;
  modes.reserve(std::size_t(count));
  for (Index i = 0; i < count; ++i) modes.push_back(mode_of(network, dofs, roots, pairs.vectors.col(i)));
  std::stable_sort(modes.begin(), modes.end(),
                   [](const Mode& a, const Mode& b) { return a.frequency < b.frequency; });
  return modes;
}

}  // namespace bondstatic
