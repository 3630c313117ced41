#include "statics/acceptance.hpp"

#include <fmt/format.h>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

std::string unknown_name(const Model& model, const FreeDofs& dofs, Index unknown) {
  std::size_t p = 0;
  while (dofs.first[p + 1] <= unknown) ++p;
  return fmt::format("particle {}", model.particles[p].id);
}

}  // namespace

void check_pivots(const Model& model, const FreeDofs& dofs, const FactorReport& factor) {
  // A pivot below the rounding of its own diagonal entry is rounding itself.
  if (factor.pivot_ratio > 0x1p-53) return;
  const std::string where = factor.broken_at >= 0 ? " at " + unknown_name(model, dofs, factor.broken_at) : "";
  throw AccuracyError(fmt::format(
      "the stiffness matrix is numerically singular: the factorisation broke down{} (pivot ratio {:.1e})\n"
      "    cure: look for stiffness that differs by more than 15 decades between bonds, or for slender parts "
      "that are almost a mechanism",
      where, factor.pivot_ratio));
}

void check_backward_error(double found, double asked) {
  if (found <= asked) return;
  throw AccuracyError(
      fmt::format("the backward error {:.2e} is above the asked {:.2e}\n    cure: ask for less ([solve] "
                  "tolerance), or look for a part that is almost a mechanism",
                  found, asked));
}

}  // namespace bondstatic
