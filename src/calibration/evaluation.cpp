#include "calibration/evaluation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/error.hpp"
#include "results/linearise.hpp"
#include "solver/cost_model.hpp"

namespace bondstatic {

using Eigen::Index;

struct Evaluation::Running {
  Running(const CalibrationTest& test) : given(test), model(test.model) {}

  const CalibrationTest& given;
  Model model;  // with the parameters of the last evaluation
  std::optional<StaticAnalysis> analysis;
  StaticSolution solution;
  std::vector<Index> rows;
  std::vector<Output> outputs;  // of those rows
};

namespace {

// A law may forbid values together that each of its bounds allows.
void check_together(const Model& model) {
  std::vector<Fault> faults;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    std::vector<std::string> complaints;
    complete_parameters(*find_bond_law(model.blocks[b].law), model.blocks[b].parameters, complaints);
    for (const std::string& complaint : complaints)
      faults.push_back(
          {{}, fmt::format("bonds.{}: {}", b, complaint), "narrow the bounds of the calibration"});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace

Evaluation::Evaluation(const std::vector<CalibrationTest>& tests, const std::vector<TargetRow>& rows)
    : rows_(rows) {
  std::vector<Running*> running(tests.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t k = rows[i].test;
    if (!running[k]) running[k] = tests_.emplace_back(std::make_unique<Running>(tests[k])).get();
    Running& test = *running[k];
    test.rows.push_back(Index(i));
    test.outputs.push_back(test.given.outputs[rows[i].output]);
  }
}

Evaluation::~Evaluation() = default;

void Evaluation::warn(const std::string& warning) {
  if (std::find(warnings_.begin(), warnings_.end(), warning) == warnings_.end()) warnings_.push_back(warning);
}

StaticSolution Evaluation::first_solve(Running& test) try {
  StaticOptions options = test.given.solve;
  if (options.memory_limit > 0) options.memory_limit = std::max(1., options.memory_limit - kept_bytes_);
  test.analysis.emplace(test.model, options);
  StaticSolution solution = test.analysis->solve();
  kept_bytes_ += solution.report.analysis.predicted_bytes;
  return solution;
} catch (const MemoryError& error) {
  if (kept_bytes_ == 0) throw;
  throw MemoryError(fmt::format("{}, with {} for the tests before it in memory: {}", test.given.name,
                                size_text(kept_bytes_), error.what()));
}

void Evaluation::solve(Running& test, const std::vector<double>& values, Eigen::VectorXd& outputs) {
  for (std::size_t p = 0; p < test.given.parameters.size(); ++p)
    for (const BlockParameter& moved : test.given.parameters[p])
      test.model.blocks[std::size_t(moved.block)].parameters[moved.parameter] = values[p];
  check_together(test.model);
  ++solves_;
  test.solution = test.analysis ? test.analysis->solve() : first_solve(test);
  for (const std::string& warning : test.solution.report.warnings)
    warn(tests_.size() > 1 ? fmt::format("{}: {}", test.given.name, warning) : warning);
  const std::vector<OutputValue> found = evaluate_outputs(test.model, test.solution, test.outputs);
  for (std::size_t i = 0; i < found.size(); ++i) outputs[test.rows[i]] = found[i].value;
}

Eigen::VectorXd Evaluation::outputs(const std::vector<double>& values) {
  Eigen::VectorXd found(Index(rows_.size()));
  for (const auto& test : tests_) solve(*test, values, found);
  return found;
}

Eigen::MatrixXd Evaluation::derivatives() {
  const std::size_t parameters = tests_.front()->given.parameters.size();
  Eigen::MatrixXd found = Eigen::MatrixXd::Zero(Index(rows_.size()), Index(parameters));
  for (const auto& test : tests_) {
    std::vector<Functionals> scalars;
    for (const Output& output : test->outputs)
      scalars.push_back(linearise(output, test->model, test->solution, test->analysis->properties()));
    const std::vector<BondGradients> gradients = test->analysis->gradients(scalars);
    for (std::size_t p = 0; p < parameters; ++p)
      for (const BlockParameter& moved : test->given.parameters[p]) {
        const ParameterDerivative bonds =
            bond_derivatives(test->model, moved.block, moved.parameter, test->solution.report.threads);
        for (std::size_t i = 0; i < gradients.size(); ++i)
          found(test->rows[i], Index(p)) += derivative(gradients[i], bonds);
      }
  }
  return found;
}

}  // namespace bondstatic
