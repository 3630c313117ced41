// Outputs: the few numbers a user asks for. One notion for the terminal, sweep columns, targets and
// sensitivities.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bondstatic/model.hpp"
#include "bondstatic/state.hpp"
#include "bondstatic/statics.hpp"

namespace bondstatic {

struct Output {
  enum class Reduce { value, sum, mean, max };

  std::string name;
  std::string of;           ///< a particle or bond column ("uy", "sigma"), or a global (output_quantities())
  std::vector<Index> at;    ///< model positions of particles, or of bonds for a bond column
  std::vector<Index> base;  ///< apparent_young, apparent_poisson: the platen that stands still
  Vector3 axis = Vector3::UnitZ();  ///< of the two: from base to at
  /// apparent_poisson: particles whose sides are measured; empty: the middle third between the platens.
  std::vector<Index> middle;
  Reduce reduce = Reduce::value;  ///< value: exactly one particle or bond
  double scale = 1;
  std::string load_case;
  std::optional<double> expected;
  double tolerance = 1e-9;  ///< relative, on `expected`
  std::string source;       ///< where `expected` comes from
};

/// How an output changes with one parameter of the law of one [[bonds]] block.
struct ParameterSensitivity {
  Index block = 0;
  std::string parameter;
  double value = not_given;  ///< of the parameter; NaN where bonds of the block differ
  double derivative = 0;     ///< d(output)/d(parameter), changed by the same amount in all bonds of the block
  double elasticity =
      not_given;  ///< relative change of the output for one of the parameter; NaN for output 0
  std::vector<double> of_bond = {};  ///< d(output)/d(a bond's own value) of all bonds of the model, NaN in
                                     ///< other blocks; where asked for
};

struct OutputValue {
  std::string name;
  double value = 0;
  std::optional<double> expected;
  double tolerance = 1e-9;
  std::string source;
  std::vector<ParameterSensitivity> sensitivities = {};  ///< where asked for

  /// |value - expected| / |expected|, or |value| where zero is expected; NaN without expectation.
  double relative_error() const;
};

/// What `of` may name, for listings and error messages.
struct Quantity {
  enum class Where { particle, bond, model };
  std::string name;
  Where where;
  std::string meaning;
};
const std::vector<Quantity>& output_quantities();

/// One value an output, from the state of its load case; `states` are one a load case.
std::vector<OutputValue> evaluate_outputs(const Model& model, const std::vector<const State*>& states,
                                          const std::vector<Output>& outputs);
std::vector<OutputValue> evaluate_outputs(const Model& model, const StaticSolution& solution,
                                          const std::vector<Output>& outputs);

/// The value of one output in the state of its load case.
double evaluate_output(const Model& model, const State& state, const Output& output);

}  // namespace bondstatic
