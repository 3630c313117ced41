#include "bench/naive.hpp"

#include <Eigen/SparseCholesky>
#include <stdexcept>
#include <vector>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/network.hpp"

namespace bondstatic::bench {

Eigen::VectorXd solve_naively(const Model& model) {
  const Index dofs = 6 * Index(model.particles.size());
  std::vector<Index> unknown(std::size_t(dofs), 0);
  for (const Support& support : model.supports)
    for (int i = 0; i < 6; ++i)
      if (support.fixed[std::size_t(i)]) unknown[std::size_t(6 * support.particle + i)] = -1;
  Index count = 0;
  for (Index& number : unknown)
    if (number == 0) number = count++;

  std::vector<Eigen::Triplet<double>> triplets;
  const auto properties = bond_properties(model);
  for (const Link& link : bond_network(model, properties).links) {
    const Matrix12 k = stiffness_matrix(link);
    const auto number = [&](int i) { return unknown[std::size_t(6 * (i < 6 ? link.a : link.b) + i % 6)]; };
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j)
        if (number(i) >= 0 && number(j) >= 0) triplets.emplace_back(int(number(i)), int(number(j)), k(i, j));
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  Eigen::VectorXd load = Eigen::VectorXd::Zero(count);
  for (const Load& l : model.loads)
    for (int i = 0; i < 6; ++i)
      if (const Index n = unknown[std::size_t(6 * l.particle + i)]; n >= 0) load[n] += l.force[i];

  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  if (solver.info() != Eigen::Success) throw std::runtime_error("SimplicialLDLT failed");
  const Eigen::VectorXd solution = solver.solve(load);
  Eigen::VectorXd displacement = Eigen::VectorXd::Zero(dofs);
  for (Index i = 0; i < dofs; ++i)
    if (unknown[std::size_t(i)] >= 0) displacement[i] = solution[unknown[std::size_t(i)]];
  return displacement;
}

}  // namespace bondstatic::bench
