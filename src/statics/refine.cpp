#include "statics/refine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

constexpr int most_refinements = 100;
constexpr double double_rounding = 0x1p-53;

double double_of(double value) {
  return value;
}
double double_of(const Extended& value) {
  return to_double(value);
}

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

template <class Scalar>
BodyVectors<Scalar> residual(const BondNetwork& network, const Incidence& incidence, const Boundary& boundary,
                             const BodyVectors<Scalar>& motion, int threads) {
  BodyVectors<Scalar> r = converted<Scalar>(boundary.load);
  // Nearly always so at the start.
  const auto at_rest = [](const Vector6T<Scalar>& u) { return u.isZero(Scalar(0.0)); };
  if (std::all_of(motion.begin(), motion.end(), at_rest)) return r;
  const auto q = link_resultants<Scalar>(network, motion, threads);
  const auto carried = gather_forces<Scalar>(network, incidence, q, threads);
  for (std::size_t p = 0; p < r.size(); ++p) r[p] -= carried[p];
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

// Oettli and Prager's componentwise measure, of the answer as it is written: rounded once to double. Where
// all terms of a row vanish by symmetry but for noise, the row is held against what it could carry (M.
// Arioli, J. W. Demmel, I. S. Duff, SIAM J. Matrix Anal. Appl. 10, 1989).
template <class Scalar>
double backward_error(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                      const Boundary& boundary, const BodyVectors<double>& motion, double size, int threads) {
  const auto r = residual<Scalar>(network, incidence, boundary, converted<Scalar>(motion), threads);
  const auto magnitude = force_magnitudes(network, incidence, motion, threads);
  constexpr double doubtful = 0x1p-50, noise = 1000 * double_rounding;
  Vector6 everywhere = Vector6::Constant(size);
  everywhere.tail<3>() /= network.rotation_length;
  BodyVectors<double> largest;  // seldom needed
  double worst = 0;
  for_each_unknown(dofs, [&](std::size_t p, int i, Index) {
    double scale = magnitude[p][i] + std::abs(boundary.load[p][i]);
    if (!(scale > 0)) return;
    const double left = std::abs(double_of(r[p][i]));
    if (left > doubtful * scale) {
      if (largest.empty()) largest.assign(motion.size(), everywhere);
      const double possible = force_magnitude(network, incidence, largest, Index(p))[i];
      if (scale <= noise * possible) scale += possible;
    }
    worst = std::max(worst, left / scale);
  });
  return worst;
}

constexpr double last_digit = 0x1p-57;      // of a displacement
constexpr double force_rounding = 0x1p-46;  // of the largest force, in a residual

// One load case on its way to the last digit.
struct Iterate {
  BodyVectors<Extended> motion;
  double first_residual = 0, residual = 0;  // largest entry, of the start and of the latest round
  double force_contraction = 1;             // of the residual, by the latest round
  double correction = 0;                    // largest entry of the last one, rotations times the length
  double contraction = 1;                   // of corrections, by the latest round
  double size = 0;                          // largest entry of the answer, likewise
  int steps = 0;
  int setbacks = 0;  // rounds in a row that did not contract
  bool done = false;

  Eigen::VectorXd round(const BondNetwork& network, const Incidence& incidence, const Boundary& boundary,
                        const FreeDofs& dofs, bool iterative, int threads) {
    // The first correction of an iterative solver is good to six digits: what it leaves is known well enough
    // in double, in a tenth of the time.
    const double length = network.rotation_length;
    Eigen::VectorXd r =
        iterative && steps == 1
            ? to_unknowns(bondstatic::residual<double>(network, incidence, boundary,
                                                       converted<double>(motion), threads),
                          dofs, length)
            : to_unknowns(bondstatic::residual<Extended>(network, incidence, boundary, motion, threads), dofs,
                          length);
    const double before = residual;
    residual = r.lpNorm<Eigen::Infinity>();
    if (steps == 0) first_residual = residual;
    force_contraction = before > 0 ? residual / before : 1;
    return r;
  }

  void add(const Eigen::VectorXd& step, const FreeDofs& dofs, double length) {
    const double before = correction;
    correction = step.lpNorm<Eigen::Infinity>();
    contraction = steps > 0 && before > 0 ? correction / before : 1;
    size = 0;
    for_each_unknown(dofs, [&](std::size_t p, int i, Index unknown) {
      const double scale = i < 3 ? 1 : length;
      motion[p][i] += Extended(step[unknown]) / scale;
      size = std::max(size, std::abs(to_double(motion[p][i])) * scale);
    });
    setbacks = steps > 0 && (contraction > 0.5 || correction == 0) ? setbacks + 1 : 0;
    ++steps;
  }

  // Corrections that stop shrinking far above rounding belong to a factor that says nothing of K; near
  // rounding they are the noise of the residual, and the answer is as good as it gets.
  void judge_direct(double pivot_ratio) {
    const bool at_rounding = correction <= extended_rounding * size, stagnant = setbacks > 0;
    if (!std::isfinite(correction) || (stagnant && correction > 1e-20 * size) || steps > most_refinements)
      throw AccuracyError(
          fmt::format("the stiffness matrix is numerically singular: corrections stay at {:.1e} of the "
                      "answer (smallest pivot "
                      "ratio {:.1e})\n    cure: look for bodies that hang by bonds many decades softer than "
                      "the rest, or for a "
                      "support that is missing in all but rounding",
                      correction / size, pivot_ratio));
    done = at_rounding || stagnant;
  }

  // A single round may fall back: a slow mode shows only after the fast ones are gone.
  void judge_iterative(const SolveReport& last) {
    constexpr int most_setbacks = 3;
    if (!std::isfinite(correction) || setbacks >= most_setbacks || steps > most_refinements)
      throw AccuracyError(fmt::format(
          "the iterative solver does not converge: corrections stay at {:.1e} of the answer after {} rounds, "
          "the last of {} iterations brought the residual to {:.1e} of what it was\n"
          "    cure: a direct solver (--solver cholmod) if the model is small enough for one; look for "
          "bodies "
          "that hang by bonds many decades softer than the rest, and for long slender parts",
          correction / size, steps, last.iterations, last.reduction));
    // The second round is left out of account: its residual was formed in double.
    const bool settled = steps > 2 && contraction < 0.5;
    done = residual == 0 || (settled && contraction * correction <= last_digit * size &&
                             force_contraction * residual <= force_rounding * first_residual);
  }

  double expected_error() const { return contraction * correction; }

  void drop_negligible(const FreeDofs& dofs, double length, double noise) {
    const double threshold = std::max(noise, negligible * size);
    for_each_unknown(dofs, [&](std::size_t p, int i, Index) {
      if (std::abs(to_double(motion[p][i])) * (i < 3 ? 1 : length) <= threshold) motion[p][i] = 0.0;
    });
  }
};

}  // namespace

