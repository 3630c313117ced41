#include "bond/block_plan.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bond/contact_point.hpp"

namespace bondstatic {
namespace {

/// The parameters of the k-th bond of a block with overrides. What a bond says of itself beats what its block
/// says in other words (`radius` a `radius_factor`).
void own_parameters(const BlockPlan& plan, std::size_t k, std::vector<double>& values) {
  values = plan.values;
  const auto own = [&](const BlockPlan::Override& o) { return (*o.values).at(k); };
  for (const BlockPlan::Override& o : plan.overrides)
    if (!std::isnan(own(o)))
      for (const std::size_t p : o.rules_out) values[p] = not_given;
  for (const BlockPlan::Override& o : plan.overrides)
    if (!std::isnan(own(o))) values.at(o.parameter) = own(o);
}

/// Finite, positive along the axis, positive semi-definite (see SectionStiffness); NaN fails every
/// comparison.
bool sound(const BondProperties& p) {
  const SectionStiffness& c = p.stiffness;
  constexpr double inf = std::numeric_limits<double>::infinity(), rounding = 1 + 1e-14;
  const bool finite = c.kn < inf && c.ks < inf && c.kt < inf && c.kb < inf && std::isfinite(p.fraction);
  // Square roots, so that neither side over- or underflows.
  const bool definite = std::abs(c.coupling) <= rounding * std::sqrt(c.ks) * std::sqrt(c.kb);
  return finite && c.kn > 0 && c.ks >= 0 && c.kt >= 0 && c.kb >= 0 && definite;
}

/// The contact point that the bond is asked for.
ContactPoint contact_point(const BlockPlan& plan, const Bond& bond) {
  const double own = plan.fractions->empty() ? not_given : plan.fractions->at(std::size_t(bond.in_block));
  return std::isnan(own) ? plan.contact_point : ContactPoint{ContactPoint::Kind::fraction, own};
}

/// Finding and cure, "; " between them; empty if nothing is wrong.
std::string evaluate(const BlockPlan& plan, const Bond& bond, const BondSite& site,
                     std::span<const double> values, BondProperties& out) {
  const BondLaw& law = *plan.law;
  if (!(site.length > 0) || !std::isfinite(site.length))
    return fmt::format("length = {} must be positive; move the particles apart, or remove the bond",
                       site.length);
  if (law.forbids)
    if (std::string finding = law.forbids(site, values); !finding.empty()) return finding;
  out = law.evaluate(site, values);
  out.fraction = contact_fraction(contact_point(plan, bond), law, site);
  if (const double distance = transformed_by(plan, bond, site); distance != 0)
    out.stiffness = moved(out.stiffness, distance);
  if (sound(out)) return {};
  const SectionStiffness& c = out.stiffness;
  return fmt::format(
      "kn = {}, ks = {}, kt = {}, kb = {}, coupling = {}, contact point at {} of the branch: must be "
      "finite, kn positive, the others such that no motion yields energy; check the magnitudes of "
      "lengths, radii (Ra = {}, Rb = {}) and moduli",
      c.kn, c.ks, c.kt, c.kb, c.coupling, out.fraction, site.radius_a, site.radius_b);
}

}  // namespace

BlockPlan plan_block(const BondBlock& block, std::size_t number, std::vector<Fault>& faults) {
  const auto fault = [&](const std::string& what, const std::string& cure) {
    faults.push_back({{}, fmt::format("bonds.{} (law {}): {}", number, block.law, what), cure});
    return BlockPlan{};
  };
  const BondLaw* law = find_bond_law(block.law);
  if (!law) {
    std::string known;
    for (const BondLaw& each : bond_laws()) known += (known.empty() ? "" : ", ") + each.name;
    return fault("unknown law", "give one of " + known);
  }
  if (block.parameters.size() > law->parameters.size())
    return fault(
        fmt::format("{} parameters, but the law takes {}", block.parameters.size(), law->parameters.size()),
        "see `bondstatic laws`");
  BlockPlan out{law, block.contact_point, &block.fractions, parameter_rules(*law), block.parameters, {}};
  out.values.resize(law->parameters.size(), not_given);
  for (const auto& [parameter, values] : block.overrides)
    out.overrides.push_back({parameter, &values, out.rules.ruled_out_by(parameter)});
  std::vector<std::string> complaints;
  if (!out.overrides.empty() || complete(out.rules, out.values, complaints)) return out;
  for (const std::string& complaint : complaints) fault(complaint, "see `bondstatic laws`");
  return {};
}

const std::vector<double>* evaluate(const Model& model, const Bond& bond, const BlockPlan& plan,
                                    std::vector<double>& scratch, BondProperties& out, Findings& findings) {
  const std::vector<double>* values = &plan.values;
  if (!plan.overrides.empty()) {
    own_parameters(plan, std::size_t(bond.in_block), scratch);
    values = &scratch;
    std::vector<std::string> complaints;
    if (!complete(plan.rules, scratch, complaints)) {
      for (const std::string& complaint : complaints) findings.add(model, bond, complaint);
      return nullptr;
    }
  }
  const std::string finding = evaluate(plan, bond, bond_site(model, bond), *values, out);
  if (finding.empty()) return values;
  findings.add(model, bond, finding);
  return nullptr;
}

double transformed_by(const BlockPlan& plan, const Bond& bond, const BondSite& site) {
  const ContactPoint point = contact_point(plan, bond);
  if (!plan.law->stiffness_at_own_contact_point || point.kind == ContactPoint::Kind::of_law) return 0;
  const double own = contact_fraction(plan.law->contact_point, *plan.law, site);
  return (contact_fraction(point, *plan.law, site) - own) * site.length;
}

}  // namespace bondstatic
