// Steps on the way from an output to its value, and to its derivative.
#pragma once

#include <optional>
#include <vector>

#include "bondstatic/effective_stiffness.hpp"
#include "bondstatic/model.hpp"
#include "bondstatic/output.hpp"
#include "bondstatic/state.hpp"

namespace bondstatic {

/// What an output is made from.
enum class MadeOf {
  energy,
  work,
  stress,
  effective,
  particles,
  bonds,
  apparent_young,
  apparent_poisson,
};

/// Throws Error (invalid_input) where there is no such quantity.
MadeOf made_of(const Output& output);

/// Throws Error (invalid_input) that names the output.
[[noreturn]] void refuse(const Output& output, const std::string& reason, const std::string& cure);

/// Throws Error (invalid_input) where there is none of that name.
const State& load_case_of(const Output& output, const std::vector<const State*>& states);

/// A quantity of a whole static answer. Throws Error (invalid_input) where the answer has none.
double effective_value(const Output& output, const std::optional<EffectiveStiffness>& effective);

/// Mean stress of a periodic cell; likewise.
double stress_value(const Output& output, const State& state);

/// Of the particles, or bonds, at output.at, in its order.
std::vector<double> values_at(const Output& output, const Model& model, const State& state);

/// One value of those at output.at, in its order. What was left out has no value and does not count; NaN
/// where nothing is left. Throws Error (invalid_input) where the output asks for one value and has another
/// number.
double reduce(const Output& output, std::vector<double> values);

/// d(what reduce says)/d(each of the values): zero for what does not count; the largest is the first one.
std::vector<double> reduction_slope(const Output& output, const std::vector<double>& values);

/// `quantity` before it is scaled.
OutputValue told(const Output& output, double quantity);

}  // namespace bondstatic
