// The parameters of a bond law or of a strength criterion, as blocks and rows of a file give them: one way to
// read, check and complete both.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/strength.hpp"

namespace bondstatic {

/// Refers to a law or criterion, which lasts.
struct ParameterList {
  ParameterList(const BondLaw& law);                  // implicit: a law stands for its parameters
  ParameterList(const StrengthCriterion& criterion);  // likewise

  std::string more;  ///< where more is said of it: "see `bondstatic laws timoshenko`"
  const std::vector<Parameter>* parameters;
  /// Fills in defaults; false after complaints, each as "young = -5: must be positive".
  std::function<bool(std::vector<double>& values, std::vector<std::string>& complaints)> complete;
  /// Parameters that a value for one rules out: other ways to say the same thing.
  std::function<std::vector<std::size_t>(std::size_t given)> ruled_out_by;

  /// Position of a parameter, or -1.
  Index find(const std::string& name) const;
  std::vector<std::string> names() const;
};

}  // namespace bondstatic
