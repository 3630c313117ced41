// The targets' outputs, and their derivatives, as functions of the parameters: every test solved on an
// analysis that is kept.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "calibration/rows.hpp"

namespace bondstatic {

class Evaluation {
 public:
  Evaluation(const std::vector<CalibrationTest>& tests, const std::vector<TargetRow>& rows);
  ~Evaluation();

  /// Of each row, at these values of the parameters. Throws what a solve throws, and InputError where a law
  /// cannot have these values together.
  Eigen::VectorXd outputs(const std::vector<double>& values);

  /// d(output of row i)/d(value of parameter j), where outputs() was asked last.
  Eigen::MatrixXd derivatives();

  /// Of all solves so far, each once, with the test where there are several.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// So far; a test without targets needs none.
  int solves() const { return solves_; }

 private:
  struct Running;  // one test

  /// Every test keeps its factor. A memory limit holds for all of them together; without one, what the
  /// machine has left is looked at when those before are there.
  StaticSolution first_solve(Running& test);
  void solve(Running& test, const std::vector<double>& values, Eigen::VectorXd& outputs);
  void warn(const std::string& warning);

  std::vector<std::unique_ptr<Running>> tests_;
  std::vector<TargetRow> rows_;
  std::vector<std::string> warnings_;
  int solves_ = 0;
  double kept_bytes_ = 0;  // by tests that were solved, predicted
};

}  // namespace bondstatic
