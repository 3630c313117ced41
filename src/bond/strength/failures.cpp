#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bond/findings.hpp"
#include "bond/strength/draws.hpp"
#include "bondstatic/strength.hpp"

namespace bondstatic {
namespace {

/// What a block says of the strength of all its bonds, looked up once. Nothing: they never break, or
/// something is wrong.
struct StrengthPlan {
  const BondStrength* given = nullptr;
  const StrengthCriterion* criterion = nullptr;
  std::vector<double> strengths;  ///< complete where no bond has its own
};

StrengthPlan plan_strength(const BondBlock& block, std::size_t number, std::vector<Fault>& faults) {
  if (!block.strength) return {};
  const BondStrength& given = *block.strength;
  const std::size_t before = faults.size();
  const auto fault = [&](const std::string& what, const std::string& cure) {
    faults.push_back({{}, fmt::format("bonds.{} (strength {}): {}", number, given.criterion, what), cure});
  };
  const StrengthCriterion* criterion = find_strength_criterion(given.criterion);
  if (!criterion) {
    std::string known;
    for (const StrengthCriterion& each : strength_criteria())
      known += (known.empty() ? "" : ", ") + each.name;
    fault("unknown criterion", "give one of " + known);
    return {};
  }
  std::vector<std::string> complaints;
  StrengthPlan plan{&given, criterion, given.parameters};
  plan.strengths.resize(std::max(plan.strengths.size(), criterion->parameters.size()), not_given);
  // What single bonds have of their own is checked with them.
  if (given.overrides.empty()) plan.strengths = complete_strengths(*criterion, plan.strengths, complaints);
  for (const std::string& complaint : complaints) fault(complaint, "see `bondstatic laws --strengths`");
  for (std::size_t p = 0; p < given.spread.size(); ++p) {
    const double spread = given.spread[p];
    if (p >= criterion->parameters.size() || (spread != 0 && !criterion->scatters[p]))
      fault(fmt::format("spread = {}: not of a strength", spread), "leave it out: only strengths scatter");
    else if (!(spread >= 0 && std::isfinite(spread)))
      fault(fmt::format("spread of {} = {}: must be finite, not negative", criterion->parameters[p].name,
                        spread),
            "give 0 where it shall not scatter");
  }
  return faults.size() == before ? plan : StrengthPlan{};
}

/// The bond's strengths before they scatter; false, and said in `findings`, where something is wrong.
bool own_strengths(const Model& model, const Bond& bond, const StrengthPlan& plan, std::vector<double>& own,
                   Findings& findings) {
  own = plan.strengths;
  if (plan.given->overrides.empty()) return true;
  for (const auto& [parameter, values] : plan.given->overrides)
    if (const double value = values.at(std::size_t(bond.in_block)); !std::isnan(value))
      own.at(parameter) = value;
  std::vector<std::string> complaints;
  own = complete_strengths(*plan.criterion, std::move(own), complaints);
  for (const std::string& complaint : complaints)
    findings.add(model, bond, complaint + "; see `bondstatic laws --strengths`");
  return complaints.empty();
}

/// Draws a bond's strengths in place; likewise.
bool draw(const Model& model, const Bond& bond, Index ordinal, const StrengthPlan& plan,
          std::vector<double>& strengths, Findings& findings) {
  const BondStrength& of = *plan.given;
  const Index a = model.particles[std::size_t(bond.a)].id, b = model.particles[std::size_t(bond.b)].id;
  const std::uint64_t key = bond_key(of.seed, a, b, ordinal);
  for (std::size_t p = 0; p < of.spread.size(); ++p) {
    const double drawn = drawn_strength(of.scatter, strengths[p], of.spread[p], key, of.together ? 0 : p);
    if (std::isnan(drawn)) {
      findings.add(model, bond,
                   fmt::format("{} = {}: none of 1000 draws with spread {} is positive and finite; give "
                               "another spread",
                               plan.criterion->parameters[p].name, strengths[p], of.spread[p]));
      return false;
    }
    strengths[p] = drawn;
  }
  return true;
}

std::string not_sound(const FailureMode& mode, const StrengthCriterion& criterion, double radius) {
  for (const double number : {mode.normal, mode.shear, mode.twisting, mode.bending})
    if (!std::isfinite(number))
      return fmt::format(
          "utilisation in {} is not finite with the bond's radius {}; check the magnitudes of radius and "
          "strengths",
          criterion.modes.at(std::size_t(mode.name)), radius);
  return {};
}

}  // namespace

BondFailures bond_failures(const Model& model, std::span<const BondProperties> properties) {
  std::vector<Fault> faults;
  std::vector<StrengthPlan> plans;
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    plans.push_back(plan_strength(model.blocks[b], b, faults));
  const bool scatters = std::any_of(plans.begin(), plans.end(), [](const StrengthPlan& plan) {
    return plan.given && plan.given->scatter != BondStrength::Scatter::none;
  });
  const std::vector<Index> ordinals = scatters ? ordinals_in_pair(model) : std::vector<Index>{};

  BondFailures out;
  out.first.assign(1, 0);
  out.strengths.resize(model.bonds.size());
  const auto add = [&](std::size_t k, const StrengthPlan& plan, Findings& findings) {
    const Bond& bond = model.bonds[k];
    const StrengthCriterion& criterion = *plan.criterion;
    const BondProperties& section = properties[k];
    if (criterion.needs_section && std::isnan(section.radius))
      return findings.add(model, bond,
                          fmt::format("{} speaks of stresses, but the bond has no section; give its radius, "
                                      "or a criterion of forces such as contact-bond",
                                      criterion.name));
    std::vector<double>& strengths = out.strengths[k];
    if (!own_strengths(model, bond, plan, strengths, findings)) return;
    if (scatters && !draw(model, bond, ordinals[k], plan, strengths, findings)) return;
    const std::size_t before = out.modes.size();
    criterion.failure_modes({section.radius, bond.branch.norm(), section.fraction}, strengths, out.modes);
    for (std::size_t m = before; m < out.modes.size(); ++m)
      if (std::string finding = not_sound(out.modes[m], criterion, section.radius); !finding.empty())
        return findings.add(model, bond, finding);
  };
  // By one thread, so that the bonds come in order.
  visit_pieces(Index(model.bonds.size()), 1, std::move(faults),
               [&](Index begin, Index end, Findings& findings) {
                 for (std::size_t k = std::size_t(begin); k < std::size_t(end); ++k) {
                   const StrengthPlan& plan = plans.at(std::size_t(model.bonds[k].block));
                   if (plan.criterion) add(k, plan, findings);
                   out.first.push_back(Index(out.modes.size()));
                 }
               });
  return out;
}

}  // namespace bondstatic
