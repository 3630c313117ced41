#include <fmt/format.h>

#include <cmath>

#include "bondstatic/error.hpp"
#include "bondstatic/output.hpp"
#include "results/apparent_poisson.hpp"
#include "results/apparent_young.hpp"
#include "results/cell_quantities.hpp"
#include "results/output_values.hpp"
#include "results/quantities.hpp"

namespace bondstatic {

void refuse(const Output& output, const std::string& reason, const std::string& cure) {
  throw Error(ExitCode::invalid_input,
              fmt::format("output \"{}\": {}\n    cure: {}", output.name, reason, cure));
}

const State& load_case_of(const Output& output, const std::vector<const State*>& states) {
  for (const State* state : states)
    if (state->name == output.load_case) return *state;
  if (output.load_case.empty() && states.size() == 1) return *states.front();
  std::string names;
  for (const State* state : states) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", state->name);
  refuse(output, fmt::format("no load case \"{}\"", output.load_case), "set case to one of " + names);
}

MadeOf made_of(const Output& output) {
  if (output.of == "apparent_young") return MadeOf::apparent_young;
  if (output.of == "apparent_poisson") return MadeOf::apparent_poisson;
  // "energy" is a column of bonds as well: with a selection it is theirs.
  if (output.of == "energy" && output.at.empty()) return MadeOf::energy;
  if (output.of == "work") return MadeOf::work;
  if (find_stress_quantity(output.of)) return MadeOf::stress;
  if (find_effective_quantity(output.of)) return MadeOf::effective;
  if (find_particle_quantity(output.of)) return MadeOf::particles;
  if (find_bond_quantity(output.of)) return MadeOf::bonds;
  refuse(output, fmt::format("no quantity \"{}\"", output.of),
         "name a column of particles.csv or bonds.csv, energy, work, apparent_young or apparent_poisson");
}

double effective_value(const Output& output, const std::optional<EffectiveStiffness>& effective) {
  if (!effective)
    refuse(output, fmt::format("{} needs a static solve of six strains of a periodic cell", output.of),
           "add [cell], periodic in all directions, and no loads");
  return find_effective_quantity(output.of)->of(*effective);
}

double stress_value(const Output& output, const State& state) {
  const StressQuantity& quantity = *find_stress_quantity(output.of);
  const double value = state.stress(quantity.row, quantity.column);
  if (std::isnan(value))
    refuse(output, fmt::format("{} needs a periodic cell", output.of), "add [cell], or ask for a reaction");
  return value;
}

std::vector<double> values_at(const Output& output, const Model& model, const State& state) {
  std::vector<double> values;
  if (made_of(output) == MadeOf::particles) {
    const ParticleQuantity& quantity = *find_particle_quantity(output.of);
    for (const Index p : output.at) values.push_back(value_at(quantity, model, state, p));
  } else {
    const BondQuantity& quantity = *find_bond_quantity(output.of);
    for (const Index b : output.at) values.push_back(quantity.of(state.bonds[std::size_t(b)]));
  }
  return values;
}

OutputValue told(const Output& output, double quantity) {
  return {output.name, output.scale * quantity, output.expected, output.tolerance, output.source};
}

namespace {

double quantity_of(const Output& output, const Model& model, const State& state) {
  switch (made_of(output)) {
    case MadeOf::energy:
      return state.energy;
    case MadeOf::work:
      return state.work;
    case MadeOf::stress:
      return stress_value(output, state);
    case MadeOf::effective:
      return effective_value(output, std::nullopt);
    case MadeOf::apparent_young:
      return apparent_young(model, state, output);
    case MadeOf::apparent_poisson:
      return apparent_poisson(model, state, output);
    case MadeOf::particles:
    case MadeOf::bonds:
      break;
  }
  return reduce(output, values_at(output, model, state));
}

}  // namespace

const std::vector<Quantity>& output_quantities() {
  static const std::vector<Quantity> quantities = [] {
    std::vector<Quantity> all;
    for (const ParticleQuantity& quantity : particle_quantities())
      all.push_back({quantity.name, Quantity::Where::particle, quantity.meaning});
    for (const BondQuantity& quantity : bond_quantities())
      all.push_back({quantity.name, Quantity::Where::bond, quantity.meaning});
    all.push_back({"energy", Quantity::Where::model, "strain energy of all bonds"});
    all.push_back({"work", Quantity::Where::model, "work of the loads and of moved supports"});
    for (const StressQuantity& quantity : stress_quantities())
      all.push_back({quantity.name, Quantity::Where::model, quantity.meaning});
    for (const EffectiveQuantity& quantity : effective_quantities())
      all.push_back({quantity.name, Quantity::Where::model, quantity.meaning});
    all.push_back({"apparent_young", Quantity::Where::model,
                   "F H / (A d) of a specimen between the platens `base` and `at`"});
    all.push_back({"apparent_poisson", Quantity::Where::model,
                   "lateral strain of `middle` over axial strain between the platens `base` and `at`"});
    return all;
  }();
  return quantities;
}

double OutputValue::relative_error() const {
  if (!expected) return not_given;
  return *expected == 0 ? std::abs(value) : std::abs(value - *expected) / std::abs(*expected);
}

double evaluate_output(const Model& model, const State& state, const Output& output) {
  return told(output, quantity_of(output, model, state)).value;
}

std::vector<OutputValue> evaluate_outputs(const Model& model, const std::vector<const State*>& states,
                                          const std::vector<Output>& outputs) {
  std::vector<OutputValue> values;
  for (const Output& output : outputs)
    values.push_back(told(output, quantity_of(output, model, load_case_of(output, states))));
  return values;
}

std::vector<OutputValue> evaluate_outputs(const Model& model, const StaticSolution& solution,
                                          const std::vector<Output>& outputs) {
  std::vector<const State*> states;
  for (const State& state : solution.cases) states.push_back(&state);
  std::vector<OutputValue> values;
  for (const Output& output : outputs)
    values.push_back(made_of(output) == MadeOf::effective
                         ? told(output, effective_value(output, solution.effective))
                         : evaluate_outputs(model, states, {output}).front());
  return values;
}

}  // namespace bondstatic
