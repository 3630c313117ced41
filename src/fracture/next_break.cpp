#include "fracture/next_break.hpp"

#include <algorithm>
#include <limits>

#include "bond/strength/resultants.hpp"
#include "system/natural_form.hpp"

namespace bondstatic {

namespace {

constexpr Index block = 1024;  // bonds that share a best so far: fixed, whatever the threads
constexpr double never = std::numeric_limits<double>::infinity();

}  // namespace

std::optional<NextBreak> next_break(const BondFailures& failures, const BondNetwork& network,
                                    std::span<const CarriedParts> carried, double from, double tie,
                                    int threads) {
  const Index bonds = Index(carried.size()), blocks = (bonds + block - 1) / block;
  const auto utilisation_at = [&](Index k, double factor) {
    const Link& link = network.links[std::size_t(k)];
    const CarriedParts& parts = carried[std::size_t(k)];
    return utilisation(failures.of(k), link.branch.norm(), link.fraction,
                       along(parts.held, parts.scaled, factor));
  };
  const auto in_blocks = [&](auto of_block) {
    std::vector<double> best(static_cast<std::size_t>(blocks));
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1 && bonds > worth_threads)
    for (Index i = 0; i < blocks; ++i)
      best[std::size_t(i)] = of_block(i * block, std::min(bonds, (i + 1) * block));
    return best;
  };

  const std::vector<double> worst = in_blocks([&](Index first, Index last) {
    double most = 0;
    for (Index k = first; k < last; ++k) most = std::max(most, utilisation_at(k, from).value);
    return most;
  });
  NextBreak next{from, {}, 0};
  double reached = *std::max_element(worst.begin(), worst.end());
  if (reached <= 1) {
    reached = 1;
    // Convex, and not above 1 at `from`: what is not above 1 at the best factor so far breaks later.
    const std::vector<double> first_of = in_blocks([&](Index first, Index last) {
      double best = never;
      for (Index k = first; k < last; ++k) {
        if (best < never && utilisation_at(k, best).value <= 1) continue;
        const Link& link = network.links[std::size_t(k)];
        const CarriedParts& parts = carried[std::size_t(k)];
        best = std::min(best, first_crossing(failures.of(k), link.branch.norm(), link.fraction, parts.held,
                                             parts.scaled, from)
                                  .factor);
      }
      return best;
    });
    next.factor = *std::min_element(first_of.begin(), first_of.end());
    if (next.factor == never) return std::nullopt;
  }
  for (Index k = 0; k < bonds; ++k) {
    const Utilisation u = utilisation_at(k, next.factor);
    if (u.value >= (1 - tie) * reached)
      next.bonds.push_back({k, u.mode, u.value});
    else
      next.runner_up = std::max(next.runner_up, u.value);
  }
  return next;
}

}  // namespace bondstatic
