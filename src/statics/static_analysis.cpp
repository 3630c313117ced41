#include "bondstatic/sensitivity.hpp"
#include "statics/static_run.hpp"

namespace bondstatic {

struct StaticAnalysis::Parts : StaticRun {
  using StaticRun::StaticRun;
};

StaticAnalysis::StaticAnalysis(const Model& model, StaticOptions options)
    : parts_(std::make_unique<Parts>(model, nullptr, std::move(options))) {}
StaticAnalysis::~StaticAnalysis() = default;
StaticAnalysis::StaticAnalysis(StaticAnalysis&&) noexcept = default;
StaticAnalysis& StaticAnalysis::operator=(StaticAnalysis&&) noexcept = default;

StaticSolution StaticAnalysis::solve() {
  return parts_->solve(true);
}

std::vector<BondGradients> StaticAnalysis::gradients(const std::vector<Functionals>& scalars) {
  return parts_->gradients(scalars);
}

const std::vector<BondProperties>& StaticAnalysis::properties() const {
  return parts_->properties();
}

}  // namespace bondstatic
