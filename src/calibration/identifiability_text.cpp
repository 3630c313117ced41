#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "calibration/identifiability.hpp"
#include "calibration/wording.hpp"

namespace bondstatic {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct Ratio {
  int above = 0, below = 1;
};

// Exponents of mechanics: r^4, E^(3/2).
std::optional<Ratio> small_ratio(double value) {
  for (int below = 1; below <= 4; ++below) {
    const double above = std::round(value * below);
    if (std::abs(value * below - above) < 1e-6 && std::abs(above) <= 12) return Ratio{int(above), below};
  }
  return {};
}

std::string power(const std::string& name, int exponent) {
  return exponent == 1 ? name : fmt::format("{}^{}", name, exponent);
}

struct Power {
  Index of;
  int exponent;
};

// As a user writes it: "young radius_factor^2", "young / kappa".
std::string product(Power a, Power b, const std::vector<std::string>& names) {
  if (a.of > b.of) std::swap(a, b);
  if (a.exponent < 0) a.exponent = -a.exponent, b.exponent = -b.exponent;
  return fmt::format("{} {}{}", power(names[std::size_t(a.of)], a.exponent), b.exponent < 0 ? "/ " : "",
                     power(names[std::size_t(b.of)], std::abs(b.exponent)));
}

// Whether targets see nothing of it, either.
bool unseen_at(const LookedAt& at, const VectorXd& change) {
  const VectorXd length = at.jacobian.colwise().norm();
  return (at.jacobian * change).norm() <= 1e-6 * length.dot(change.cwiseAbs());
}

// The products that stay along a direction of logarithms; none where exponents are no small fractions, or
// other ones at the start.
std::vector<std::string> invariants(const VectorXd& logarithms, const std::vector<Index>& touched,
                                    const std::vector<std::string>& names, const LookedAt& start) {
  const auto smaller = [&](Index i, Index j) { return std::abs(logarithms[i]) < std::abs(logarithms[j]); };
  // The first of those that are as large to rounding: 1 in a b, c in a c^2.
  Index least = *std::min_element(touched.begin(), touched.end(), smaller);
  for (auto j = touched.rbegin(); j != touched.rend(); ++j)
    if (std::abs(logarithms[*j]) < std::abs(logarithms[least]) * (1 + 1e-6)) {
      least = *j;
      break;
    }
  std::vector<std::string> products;
  VectorXd exact = VectorXd::Zero(logarithms.size());
  exact[least] = 1;
  for (const Index j : touched) {
    if (j == least) continue;
    const std::optional<Ratio> ratio = small_ratio(-logarithms[j] / logarithms[least]);
    if (!ratio) return {};
    exact[j] = -double(ratio->above) / ratio->below;
    products.push_back(product({j, ratio->below}, {least, ratio->above}, names));
  }
  return unseen_at(start, exact.cwiseQuotient(start.logarithmic)) ? products : std::vector<std::string>{};
}

std::string change(double percent, const std::string& name) {
  return fmt::format("{:.3g} % {} {}", std::abs(percent), percent < 0 ? "less" : "more", name);
}

}  // namespace

std::string sentence(const UnseenDirection& unseen, const std::vector<std::string>& names,
                     const LookedAt& start, const LookedAt& solution) {
  std::vector<Index> touched;
  std::vector<std::string> who;
  for (Index j = 0; j < unseen.direction.size(); ++j)
    if (unseen.direction[j] != 0) {
      touched.push_back(j);
      who.push_back(names[std::size_t(j)]);
    }
  if (unseen.no_influence) return fmt::format("{} has no influence on any target", who.front());

  const VectorXd logarithms = unseen.direction.cwiseProduct(solution.logarithmic);
  if (logarithms(touched).allFinite()) {
    const std::vector<std::string> products = invariants(logarithms, touched, names, start);
    if (!products.empty())
      return fmt::format("{} act only through {} in these tests", listed(who), listed(products));
    if (touched.size() == 2) {
      const double per_percent = logarithms[touched[1]] / logarithms[touched[0]];
      return fmt::format(
          "{} cannot be told apart by these tests: at the solution, {} together with {} "
          "changes no target",
          listed(who), change(1, who[0]), change(per_percent, who[1]));
    }
  }
  return fmt::format("{} cannot be told apart by these tests", listed(who));
}

}  // namespace bondstatic
