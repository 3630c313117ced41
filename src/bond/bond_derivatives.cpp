#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <utility>

#include "bond/block_plan.hpp"
#include "bond/contact_point.hpp"

namespace bondstatic {
namespace {

bool is_number(const Parameter& parameter) {
  return !parameter.whole && !parameter.truth;
}

void check_parameter(const BondLaw& law, Index block, std::size_t parameter) {
  std::string numbers;
  for (const Parameter& each : law.parameters)
    if (is_number(each)) numbers += (numbers.empty() ? "" : ", ") + each.name;
  const auto refuse = [&](const std::string& what) {
    throw Error(ExitCode::invalid_input, fmt::format("bonds.{} (law {}): {}; derivatives can be taken to {}",
                                                     block, law.name, what, numbers));
  };
  if (parameter >= law.parameters.size())
    refuse(fmt::format("parameter {}: the law has {}", parameter, law.parameters.size()));
  const Parameter& asked = law.parameters[parameter];
  if (!is_number(asked))
    refuse(fmt::format("{} is {}, and nothing has a derivative to it", asked.name,
                       asked.truth ? "true or false" : "a whole number"));
}

bool finite(const BondDerivative& derivative) {
  const SectionStiffness& c = derivative.stiffness;
  return std::isfinite(c.kn) && std::isfinite(c.ks) && std::isfinite(c.kt) && std::isfinite(c.kb) &&
         std::isfinite(c.coupling) && std::isfinite(derivative.radius);
}

}  // namespace

ParameterDerivative bond_derivatives(const Model& model, Index block, std::size_t parameter, int threads) {
  if (block < 0 || block >= Index(model.blocks.size()))
    throw Error(ExitCode::invalid_input,
                fmt::format("bonds.{}: the model has {} blocks, counted from 0", block, model.blocks.size()));
  std::vector<Fault> faults;
  const BlockPlan plan = plan_block(model.blocks[std::size_t(block)], std::size_t(block), faults);
  if (!faults.empty()) throw InputError(std::move(faults));
  check_parameter(*plan.law, block, parameter);
  const std::string& name = plan.law->parameters[parameter].name;

  std::vector<Index> bonds;
  for (std::size_t k = 0; k < model.bonds.size(); ++k)
    if (model.bonds[k].block == block) bonds.push_back(Index(k));
  std::vector<BondDerivative> of_bond(bonds.size());
  std::vector<std::uint8_t> given(bonds.size());
  visit_pieces(Index(bonds.size()), threads, {}, [&](Index begin, Index end, Findings& findings) {
    std::vector<double> scratch;
    BondProperties properties;
    for (std::size_t i = std::size_t(begin); i < std::size_t(end); ++i) {
      const Bond& bond = model.bonds[std::size_t(bonds[i])];
      const std::vector<double>* values = evaluate(model, bond, plan, scratch, properties, findings);
      if (!values || std::isnan((*values)[parameter])) continue;
      given[i] = true;
      const BondSite site = bond_site(model, bond);
      of_bond[i] = plan.law->differentiate(site, *values, parameter);
      // Where C is moved to does not depend on the law's parameters, and it is moved linearly.
      if (const double distance = transformed_by(plan, bond, site); distance != 0)
        of_bond[i].stiffness = moved(of_bond[i].stiffness, distance);
      if (!finite(of_bond[i]))
        findings.add(model, bond,
                     fmt::format("the derivative to {} = {} exceeds the range of doubles; check the "
                                 "magnitudes of lengths, radii and moduli",
                                 name, (*values)[parameter]));
    }
  });

  ParameterDerivative out;
  const auto& overrides = model.blocks[std::size_t(block)].overrides;
  const auto own = overrides.find(parameter);
  for (std::size_t i = 0; i < bonds.size(); ++i) {
    if (!given[i]) continue;
    const Bond& bond = model.bonds[std::size_t(bonds[i])];
    out.bonds.push_back(bonds[i]);
    out.of_bond.push_back(of_bond[i]);
    out.has_own.push_back(own != overrides.end() && !std::isnan(own->second.at(std::size_t(bond.in_block))));
  }
  return out;
}

}  // namespace bondstatic
