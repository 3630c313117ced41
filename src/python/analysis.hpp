// What stands behind Python's Analysis, and behind Solution.sensitivity().
#pragma once

#include <memory>

#include "bondstatic/sensitivity.hpp"
#include "python/solve.hpp"

namespace bondstatic {

/// A StaticAnalysis with the model that it looks at, which is its own.
struct OwnedAnalysis {
  Model model;
  std::function<void(const std::string&)> progress;  ///< of the call that uses it now
  std::unique_ptr<StaticAnalysis> analysis;
  std::weak_ptr<const Solved> last;  ///< whose factor the analysis has
};

/// Solves again and again on one analysis of the pattern. Whoever uses the analysis takes it away meanwhile:
/// work that was given up keeps it, and the next solve makes a new one.
class PythonAnalysis {
 public:
  explicit PythonAnalysis(StaticOptions options) : options_(std::move(options)) {}

  std::shared_ptr<Solved> solve(std::shared_ptr<const Model> model, const py::object& progress);

  /// Of the outputs in the state that was solved for, by bond: exactly what StaticAnalysis::gradients() says.
  std::vector<BondGradients> gradients(const std::shared_ptr<const Solved>& solved,
                                       const std::vector<Output>& outputs);

 private:
  StaticOptions options_;
  std::shared_ptr<OwnedAnalysis> owned_;
};

}  // namespace bondstatic
