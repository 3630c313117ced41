#include "calibration/ceres/evaluations.hpp"

#include "bondstatic/error.hpp"

namespace bondstatic {

Evaluations::Evaluations(const LeastSquares& problem) : x(problem.start), problem_(problem) {
  ++count_;
  std::optional<Eigen::VectorXd> r = problem.residuals(x);
  if (!r || !r->allFinite())
    throw Error(ExitCode::invalid_input,
                "least squares have no answer at the start\n    cure: start where there is one");
  best = {x, std::move(*r), problem.jacobian()};
}

void Evaluations::PrepareForEvaluation(bool evaluate_jacobians, bool) {
  if (failure_) return;
  try {
    evaluate(evaluate_jacobians);
  } catch (...) {
    failure_ = std::current_exception();
  }
}

void Evaluations::evaluate(bool with_jacobian) {
  at_best_ = x == best.x;
  if (at_best_) return;
  if (!trial_ || trial_->x != x) {
    trial_.reset();
    if (used_up()) return;
    ++count_;
    std::optional<Eigen::VectorXd> r = problem_.residuals(x);
    if (r && r->allFinite()) trial_ = Point{x, std::move(*r), {}};
  }
  if (!with_jacobian || !trial_) return;
  trial_->jacobian = problem_.jacobian();
  best = std::move(*trial_);
  trial_.reset();
  at_best_ = true;
}

const Eigen::VectorXd* Evaluations::residuals() const {
  if (failure_) return nullptr;
  if (at_best_) return &best.residuals;
  return trial_ ? &trial_->residuals : nullptr;
}

}  // namespace bondstatic
