#include "bondstatic/statics.hpp"
#include "statics/partners.hpp"
#include "statics/static_run.hpp"

namespace bondstatic {

StaticSolution solve_statics(const Model& model, const StaticOptions& options) {
  return StaticRun(model, nullptr, options).solve(false);
}

StaticSolution solve_statics(const Partners& partners, const StaticOptions& options) {
  return StaticRun(partners.piece.model, &partners, options).solve(false);
}

}  // namespace bondstatic
