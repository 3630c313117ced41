#include "statics/refine.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

constexpr int most_refinements = 60;
constexpr double extended_rounding = 0x1p-64;  // of an x87 long double; a longer one is only better
constexpr double double_rounding = 0x1p-53;

// One value for each unknown from one vector for each body; rotations carry `scale`.
template <class Scalar>
Eigen::VectorXd gather_unknowns(const BodyVectors<Scalar>& values, const FreeDofs& dofs, double scale) {
  Eigen::VectorXd unknowns(dofs.unknowns());
  Index at = 0;
  for (std::size_t p = 0; p < values.size(); ++p)
    for (int i = 0; i < 6; ++i)
      if (dofs.is_free(Index(p), i))
        unknowns[at++] = double(i < 3 ? values[p][i] : values[p][i] * Scalar(scale));
  return unknowns;
}

BodyVectors<long double> residual(const BondNetwork& network, const Incidence& incidence,
                                  const Boundary& boundary, const BodyVectors<long double>& motion,
                                  int threads) {
  const auto q = link_resultants<long double>(network, motion, threads);
  auto r = gather_forces<long double>(network, incidence, q, threads);
  for (std::size_t p = 0; p < r.size(); ++p) r[p] = boundary.load[p].cast<long double>() - r[p];
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
BodyVectors<long double> rounding_forces(const BondNetwork& network, const Incidence& incidence,
                                         const BodyVectors<double>& motion) {
  BodyVectors<long double> q(network.links.size());
  for (std::size_t k = 0; k < q.size(); ++k) {
    const Link& link = network.links[k];
    const Vector6 m = motion_magnitude(link, motion[std::size_t(link.a)], motion[std::size_t(link.b)]);
    Vector6T<long double> e;
    for (int i = 0; i < 6; ++i) e[i] = 4 * extended_rounding * sign_of(6 * k + std::uint64_t(i)) * m[i];
    q[k] = resultants<long double>(link.stiffness, bond_axis<long double>(link), e);
  }
  return gather_forces<long double>(network, incidence, q, 1);
}

BodyVectors<double> rounded(const BodyVectors<long double>& motion) {
  BodyVectors<double> out(motion.size());
  for (std::size_t p = 0; p < motion.size(); ++p) out[p] = motion[p].cast<double>();
  return out;
}

// Oettli and Prager's componentwise measure, of the answer as it is written: rounded once to double.
double backward_error(const BondNetwork& network, const Incidence& incidence, const FreeDofs& dofs,
                      const Boundary& boundary, const BodyVectors<double>& motion, int threads) {
  BodyVectors<long double> extended(motion.size());
  for (std::size_t p = 0; p < motion.size(); ++p) extended[p] = motion[p].cast<long double>();
  const auto r = residual(network, incidence, boundary, extended, threads);
  const auto magnitude = force_magnitudes(network, incidence, motion, threads);
  double worst = 0;
  for (std::size_t p = 0; p < r.size(); ++p)
    for (int i = 0; i < 6; ++i) {
      const double scale = magnitude[p][i] + std::abs(boundary.load[p][i]);
      if (dofs.is_free(Index(p), i) && scale > 0) worst = std::max(worst, std::abs(double(r[p][i])) / scale);
    }
  return worst;
}

struct Progress {
  double correction = 0;  // largest entry of the last correction
  double size = 0;        // largest entry of the answer
  bool done = false;
};

[[noreturn]] void fail(double ratio, double pivot_ratio) {
  throw AccuracyError(
      fmt::format("the stiffness matrix is numerically singular: corrections shrink only by {:.2g} (smallest "
                  "pivot ratio {:.1e})\n"
                  "    cure: look for bodies that hang by bonds many decades softer than the rest, or for a "
                  "support that is "
                  "missing in all but rounding",
                  ratio, pivot_ratio));
}

}  // namespace

std::vector<Refined> solve_refined(const BondNetwork& network, const Incidence& incidence,
                                   const FreeDofs& dofs, const std::vector<const Boundary*>& cases,
                                   LinearSolver& solver, double pivot_ratio, int threads) {
  const Index unknowns = dofs.unknowns(), count = Index(cases.size());
  const double length = network.rotation_length;
  std::vector<Refined> refined(cases.size());
  std::vector<Progress> progress(cases.size());
  for (std::size_t c = 0; c < cases.size(); ++c) {
    refined[c].motion.resize(cases[c]->prescribed.size());
    for (std::size_t p = 0; p < cases[c]->prescribed.size(); ++p)
      refined[c].motion[p] = cases[c]->prescribed[p].cast<long double>();
  }

  Eigen::MatrixXd right_hand_sides(unknowns, count);
  for (int step = 0; unknowns > 0; ++step) {
    right_hand_sides.setZero();
    bool all_done = true;
    for (Index c = 0; c < count; ++c) {
      if (progress[std::size_t(c)].done) continue;
      all_done = false;
      const auto r =
          residual(network, incidence, *cases[std::size_t(c)], refined[std::size_t(c)].motion, threads);
      right_hand_sides.col(c) = gather_unknowns(r, dofs, 1 / length);
    }
    if (all_done) break;
    const Eigen::MatrixXd corrections = solver.solve(right_hand_sides);
    for (Index c = 0; c < count; ++c) {
      Progress& state = progress[std::size_t(c)];
      if (state.done) continue;
      const double correction = corrections.col(c).lpNorm<Eigen::Infinity>();
      if (!std::isfinite(correction)) fail(correction, pivot_ratio);
      auto& motion = refined[std::size_t(c)].motion;
      Index at = 0;
      state.size = 0;
      for (std::size_t p = 0; p < motion.size(); ++p)
        for (int i = 0; i < 6; ++i) {
          if (!dofs.is_free(Index(p), i)) continue;
          const double scale = i < 3 ? 1 : length;
          motion[p][i] += static_cast<long double>(corrections(at++, c)) / scale;
          state.size = std::max(state.size, std::abs(double(motion[p][i])) * scale);
        }
      const double ratio = step == 0 ? 0 : correction / state.correction;
      const bool at_rounding = correction <= extended_rounding * state.size;
      // Corrections that stop shrinking far above rounding belong to a factor that says nothing of K; near
      // rounding they are the noise of the residual, and the answer is as good as it gets.
      const bool stagnant = step > 0 && ratio > 0.5;
      if ((stagnant && correction > 1e-10 * state.size) || (step == most_refinements && !at_rounding))
        fail(ratio, pivot_ratio);
      state.correction = correction;
      state.done = at_rounding || stagnant;
      refined[std::size_t(c)].accuracy.refinements = step;
    }
  }

  std::vector<BodyVectors<double>> answers;
  for (Index c = 0; c < count; ++c) {
    answers.push_back(rounded(refined[std::size_t(c)].motion));
    right_hand_sides.col(c) =
        gather_unknowns(rounding_forces(network, incidence, answers.back()), dofs, 1 / length);
  }
  const Eigen::MatrixXd noise = unknowns > 0 ? solver.solve(right_hand_sides) : right_hand_sides;
  for (Index c = 0; c < count; ++c) {
    const Progress& state = progress[std::size_t(c)];
    Accuracy& accuracy = refined[std::size_t(c)].accuracy;
    accuracy.pivot_ratio = pivot_ratio;
    if (state.size > 0)
      accuracy.forward_error =
          double_rounding + (2 * state.correction + 4 * noise.col(c).lpNorm<Eigen::Infinity>()) / state.size;
    accuracy.backward_error =
        backward_error(network, incidence, dofs, *cases[std::size_t(c)], answers[std::size_t(c)], threads);
  }
  return refined;
}

}  // namespace bondstatic
