#include "results/sensitivities.hpp"

#include <algorithm>
#include <cmath>

#include "bondstatic/error.hpp"
#include "results/linearise.hpp"

namespace bondstatic {

namespace {

/// Parameter of the bonds of a block, each bond's own value where it has one.
double value_of(const BondBlock& block, std::size_t parameter, Index in_block) {
  const auto own = block.overrides.find(parameter);
  const double value = own == block.overrides.end() ? not_given : own->second.at(std::size_t(in_block));
  return std::isnan(value) && parameter < block.parameters.size() ? block.parameters[parameter] : value;
}

/// The value that all of them have.
double common_value(const std::vector<double>& values) {
  const bool alike = std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); });
  return alike && !values.empty() ? values.front() : not_given;
}

ParameterSensitivity sensitivity(const Model& model, const BlockParameter& to,
                                 const ParameterDerivative& bonds, const BondGradients& gradient,
                                 double output, bool by_bond) {
  const BondBlock& block = model.blocks[std::size_t(to.block)];
  ParameterSensitivity out{to.block, find_bond_law(block.law)->parameters[to.parameter].name};
  const std::vector<double> of_bond = derivative_by_bond(gradient, bonds);
  std::vector<double> values;
  long double sum = 0, relative = 0;
  for (std::size_t i = 0; i < of_bond.size(); ++i) {
    values.push_back(value_of(block, to.parameter, model.bonds[std::size_t(bonds.bonds[i])].in_block));
    sum += of_bond[i];
    relative += of_bond[i] * static_cast<long double>(values.back());
  }
  out.value = common_value(values);
  out.derivative = double(sum);
  if (output != 0) out.elasticity = double(relative / output);
  if (by_bond) {
    out.of_bond.assign(model.bonds.size(), not_given);
    for (std::size_t i = 0; i < of_bond.size(); ++i) out.of_bond[std::size_t(bonds.bonds[i])] = of_bond[i];
  }
  return out;
}

}  // namespace

std::vector<BlockParameter> differentiable_parameters(const Model& model) {
  std::vector<BlockParameter> all;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const BondBlock& block = model.blocks[b];
    const std::vector<Parameter>& parameters = find_bond_law(block.law)->parameters;
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      const bool given =
          block.overrides.contains(p) || (p < block.parameters.size() && !std::isnan(block.parameters[p]));
      if (given && !parameters[p].whole && !parameters[p].truth) all.push_back({Index(b), p});
    }
  }
  return all;
}

std::vector<std::string> add_sensitivities(std::vector<OutputValue>& values,
                                           const std::vector<Output>& outputs, const Model& model,
                                           const StaticSolution& solution, StaticAnalysis& analysis,
                                           bool by_bond, int threads) {
  std::vector<std::string> warnings;
  std::vector<std::size_t> of_output;  // of each scalar
  std::vector<Functionals> scalars;
  for (std::size_t o = 0; o < outputs.size(); ++o) try {
      scalars.push_back(linearise(outputs[o], model, solution, analysis.properties()));
      of_output.push_back(o);
    } catch (const Error& error) {
      warnings.push_back(std::string("no sensitivities: ") + error.what());
    }
  const std::vector<BondGradients> gradients = analysis.gradients(scalars);
  for (const BlockParameter& parameter : differentiable_parameters(model)) {
    const ParameterDerivative bonds = bond_derivatives(model, parameter.block, parameter.parameter, threads);
    if (bonds.bonds.empty()) continue;
    for (std::size_t s = 0; s < scalars.size(); ++s) {
      OutputValue& value = values[of_output[s]];
      // The elasticity has no scale; the gradient holds the output's.
      value.sensitivities.push_back(sensitivity(model, parameter, bonds, gradients[s], value.value, by_bond));
    }
  }
  return warnings;
}

}  // namespace bondstatic
