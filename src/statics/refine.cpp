#include "statics/refine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

constexpr int most_refinements = 100;
constexpr double double_rounding = 0x1p-53;

// Calls visit(body, dof, unknown) for every unknown in order.
template <class Visit>
void for_each_unknown(const FreeDofs& dofs, Visit visit) {
  Index unknown = 0;
  for (std::size_t p = 0; p < dofs.free.size(); ++p)
    for (int i = 0; i < 6; ++i)
      if (dofs.is_free(Index(p), i)) visit(p, i, unknown++);
}

// Forces as the solver wants them: moments divided by the length that its rotations are multiplied by.
template <class Scalar>
Eigen::VectorXd to_unknowns(const BodyVectors<Scalar>& forces, const FreeDofs& dofs, double length) {
  Eigen::VectorXd values(dofs.unknowns());
  for_each_unknown(dofs, [&](std::size_t p, int i, Index unknown) {
    values[unknown] = forces[p].template cast<double>()[i] / (i < 3 ? 1 : length);
  });
  return values;
}

BodyVectors<Extended> residual(const BondNetwork& network, const Incidence& incidence,
                               const Boundary& boundary, const BodyVectors<Extended>& motion, int threads) {
  const auto q = link_resultants<Extended>(network, motion, threads);
  auto r = gather_forces<Extended>(network, incidence, q, threads);
  for (std::size_t p = 0; p < r.size(); ++p) r[p] = boundary.load[p].cast<Extended>() - r[p];
  return r;
}

// Deterministic signs: the estimate below must not depend on a random state.
double sign_of(std::uint64_t n) {
  n = (n ^ (n >> 30)) * 0xbf58476d1ce4e5b9u;
  n = (n ^ (n >> 27)) * 0x94d049bb133111ebu;
  return (n >> 31) & 1 ? 1 : -1;
}

// Forces that a relative motion of rounding size in every link would need, with random signs: B^T C e with
// |e| <= 4 eps |B| |u|. The motion they cause shows what the natural form cannot see of u.
BodyVectors<double> rounding_forces(const BondNetwork& network, const Incidence& incidence,
                                    const BodyVectors<double>& motion) {
  BodyVectors<double> q(network.links.size());
  for (std::size_t k = 0; k < q.size(); ++k) {
    const Link& link = network.links[k];
    Vector6 e = motion_magnitude(link, motion[std::size_t(link.a)], motion[std::size_t(link.b)]);
    for (int i = 0; i < 6; ++i) e[i] *= 4 * extended_rounding * sign_of(6 * k + std::uint64_t(i));
    q[k] = resultants<double>(link.stiffness, bond_axis<double>(link), e);
  }
  return gather_forces<double>(network, incidence, q, 1);
}

// Oettli and Prager's componentwise measure, of the answer as it is written: rounded once to double.
double backward_error(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                      const Boundary& boundary, const BodyVectors<double>& motion, int threads) {
  const auto r = residual(network, incidence, boundary, converted<Extended>(motion), threads);
  const auto magnitude = force_magnitudes(network, incidence, motion, threads);
  double worst = 0;
  for_each_unknown(dofs, [&](std::size_t p, int i, Index) {
    const double scale = magnitude[p][i] + std::abs(boundary.load[p][i]);
    if (scale > 0) worst = std::max(worst, std::abs(to_double(r[p][i])) / scale);
  });
  return worst;
}

// One load case on its way to the last digit.
struct Iterate {
  BodyVectors<Extended> motion;
  double correction = 0;  // largest entry of the last correction, rotations times the length
  double size = 0;        // largest entry of the answer, likewise
  int steps = 0;
  bool done = false;

