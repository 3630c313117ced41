#include "statics/iterate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bondstatic/error.hpp"
#include "statics/residual.hpp"
#include "system/together.hpp"
#include "system/unknowns.hpp"

namespace bondstatic {

namespace {

constexpr int most_refinements = 100;
constexpr double last_digit = 0x1p-57;      // of a displacement
constexpr double force_rounding = 0x1p-46;  // of the largest force, in a residual

}  // namespace

Iterate::Iterate(const BondNetwork& network, const Boundary& boundary, int threads, Ranks* ranks)
    : motion(converted<Extended>(boundary.prescribed, threads)) {
  if (boundary.strain.isZero(0)) return;
  for (const Link& link : network.links) {
    const Vector3 apart = boundary.strain * link.branch;
    least_size = std::max(least_size, apart.lpNorm<Eigen::Infinity>());
    least_residual = std::max(least_residual, std::max(link.stiffness.kn, link.stiffness.ks) * apart.norm());
  }
  least_size = largest_of_all(ranks, least_size);
  least_residual = largest_of_all(ranks, least_residual);
}

void Iterate::begin_from(const BodyVectors<Extended>& start, const FreeDofs& dofs, double came_by) {
  begun_from_motion = true;
  correction = came_by;
  for_each_unknown(dofs, [&](std::size_t p, int i, Index) { motion[p][i] = start[p][i]; });
}

Eigen::VectorXd Iterate::next_residual(const BondNetwork& network, const Boundary& boundary,
                                       const FreeDofs& dofs, bool iterative, int threads, Ranks* ranks) {
  const double length = network.rotation_length;
  const Index own = dofs.first[std::size_t(network.own())];
  if (iterative && steps == 0 && begun_from_motion) {
    // What is left of a good start says nothing of how large the forces are.
    const auto at_first =
        bondstatic::residual(network, boundary, converted<Extended>(boundary.prescribed, threads), threads);
    least_residual = std::max(
        least_residual,
        largest_of_all(ranks, to_unknowns(at_first, dofs, length).head(own).lpNorm<Eigen::Infinity>()));
  }
  Eigen::VectorXd r =
      to_unknowns(bondstatic::residual(network, boundary, motion, threads), dofs, length, threads);
  const double before = residual;
  residual = largest_of_all(ranks, r.head(own).lpNorm<Eigen::Infinity>());
  if (steps == 0) first_residual = std::max(residual, least_residual);
  force_contraction = before > 0 ? residual / before : 1;
  return r;
}

void Iterate::add(const Eigen::VectorXd& step, const FreeDofs& dofs, double length, int threads,
                  Ranks* ranks) {
  const double before = correction;
  earlier_contraction = contraction;
  correction = largest_of_all(ranks, step.lpNorm<Eigen::Infinity>());
  contraction = before > 0 ? correction / before : 1;
  for_each_unknown(dofs, threads, [&](std::size_t p, int i, Index unknown) {
    motion[p][i] += Extended(step[unknown]) / (i < 3 ? 1 : length);
  });
  size = 0;
  for_each_unknown(dofs, [&](std::size_t p, int i, Index) {
    size = std::max(size, std::abs(to_double(motion[p][i])) * (i < 3 ? 1 : length));
  });
  size = std::max(largest_of_all(ranks, size), least_size);
  setbacks = steps > 0 && (contraction > 0.5 || correction == 0) ? setbacks + 1 : 0;
  ++steps;
}

// Corrections that stop shrinking far above rounding belong to a factor that says nothing of K; near
// rounding they are the noise of the residual, and the answer is as good as it gets.
void Iterate::judge_direct(double pivot_ratio, double enough) {
  constexpr double doubt = 16;  // one round may contract less than the last
  expected = contraction * correction;
  const bool at_rounding = correction <= extended_rounding * size, stagnant = setbacks > 0;
  if (!std::isfinite(correction) || (stagnant && correction > 1e-20 * size) || steps > most_refinements)
    throw AccuracyError(
        fmt::format("the stiffness matrix is numerically singular: corrections stay at {:.1e} of the "
                    "answer (smallest pivot "
                    "ratio {:.1e})\n    cure: look for bodies that hang by bonds many decades softer than "
                    "the rest, or for a "
                    "support that is missing in all but rounding",
                    correction / size, pivot_ratio));
  done = at_rounding || stagnant || doubt * expected <= enough * size;
}

// A single round may fall back: a slow mode shows only after the fast ones are gone. So the next one is
// expected to contract as the worse of the last two did.
void Iterate::judge_iterative(const SolveReport& last) {
  constexpr int most_setbacks = 3;
  if (!std::isfinite(correction) || setbacks >= most_setbacks || steps > most_refinements)
    throw AccuracyError(fmt::format(
        "the iterative solver does not converge: corrections stay at {:.1e} of the answer after {} rounds, "
        "the last of {} iterations brought the residual to {:.1e} of what it was\n"
        "    cure: a direct solver (--solver cholmod) if the model is small enough for one; look for "
        "bodies "
        "that hang by bonds many decades softer than the rest, and for long slender parts",
        correction / size, steps, last.iterations, last.reduction));
  const double worse = std::max(contraction, earlier_contraction);
  expected = worse * correction;
  const bool settled = steps > 1 && worse < 0.5;
  done = residual == 0 || correction <= extended_rounding * size ||
         (settled && expected <= last_digit * size &&
          force_contraction * residual <= force_rounding * first_residual);
}

void Iterate::drop_negligible(const FreeDofs& dofs, double length, double noise) {
  const double threshold = std::max(noise, negligible * size);
  for_each_unknown(dofs, [&](std::size_t p, int i, Index) {
    if (std::abs(to_double(motion[p][i])) * (i < 3 ? 1 : length) <= threshold) motion[p][i] = 0.0;
  });
}

}  // namespace bondstatic
