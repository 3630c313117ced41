#include "calibration/ceres/minimise.hpp"

#include <glog/logging.h>

#include <algorithm>
#include <limits>

#include "calibration/ceres/damping.hpp"
#include "calibration/ceres/evaluations.hpp"

namespace bondstatic {

namespace {

using Eigen::Index;

// A residual of its own, so that the loss sees it by itself; it depends on all x, each a block of its own, so
// that single ones can be held.
class Row : public ceres::CostFunction {
 public:
  Row(const Evaluations& at, Index row) : at_(at), row_(row) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->assign(std::size_t(at.x.size()), 1);
  }

  bool Evaluate(double const* const*, double* residual, double** jacobians) const override {
    const Eigen::VectorXd* residuals = at_.residuals();
    if (!residuals) return false;
    *residual = (*residuals)[row_];
    for (Index j = 0; jacobians && j < at_.x.size(); ++j)
      if (jacobians[j]) *jacobians[j] = at_.jacobian()(row_, j);
    return true;
  }

 private:
  const Evaluations& at_;
  Index row_;
};

ceres::LossFunction* loss_function(Loss loss) {
  if (loss == Loss::huber) return new ceres::HuberLoss(loss_width(loss));
  if (loss == Loss::cauchy) return new ceres::CauchyLoss(loss_width(loss));
  return nullptr;
}

Eigen::VectorXd gradient(const LeastSquares& problem, const Evaluations::Point& at) {
  return at.jacobian.transpose() * weights(problem.loss, at.residuals).cwiseProduct(at.residuals);
}

// At a bound, and the cost falls beyond it.
std::vector<bool> pulled_at_bounds(const LeastSquares& problem, const Evaluations::Point& at) {
  const Eigen::VectorXd g = gradient(problem, at);
  std::vector<bool> held(std::size_t(at.x.size()));
  for (Index j = 0; j < at.x.size(); ++j)
    held[std::size_t(j)] =
        (at.x[j] <= problem.lower[j] && g[j] > 0) || (at.x[j] >= problem.upper[j] && g[j] < 0);
  return held;
}

// Of pulls that are more than rounding.
std::vector<bool> truly_held(const LeastSquares& problem, const Evaluations::Point& at) {
  std::vector<bool> held = pulled_at_bounds(problem, at);
  const Eigen::VectorXd g = gradient(problem, at);
  for (std::size_t j = 0; j < held.size(); ++j) {
    const double column = at.jacobian.col(Index(j)).norm();
    held[j] = held[j] && std::abs(g[Index(j)]) > 1e-9 * column * std::max(1e-3, at.residuals.norm());
  }
  return held;
}

// x that neither a bound holds nor all residuals ignore.
std::vector<Index> moving_at(const Evaluations::Point& at, const std::vector<bool>& held) {
  std::vector<Index> moving;
  for (Index j = 0; j < at.x.size(); ++j)
    if (!held[std::size_t(j)] && (at.jacobian.col(j).array() != 0).any()) moving.push_back(j);
  return moving;
}

Damping damping_at(const LeastSquares& problem, const Evaluations::Point& at,
                   const std::vector<Index>& moving, double longest) {
  const Eigen::VectorXd root = weights(problem.loss, at.residuals).cwiseSqrt();
  return choose_damping(root.asDiagonal() * at.jacobian(Eigen::all, moving), root.cwiseProduct(at.residuals),
                        longest);
}

// Ceres by itself would halve and quarter a radius that is many decades too large to matter. After a step
// that was refused the next one shall be a quarter as long, and after a shortened one that was good, longer.
class Steps : public ceres::IterationCallback {
 public:
  Steps(const LeastSquares& problem, const Evaluations& at, const std::vector<bool>& held, bool shortened,
        double& longest)
      : problem_(problem), at_(at), held_(held), shortened_(shortened), longest_(longest) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
    using enum ceres::CallbackReturnType;
    if (at_.gave_up()) return SOLVER_ABORT;
    if (step.iteration == 0) return SOLVER_CONTINUE;
    if (!step.step_is_successful) {
      longest_ = std::min(longest_, step.step_norm) / 4;
      refused = true;
      return SOLVER_ABORT;
    }
    moved = true;
    if (shortened_) longest_ *= 2;
    if (shortened_ || pulled_at_bounds(problem_, at_.best) != held_) return SOLVER_ABORT;
    // Nothing is evaluated for a step that will be none.
    const Damping next = damping_at(problem_, at_.best, moving_at(at_.best, held_), longest_);
    return next.undamped_length < problem_.tolerance ? SOLVER_TERMINATE_SUCCESSFULLY : SOLVER_CONTINUE;
  }

