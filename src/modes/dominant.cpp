#include "modes/lanczos.hpp"

namespace bondstatic {

namespace {

constexpr Index subspace = 20;
constexpr double rough = 1e-2;
constexpr Index restarts_for_rough = 10;

// Filtered: the spectrum below this share of the first estimate is damped.
constexpr double damped_up_to = 0.95;
constexpr int degree = 12;
constexpr Index restarts_for_sharp = 60;

// y = T_d(2 A / edge - 1) x with the Chebyshev polynomial T_d: between -1 and 1 for eigenvalues up to the
// edge, growing steeply beyond. Eigenvalues crowd at the upper end where bodies repeat; here they part (Saad,
// Numerical Methods for Large Eigenvalue Problems, 2nd ed. 2011, chapter 7).
class ChebyshevFilter {
 public:
  ChebyshevFilter(Index n, const Operator& apply, double edge)
      : apply_(apply), edge_(edge), before_(n), now_(n), next_(n) {}

  void operator()(const double* x, double* y) {
    const Eigen::Map<const Eigen::VectorXd> in(x, now_.size());
    before_ = in;
    apply_(x, now_.data());
    now_ = 2 / edge_ * now_ - in;
    for (int i = 1; i < degree; ++i) {
      apply_(now_.data(), next_.data());
      next_ = 4 / edge_ * next_ - 2 * now_ - before_;
      before_.swap(now_);
      now_.swap(next_);
    }
    Eigen::Map<Eigen::VectorXd>(y, now_.size()) = now_;
  }

 private:
  const Operator& apply_;
  double edge_;
  Eigen::VectorXd before_, now_, next_;
};

Eigen::VectorXd leading_vector(Index n, const Operator& apply, double scale, Index restarts,
                               double tolerance) {
  ScaledOperator scaled{n, apply, 1 / scale};
  Lanczos lanczos(scaled, 1, subspace);
  lanczos.run(restarts, tolerance);
  return lanczos.leading().normalized();
}

DominantPair rayleigh_pair(const Operator& apply, Eigen::VectorXd vector) {
  Eigen::VectorXd product(vector.size());
  apply(vector.data(), product.data());
  DominantPair pair;
  pair.value = vector.dot(product);
  pair.residual = (product - pair.value * vector).norm();
  pair.vector = std::move(vector);
  return pair;
}

}  // namespace

DominantPair dominant_eigenpair(Index n, const Operator& apply, double tolerance) {
  const SerialProducts serial;
  const double scale = typical_value(n, apply);
  if (n <= dense_up_to) return rayleigh_pair(apply, dense_eigenpairs(n, apply, 1).vectors.col(0));
  if (!(scale > 0)) return {0, 0, start_vector(n).normalized()};
  const DominantPair first =
      rayleigh_pair(apply, leading_vector(n, apply, scale, restarts_for_rough, std::max(rough, tolerance)));
  if (first.residual <= tolerance * first.value) return first;
  ChebyshevFilter filter(n, apply, damped_up_to * first.value);
  const Operator filtered = [&filter](const double* x, double* y) { filter(x, y); };
  const double filtered_scale = typical_value(n, filtered);
  return rayleigh_pair(apply, leading_vector(n, filtered, filtered_scale, restarts_for_sharp, tolerance));
}

}  // namespace bondstatic
