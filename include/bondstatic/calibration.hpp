// Calibration: law parameters that make outputs of one or several static tests what was measured, by least
// squares with exact derivatives, and what the tests can tell of them.
//
//     minimise  sum_i rho(((J_i(p) - wanted_i) / tolerance_i)^2)   over  lower <= p <= upper
//
// Intervals are those of the linearised problem at the solution: covariance (S^T S)^-1 with S_ij = dJ_i/dp_j
// / tolerance_i, in the logarithm of a parameter that is scaled so, else over its range upper - lower. Where
// tolerances are given they are the standard deviations of what was measured; where none is, the residuals
// tell their common size (Student's t). All targets have tolerances or none has. Under a robust loss a row of
// S counts by rho'.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "bondstatic/model.hpp"
#include "bondstatic/output.hpp"
#include "bondstatic/sensitivity.hpp"
#include "bondstatic/statics.hpp"

namespace bondstatic {

struct CalibrationParameter {
  std::string name;          ///< as in the case: "bonds.0.young", or "young" for all blocks that take it
  double start = not_given;  ///< NaN: what the first test's model has
  double lower = 0;
  double upper = 0;
  bool logarithmic = true;  ///< steps and intervals in ln p; needs lower > 0
};

struct CalibrationTarget {
  std::string output;  ///< name of an Output of the test
  std::string test;    ///< name of a CalibrationTest; "": in each that has the output, a datum each
  double wanted = 0;   ///< as the output is told, scale included
  double tolerance =
      not_given;  ///< standard deviation of what was measured, in the output's unit; NaN: not known
  double weight =
      1;  ///< of the residual where no target has a tolerance: over |wanted|, or 1 where that is 0
};

/// A model with outputs, and what the parameters are in it.
struct CalibrationTest {
  std::string name;  ///< of its case file, or with what makes it another one: "press.toml, bonds.0.seed=2"
  Model model;
  StaticOptions solve;
  std::vector<Output> outputs;
  std::vector<std::vector<BlockParameter>> parameters;  ///< [parameter]: all move together; may be none
};

/// Robust ones need tolerances: beyond 1.345 (huber) or 2.385 (cauchy) of them residuals count less.
enum class Loss { squares, huber, cauchy };

struct CalibrationOptions {
  Loss loss = Loss::squares;
  int most_evaluations = 50;
  double tolerance = 1e-12;  ///< relative, on the step: at rounding where targets can be met
  /// Called after each evaluation; may throw to give up.
  std::function<void(int evaluation, double cost)> progress;
};

/// One evaluation of all tests.
struct CalibrationStep {
  std::vector<double> parameters;
  double cost = 0;  ///< half the sum that is minimised; NaN where a solve failed
  double seconds = 0;
  bool accepted = true;
};

struct CalibratedParameter {
  std::string name;
  double value = 0;
  double lower_95 = not_given,
         upper_95 = not_given;  ///< NaN where the tests cannot tell, and at a bound; not cut at the bounds
  bool at_bound = false;        ///< the bound holds it, the targets pull on
};

struct AchievedTarget {
  std::string output, test;
  double wanted = 0, achieved = 0;
  double residual = 0;  ///< over the tolerance; without, over |wanted| (or 1), times the weight
};

/// A direction of parameters that the targets do not see: its singular value is below 1e-8 of the largest,
/// rows and columns of S scaled to length 1. A product of powers is named where start and solution show the
/// same.
struct Unidentified {
  std::vector<double> direction;  ///< unit, by parameter, in the scaled ones (ln p)
  std::string sentence;  ///< "young and radius_factor act only through young radius_factor^2 in these tests"
};

struct CalibrationResult {
  bool converged = false;  ///< a minimum was found
  bool reached = false;    ///< every target within its tolerance (without: within 1e-6 of |wanted|)
  std::string reason;      ///< why it ended, as a sentence
  std::vector<CalibratedParameter> parameters;
  std::vector<AchievedTarget> targets;
  Eigen::MatrixXd correlation;      ///< of the parameters; NaN where they have no interval
  Eigen::VectorXd singular_values;  ///< of S, descending; per ln p, or per range, over tolerances
  std::vector<Unidentified> unidentified;
  std::vector<CalibrationStep> history;
  int solves = 0;  ///< evaluations times tests that have targets
  std::vector<std::string> warnings;
};

/// Throws Error (invalid_input) where there are no targets or parameters, more parameters than targets,
/// bounds that exclude everything or leave a law's own, names that are not there, numbers that are not
/// finite, or this build has no Ceres; what StaticAnalysis throws at the start; and what `progress` throws.
/// Where a solve fails on the way (law, mechanism, accuracy), steps are shortened.
CalibrationResult calibrate(const std::vector<CalibrationTest>& tests,
                            const std::vector<CalibrationParameter>& parameters,
                            const std::vector<CalibrationTarget>& targets,
                            const CalibrationOptions& options = {});

/// What [calibration] of a case file asks for; other tests are case files to be read.
struct CalibrationPlan {
  std::vector<CalibrationParameter> parameters;
  std::vector<CalibrationTarget> targets;
  CalibrationOptions options;
  std::vector<std::string> cases;  ///< files beside the case itself
  std::string seed_key;            ///< "" or a key of the case that takes each of the seeds, a test each
  std::vector<Index> seeds;
};

}  // namespace bondstatic
