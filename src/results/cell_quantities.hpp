// What a periodic cell answers: mean stress of a load case, and effective stiffness of the six.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bondstatic/effective_stiffness.hpp"
#include "bondstatic/state.hpp"

namespace bondstatic {

struct StressQuantity {
  std::string name;  ///< "stress_xx" ...
  std::string meaning;
  int row, column;
};
const std::vector<StressQuantity>& stress_quantities();
const StressQuantity* find_stress_quantity(const std::string& name);

struct EffectiveQuantity {
  std::string name;  ///< "effective_young", "effective_c11" ...
  std::string meaning;
  std::function<double(const EffectiveStiffness&)> of;
  /// d(quantity)/d(stiffness), component by component; nothing where there is none.
  std::function<std::optional<Matrix6>(const EffectiveStiffness&)> slope;
};
const std::vector<EffectiveQuantity>& effective_quantities();
const EffectiveQuantity* find_effective_quantity(const std::string& name);

}  // namespace bondstatic