  void add(const Eigen::VectorXd& step, const FreeDofs& dofs, double length, double pivot_ratio) {
    const double before = correction;
    correction = step.lpNorm<Eigen::Infinity>();
    size = 0;
    for_each_unknown(dofs, [&](std::size_t p, int i, Index unknown) {
      const double scale = i < 3 ? 1 : length;
      motion[p][i] += Extended(step[unknown]) / scale;
      size = std::max(size, std::abs(to_double(motion[p][i])) * scale);
    });
    // Corrections that stop shrinking far above rounding belong to a factor that says nothing of K; near
    // rounding they are the noise of the residual, and the answer is as good as it gets.
    const bool at_rounding = correction <= extended_rounding * size;
    const bool stagnant = steps > 0 && correction > 0.5 * before;
    if (!std::isfinite(correction) || (stagnant && correction > 1e-20 * size) || steps == most_refinements)
      throw AccuracyError(
          fmt::format("the stiffness matrix is numerically singular: corrections stay at {:.1e} of the "
                      "answer (smallest pivot "
                      "ratio {:.1e})\n    cure: look for bodies that hang by bonds many decades softer than "
                      "the rest, or for a "
                      "support that is missing in all but rounding",
                      correction / size, pivot_ratio));
    done = at_rounding || stagnant;
    ++steps;
  }

  void drop_negligible(const FreeDofs& dofs, double length) {
    for_each_unknown(dofs, [&](std::size_t p, int i, Index) {
      if (std::abs(to_double(motion[p][i])) * (i < 3 ? 1 : length) <= negligible * size) motion[p][i] = 0.0;
    });
  }
};

}  // namespace

std::vector<Refined> solve_refined(const BondNetwork& network, const Incidence& incidence,
                                   const FreeDofs& dofs, const std::vector<const Boundary*>& cases,
                                   LinearSolver& solver, double pivot_ratio, int threads) {
  const double length = network.rotation_length;
  std::vector<Iterate> iterates(cases.size());
  for (std::size_t c = 0; c < cases.size(); ++c)
    iterates[c].motion = converted<Extended>(cases[c]->prescribed);

  Eigen::MatrixXd right_hand_sides(dofs.unknowns(), Index(cases.size()));
  const auto all_done = [&] {
    return std::all_of(iterates.begin(), iterates.end(), [](const Iterate& i) { return i.done; });
  };
  while (dofs.unknowns() > 0 && !all_done()) {
    right_hand_sides.setZero();
    for (std::size_t c = 0; c < cases.size(); ++c)
      if (!iterates[c].done)
        right_hand_sides.col(Index(c)) =
            to_unknowns(residual(network, incidence, *cases[c], iterates[c].motion, threads), dofs, length);
    const Eigen::MatrixXd corrections = solver.solve(right_hand_sides);
    for (std::size_t c = 0; c < cases.size(); ++c)
      if (!iterates[c].done) iterates[c].add(corrections.col(Index(c)), dofs, length, pivot_ratio);
  }

  std::vector<BodyVectors<double>> answers;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    iterates[c].drop_negligible(dofs, length);
    answers.push_back(converted<double>(iterates[c].motion));
    right_hand_sides.col(Index(c)) =
        to_unknowns(rounding_forces(network, incidence, answers[c]), dofs, length);
  }
  if (dofs.unknowns() > 0) right_hand_sides = solver.solve(right_hand_sides);

  std::vector<Refined> refined(cases.size());
  for (std::size_t c = 0; c < cases.size(); ++c) {
    Accuracy& accuracy = refined[c].accuracy;
    accuracy.pivot_ratio = pivot_ratio;
    accuracy.refinements = std::max(0, iterates[c].steps - 1);
    accuracy.backward_error = backward_error(network, incidence, dofs, *cases[c], answers[c], threads);
    const double noise = right_hand_sides.col(Index(c)).lpNorm<Eigen::Infinity>();
    if (iterates[c].size > 0)
      accuracy.forward_error =
          double_rounding + negligible + (2 * iterates[c].correction + 4 * noise) / iterates[c].size;
    refined[c].motion = std::move(iterates[c].motion);
  }
  return refined;
}

}  // namespace bondstatic
