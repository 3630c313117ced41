#include "bench/to_residual.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <type_traits>

#include "bench/in_child.hpp"
#include "bench/timing.hpp"
#include "bondstatic/linear_solver.hpp"
#include "bondstatic/mechanism.hpp"
#include "model/boundary.hpp"
#include "multigrid/flexible_cg.hpp"
#include "support/peak_memory.hpp"
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

// One solve after another, each told which part of the residual's 2-norm it may leave, as far as a solver
// listens.
class Solves {
 public:
  virtual ~Solves() = default;
  virtual void set_up() = 0;
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& r, double may_leave) = 0;
  virtual int last_iterations() const = 0;
};

// A backend goes as far as it goes: PETSc to 1e-8 of the residual.
class OfBackend final : public Solves {
 public:
  OfBackend(const std::string& name, const BondNetwork& network, const FreeDofs& dofs)
      : solver_(make_solver(name, 1)), network_(network), dofs_(dofs) {}
  void set_up() override {
    solver_->analyse(network_, dofs_);
    solver_->factorise(network_, dofs_);
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& r, double) override { return solver_->solve(r); }
  int last_iterations() const override { return solver_->last_solve().iterations; }

 private:
  std::unique_ptr<LinearSolver> solver_;
  const BondNetwork& network_;
  const FreeDofs& dofs_;
};

// The multigrid stops by the energy of the error, for which rounds after the first aim a little lower than
// for the residual.
class OfMultigrid final : public Solves {
 public:
  OfMultigrid(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs)
      : network_(network), incidence_(incidence), dofs_(dofs) {}
  void set_up() override {
    hierarchy_ = multigrid::build_hierarchy<float>(network_, incidence_, dofs_, 1, plan_);
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& r, double may_leave) override {
    const double reduction = std::clamp(may_leave / 2, 1e-6, 1e-2);
    const auto& row = plan_.numbering.front().row;
    multigrid::Rows<double> rows = multigrid::make_rows<double>(Index(row.size())), x;
    for_each_unknown(
        dofs_, [&](std::size_t p, int i, Index unknown) { rows[std::size_t(row[p])].at[i] = r[unknown]; });
    last_ = multigrid::flexible_cg(hierarchy_, {reduction, 150, 20}, 1, rows, x).iterations;
    Eigen::VectorXd u(dofs_.unknowns());
    for_each_unknown(dofs_, [&](std::size_t p, int i, Index unknown) {
      u[unknown] = x[std::size_t(row[p])].at[i] / hierarchy_.units.stiffness;
    });
    return u;
  }
  int last_iterations() const override { return last_; }

 private:
  const BondNetwork& network_;
  const Incidence& incidence_;
  const FreeDofs& dofs_;
  multigrid::Plan plan_;
  multigrid::Hierarchy<float> hierarchy_;
  int last_ = 0;
};

ToResidual solve_here(const Family& family, Index particles, const std::string& name, double goal) {
  const Model model = family.make(particles);
  const BondNetwork network = bond_network(model, bond_properties(model, 1));
  const Incidence incidence = link_incidence(network);
  const Boundary boundary = boundary_of(model, 0);  // its supports prescribe zero
  const FreeDofs dofs = held_dofs(network, boundary);
  const Eigen::VectorXd b = to_unknowns(boundary.load, dofs, network.rotation_length);
  std::unique_ptr<Solves> solver;
  if (name == "multigrid")
    solver = std::make_unique<OfMultigrid>(network, incidence, dofs);
  else
    solver = std::make_unique<OfBackend>(name, network, dofs);

  ToResidual result;
  result.particles = Index(model.particles.size());
  result.bonds = Index(model.bonds.size());
  result.unknowns = dofs.unknowns();
  test::PeakMemory peak;
  peak.begin();
  result.wall = seconds_of([&] {
    result.set_up = processor_seconds_of([&] { solver->set_up(); });
    Eigen::VectorXd u = Eigen::VectorXd::Zero(b.size()), r = b;
    while (!result.reached && result.rounds < ToResidual::most_rounds) {
      const double may_leave = goal * b.norm() / r.norm();
      result.solves += processor_seconds_of([&] { u += solver->solve(r, may_leave); });
      result.iterations += solver->last_iterations();
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
