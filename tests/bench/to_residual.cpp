#include "bench/to_residual.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "bench/in_child.hpp"
#include "bench/peak_memory.hpp"
#include "bench/timing.hpp"
#include "bondstatic/linear_solver.hpp"
#include "bondstatic/mechanism.hpp"
#include "model/boundary.hpp"
#include "system/unknowns.hpp"

namespace bondstatic::bench {

namespace {

// The free degrees of freedom without those of particles that hang by no bond.
FreeDofs held_dofs(const BondNetwork& network, const Boundary& boundary) {
  std::vector<std::uint8_t> free = boundary.free;
  for (const auto& body : unsupported_bodies(network, number_free_dofs(free)))
    for (const Index p : body) free[std::size_t(p)] = 0;
  return number_free_dofs(std::move(free));
}

// b - K u.
Eigen::VectorXd residual(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                         const Eigen::VectorXd& b, const Eigen::VectorXd& u) {
  const double length = network.rotation_length;
  BodyVectors<double> motion(std::size_t(network.bodies), Vector6::Zero());
  for_each_unknown(
      dofs, [&](std::size_t p, int i, Index unknown) { motion[p][i] = u[unknown] / (i < 3 ? 1 : length); });
  const auto q = link_resultants<double>(network, motion, 1);
  return b - to_unknowns(gather_forces<double>(network, incidence, q, 1), dofs, length);
}

ToResidual solve_here(const Family& family, Index particles, const std::string& name, double goal) {
  const Model model = family.make(particles);
  const BondNetwork network = bond_network(model, bond_properties(model, 1));
  const Incidence incidence = link_incidence(network);
  const Boundary boundary = boundary_of(model, 0);  // its supports prescribe zero
  const FreeDofs dofs = held_dofs(network, boundary);
  const Eigen::VectorXd b = to_unknowns(boundary.load, dofs, network.rotation_length);
  const auto solver = make_solver(name, 1);

  ToResidual result;
  result.particles = Index(model.particles.size());
  result.bonds = Index(model.bonds.size());
  result.unknowns = dofs.unknowns();
  PeakMemory peak;
  peak.begin();
  result.wall = seconds_of([&] {
    result.set_up = processor_seconds_of([&] {
      solver->analyse(network, dofs);
      solver->factorise(network, dofs);
    });
    Eigen::VectorXd u = Eigen::VectorXd::Zero(b.size()), r = b;
    while (!result.reached && result.rounds < ToResidual::most_rounds) {
      result.solves += processor_seconds_of([&] { u += solver->solve(r); });
      result.iterations += solver->last_solve().iterations;
      result.residuals += processor_seconds_of([&] { r = residual(network, incidence, dofs, b, u); });
      const double left = result.left[result.rounds++] = r.norm() / b.norm();
      result.reached = left <= goal;
    }
  });
  result.peak_bytes = peak.bytes();
  return result;
}

}  // namespace

ToResidual solve_to_residual(const Family& family, Index particles, const std::string& solver, double goal,
                             double longest) {
  static_assert(std::is_trivially_copyable_v<ToResidual>);
  const auto work = [&](void* to) {
    ToResidual result;
    try {
      result = solve_here(family, particles, solver, goal);
    } catch (const std::exception& error) {
      std::strncpy(result.note, error.what(), sizeof result.note - 1);
      *std::find(result.note, result.note + sizeof result.note - 1, '\n') = '\0';
    }
    *static_cast<ToResidual*>(to) = result;
  };
  ToResidual result;
  const ChildEnd end = in_child(longest, work, &result, sizeof result);
  if (end == ChildEnd::out_of_time) std::strcpy(result.note, "took too long");
  if (end == ChildEnd::died) std::strcpy(result.note, "died");
  return result;
}

}  // namespace bondstatic::bench
