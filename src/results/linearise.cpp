#include "results/linearise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "results/apparent_poisson.hpp"
#include "results/apparent_young.hpp"
#include "results/cell_quantities.hpp"
#include "results/effective_slope.hpp"
#include "results/output_values.hpp"
#include "results/quantities.hpp"

namespace bondstatic {

namespace {

Functional of_particles(const Output& output, const Model& model, const State& state) {
  const ParticleQuantity& quantity = *find_particle_quantity(output.of);
  const std::vector<double> slope = reduction_slope(output, values_at(output, model, state));
  Functional functional;
  for (std::size_t i = 0; i < slope.size(); ++i) {
    if (slope[i] == 0) continue;
    const Index p = output.at[i];
    const auto own = slope_at(quantity, model, state, p);
    if (!own.displacement.isZero(0)) functional.displacement.emplace_back(p, slope[i] * own.displacement);
    if (!own.reaction.isZero(0)) functional.reaction.emplace_back(p, slope[i] * own.reaction);
  }
  return functional;
}

Functional of_bonds(const Output& output, const Model& model, const State& state,
                    const std::vector<BondProperties>& properties) {
  const BondQuantity& quantity = *find_bond_quantity(output.of);
  const std::vector<double> slope = reduction_slope(output, values_at(output, model, state));
  Functional functional;
  for (std::size_t i = 0; i < slope.size(); ++i) {
    if (slope[i] == 0) continue;
    const Index k = output.at[i];
    auto own = slope_at(quantity, model, state, properties, k);
    if (!own)
      refuse(output,
             fmt::format("{} has no derivative at bond {}: a magnitude that it is made of (shear force, "
                         "bending or twisting moment) is zero but for rounding there",
                         output.of, model.bonds[std::size_t(k)].id),
             "ask for components (fx ... mz), normal_force or twisting_moment, or leave the bond out");
    own->force *= slope[i], own->energy *= slope[i], own->radius *= slope[i];
    functional.bonds.push_back(*own);
  }
  return functional;
}

Functional of_stress(const Output& output, const State& state) {
  stress_value(output, state);
  const StressQuantity& quantity = *find_stress_quantity(output.of);
  Functional functional;
  functional.stress(quantity.row, quantity.column) = 1;
  return functional;
}

/// At rest the work is twice the energy.
Functional of_energy(double times) {
  Functional functional;
  functional.energy = times;
  return functional;
}

Functionals of_stiffness(const Output& output, const StaticSolution& solution) {
  effective_value(output, solution.effective);
  const auto slope = find_effective_quantity(output.of)->slope(*solution.effective);
  if (!slope)
    refuse(output,
           fmt::format("{} has no derivative where the stiffness is isotropic: it is zero there", output.of),
           "ask for effective_young, effective_poisson or a component such as effective_c11");
  return effective_slope(*slope, solution);
}

Functional of_state(const Output& output, const Model& model, const State& state,
                    const std::vector<BondProperties>& properties) {
  switch (made_of(output)) {
    case MadeOf::energy:
      return of_energy(1);
    case MadeOf::work:
      return of_energy(2);
    case MadeOf::stress:
      return of_stress(output, state);
    case MadeOf::apparent_young:
      return apparent_young_slope(model, state, output);
    case MadeOf::apparent_poisson:
      return apparent_poisson_slope(model, state, output);
    case MadeOf::particles:
      return of_particles(output, model, state);
    case MadeOf::bonds:
      return of_bonds(output, model, state, properties);
    case MadeOf::effective:
      break;
  }
  throw std::logic_error("an effective stiffness is not of one state");
}

bool depends_on_state(const Functional& f) {
  return !f.displacement.empty() || !f.reaction.empty() || !f.bonds.empty() || f.energy != 0 ||
         !f.stress.isZero(0);
}

void scale(Functional& functional, double factor) {
  for (auto& [particle, weight] : functional.displacement) weight *= factor;
  for (auto& [particle, weight] : functional.reaction) weight *= factor;
  for (BondWeight& bond : functional.bonds)
    bond.force *= factor, bond.energy *= factor, bond.radius *= factor;
  functional.energy *= factor;
  functional.stress *= factor;
}

}  // namespace

Functionals linearise(const Output& output, const Model& model, const StaticSolution& solution,
                      const std::vector<BondProperties>& properties) {
  const double value = evaluate_outputs(model, solution, {output}).front().value;
  if (!std::isfinite(value))
    refuse(
        output, fmt::format("{} is {}, which has no derivative", output.of, value),
        "ask for it where it has a value: at particles and bonds that are not left out, and have a section "
        "for stresses");
  Functionals functionals;
  if (made_of(output) == MadeOf::effective) {
    functionals = of_stiffness(output, solution);
  } else {
    std::vector<const State*> states;
    for (const State& state : solution.cases) states.push_back(&state);
    const State& state = load_case_of(output, states);
    functionals = {of_state(output, model, state, properties)};
    functionals.front().load_case = std::find(states.begin(), states.end(), &state) - states.begin();
  }
  std::erase_if(functionals, [](const Functional& f) { return !depends_on_state(f); });
  for (Functional& functional : functionals) scale(functional, output.scale);
  return functionals;
}

}  // namespace bondstatic