  bool moved = false, refused = false;

 private:
  const LeastSquares& problem_;
  const Evaluations& at_;
  const std::vector<bool>& held_;
  const bool shortened_;
  double& longest_;
};

struct Leg {
  bool ended = false;  ///< by a step, or a gain, that is none any more
  bool moved = false, refused = false;
  Damping damping;
};

// Ceres from the best point on, until which x are held or how long steps may be has to be chosen anew.
Leg run_leg(const LeastSquares& problem, Evaluations& at, const std::vector<bool>& held, double& longest) {
  const std::vector<Index> moving = moving_at(at.best, held);
  if (moving.empty()) return {.ended = true, .damping = {}};
  Leg leg;
  leg.damping = damping_at(problem, at.best, moving, longest);
  if (leg.damping.undamped_length < problem.tolerance) {
    leg.ended = true;
    return leg;
  }

  at.x = at.best.x;
  ceres::Problem::Options ownership;
  ownership.evaluation_callback = &at;
  ceres::Problem ceres_problem(ownership);
  std::vector<double*> blocks;
  for (Index j = 0; j < at.x.size(); ++j) {
    blocks.push_back(&at.x[j]);
    ceres_problem.AddParameterBlock(blocks.back(), 1);
    ceres_problem.SetParameterLowerBound(blocks.back(), 0, problem.lower[j]);
    ceres_problem.SetParameterUpperBound(blocks.back(), 0, problem.upper[j]);
    if (std::find(moving.begin(), moving.end(), j) == moving.end())
      ceres_problem.SetParameterBlockConstant(blocks.back());
  }
  for (Index i = 0; i < at.best.residuals.size(); ++i)
    ceres_problem.AddResidualBlock(new Row(at, i), loss_function(problem.loss), blocks);

  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = problem.most_evaluations;
  options.initial_trust_region_radius = options.max_trust_region_radius = leg.damping.radius;
  // Damping is relative to the columns as they are.
  options.jacobi_scaling = false;
  options.min_lm_diagonal = std::numeric_limits<double>::min();
  options.max_lm_diagonal = std::numeric_limits<double>::max();
  options.max_num_line_search_step_size_iterations = 0;
  // x are scaled: a step counts by itself, not over the length of x.
  options.parameter_tolerance = problem.tolerance / std::max(1., at.x(moving).norm());
  options.function_tolerance = 1e-15;
  options.gradient_tolerance = 0;
  Steps steps(problem, at, held, leg.damping.shortens, longest);
  options.callbacks = {&steps};

  ceres::Solver::Summary summary;
  ceres::Solve(options, &ceres_problem, &summary);
  at.rethrow();
  leg.ended = summary.IsSolutionUsable() && summary.termination_type != ceres::NO_CONVERGENCE;
  leg.moved = steps.moved;
  leg.refused = steps.refused || summary.termination_type == ceres::FAILURE;
  return leg;
}

// Ceres tells failures of single steps to standard error, and they are none of the user's.
struct Quiet {
  int before = FLAGS_minloglevel;
  Quiet() { FLAGS_minloglevel = google::GLOG_FATAL; }
  ~Quiet() { FLAGS_minloglevel = before; }
};

Ending ending_of(const LeastSquares& problem, Evaluations& at) {
  double longest = 1;  // of a step: a factor e, or the whole range
  int idle_legs = 0;   // since the best point moved
  for (;;) {
    const std::vector<bool> held = pulled_at_bounds(problem, at.best);
    const Leg leg = run_leg(problem, at, held, longest);
    idle_legs = leg.moved ? 0 : idle_legs + 1;
    if (leg.ended && pulled_at_bounds(problem, at.best) == held) {
      // Steps that refusals made short say nothing of a minimum.
      const bool flat =
          !leg.damping.shortens || leg.damping.undamped_length < 1e-8 || leg.damping.gain < 1e-8;
      return flat ? Ending::minimum : Ending::stuck;
    }
    if (leg.refused && (leg.damping.undamped_length < 1e-8 || leg.damping.gain < 1e-12))
      return Ending::minimum;
    if (idle_legs > 60) return Ending::stuck;
    if (at.used_up()) return Ending::too_many_evaluations;
  }
}

}  // namespace

Minimum minimise_by_ceres(const LeastSquares& problem) {
  const Quiet quiet;
  Evaluations at(problem);
  const Ending ending = ending_of(problem, at);
  return {ending, at.best.x, at.best.residuals, at.best.jacobian, truly_held(problem, at.best)};
}

}  // namespace bondstatic
