#include "modes/problem.hpp"

#include <cmath>

namespace bondstatic::test {

VibrationProblem::VibrationProblem(Model model, std::vector<std::uint8_t> free) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> density(1000, 3000);
  for (Particle& particle : model.particles)
    if (std::isnan(particle.density)) particle.density = density(random);
  network = bond_network(model, bond_properties(model));
  dofs = number_free_dofs(std::move(free));
  masses = body_masses(model);
}

Eigen::VectorXd VibrationProblem::mass_diagonal() const {
  Eigen::VectorXd diagonal(dofs.unknowns());
  Index unknown = 0;
  for (std::size_t p = 0; p < dofs.free.size(); ++p)
    for (int i = 0; i < 6; ++i)
      if (dofs.is_free(Index(p), i)) diagonal[unknown++] = i < 3 ? masses.mass[p] : masses.inertia[p];
  return diagonal;
}

std::vector<Mode> VibrationProblem::lowest(Index count, const std::string& name) const {
  const std::unique_ptr<LinearSolver> solver = make_solver(name, 1);
  solver->analyse(network, dofs);
  solver->factorise(network, dofs);
  return lowest_modes(network, dofs, masses, *solver, count);
}

std::vector<Index> VibrationProblem::unknowns_of(const Link& link) const {
  std::vector<Index> unknowns;
  for (const Index body : {link.a, link.b}) {
    Index next = dofs.first[std::size_t(body)];
    for (int i = 0; i < 6; ++i) unknowns.push_back(dofs.is_free(body, i) ? next++ : -1);
  }
  return unknowns;
}

VibrationProblem spring_chain(Index bodies, double k, double m) {
  VibrationProblem chain;
  chain.network.bodies = bodies + 1;
  for (Index i = 0; i < bodies; ++i)
    chain.network.links.push_back({i, i + 1, Vector3::UnitX(), 0.5, {k, 0, 0, 0, 0}});
  std::vector<std::uint8_t> free(std::size_t(bodies) + 1, 1);
  free[0] = 0;
  chain.dofs = number_free_dofs(std::move(free));
  chain.masses.mass.assign(std::size_t(bodies) + 1, m);
  chain.masses.inertia.assign(std::size_t(bodies) + 1, m);
  return chain;
}

}  // namespace bondstatic::test