std::vector<Refined> solve_refined(const BondNetwork& network, const Incidence& incidence,
                                   const FreeDofs& dofs, const std::vector<const Boundary*>& cases,
                                   LinearSolver* solver, double pivot_ratio, int threads, Effort& effort,
                                   const std::function<void(const std::string&)>& progress) {
  const double length = network.rotation_length;
  const bool iterative = solver && solver->iterative();
  std::vector<Iterate> iterates(cases.size());
  for (std::size_t c = 0; c < cases.size(); ++c)
    iterates[c].motion = converted<Extended>(cases[c]->prescribed);

  Eigen::MatrixXd right_hand_sides(dofs.unknowns(), Index(cases.size()));
  const auto all_done = [&] {
    return std::all_of(iterates.begin(), iterates.end(), [](const Iterate& i) { return i.done; });
  };
  for (int round = 1; dofs.unknowns() > 0 && !all_done(); ++round) {
    right_hand_sides.setZero();
    for (std::size_t c = 0; c < cases.size(); ++c)
      if (!iterates[c].done)
        right_hand_sides.col(Index(c)) =
            iterates[c].round(network, incidence, *cases[c], dofs, iterative, threads);
    const Eigen::MatrixXd corrections = solver->solve(right_hand_sides);
    for (std::size_t c = 0; c < cases.size(); ++c) {
      if (iterates[c].done) continue;
      iterates[c].add(corrections.col(Index(c)), dofs, length);
      if (iterative)
        iterates[c].judge_iterative(solver->last_solve());
      else
        iterates[c].judge_direct(pivot_ratio);
    }
    if (!iterative) continue;
    const SolveReport last = solver->last_solve();
    effort.iterations += last.iterations;
    if (!last.note.empty()) effort.notes.push_back(last.note);
    if (progress)
      progress(
          fmt::format("round {}: {} iterations, correction {:.0e}", round, effort.iterations,
                      iterates.front().size > 0 ? iterates.front().correction / iterates.front().size : 0));
  }

  std::vector<BodyVectors<double>> answers;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    iterates[c].drop_negligible(dofs, length, iterative ? iterates[c].expected_error() : 0);
    answers.push_back(converted<double>(iterates[c].motion));
    if (!iterative)
      right_hand_sides.col(Index(c)) =
          to_unknowns(rounding_forces(network, incidence, answers[c]), dofs, length);
  }
  // What an iterative solver leaves is far above the rounding of the natural form: one solve is saved.
  if (dofs.unknowns() > 0 && !iterative) right_hand_sides = solver->solve(right_hand_sides);

  std::vector<Refined> refined(cases.size());
  for (std::size_t c = 0; c < cases.size(); ++c) {
    Accuracy& accuracy = refined[c].accuracy;
    accuracy.pivot_ratio = pivot_ratio;
    accuracy.refinements = std::max(0, iterates[c].steps - 1);
    const auto measure = iterative ? backward_error<double> : backward_error<Extended>;
    accuracy.backward_error =
        measure(network, incidence, dofs, *cases[c], answers[c], iterates[c].size, threads);
    const double left =
        iterative ? 2 * iterates[c].expected_error()
                  : 2 * iterates[c].correction + 4 * right_hand_sides.col(Index(c)).lpNorm<Eigen::Infinity>();
    if (iterates[c].size > 0) accuracy.forward_error = double_rounding + negligible + left / iterates[c].size;
    refined[c].motion = std::move(iterates[c].motion);
  }
  return refined;
}

}  // namespace bondstatic
