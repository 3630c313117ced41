#include "results/cell_quantities.hpp"

#include <fmt/format.h>

#include "model/cell.hpp"
#include "results/find_named.hpp"
#include "results/isotropic_slope.hpp"

namespace bondstatic {

const std::vector<StressQuantity>& stress_quantities() {
  static const std::vector<StressQuantity> table = [] {
    std::vector<StressQuantity> all;
    for (const UnitStrain& unit : unit_strains())
      all.push_back({fmt::format("stress_{}", unit.name),
                     "mean stress of the periodic cell, tension positive", unit.row, unit.column});
    return all;
  }();
  return table;
}

const std::vector<EffectiveQuantity>& effective_quantities() {
  using Effective = const EffectiveStiffness&;
  static const std::vector<EffectiveQuantity> table = [] {
    std::vector<EffectiveQuantity> all{
        {"effective_young", "Young's modulus of the isotropic stiffness nearest to the cell's",
         [](Effective e) { return e.isotropic.young; },
         [](Effective e) { return isotropic_young_slope(e.stiffness); }},
        {"effective_poisson", "Poisson's ratio of the same", [](Effective e) { return e.isotropic.poisson; },
         [](Effective e) { return isotropic_poisson_slope(e.stiffness); }},
        {"effective_misfit", "of the same, relative", [](Effective e) { return e.isotropic.misfit; },
         [](Effective e) { return isotropic_misfit_slope(e.stiffness); }}};
    for (const auto& [i, j] :
         {std::pair{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 6}, {1, 2}, {1, 3}, {2, 3}})
      all.push_back({fmt::format("effective_c{}{}", i, j), "component of the cell's stiffness, Voigt's order",
                     [i = i, j = j](Effective e) { return e.stiffness(i - 1, j - 1); },
                     [i = i, j = j](Effective) {
                       return Matrix6(Vector6::Unit(i - 1) * Vector6::Unit(j - 1).transpose());
                     }});
    return all;
  }();
  return table;
}

const StressQuantity* find_stress_quantity(const std::string& name) {
  return find_named(stress_quantities(), name);
}

const EffectiveQuantity* find_effective_quantity(const std::string& name) {
  return find_named(effective_quantities(), name);
}

}  // namespace bondstatic
