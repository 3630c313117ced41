#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "bond/contact_point.hpp"
#include "bond/parameters.hpp"
#include "bondstatic/bond_law.hpp"
#include "bondstatic/error.hpp"

namespace bondstatic {
namespace {

/// Bonds of a packing tend to fail together: say the first ones, count the others.
constexpr std::size_t most_faults = 20;

/// What a block says of all its bonds, looked up once.
struct BlockPlan {
  struct Override {
    std::size_t parameter;
    const std::vector<double>* values;  ///< by position in the block
    std::vector<std::size_t> rules_out;
  };

  const BondLaw* law = nullptr;
  ContactPoint contact_point;
  const std::vector<double>* fractions = nullptr;  ///< of single bonds; empty: none
  ParameterRules rules;
  std::vector<double> values;  ///< complete where there are no overrides
  std::vector<Override> overrides;
};

/// A sound plan, or one without law, with the faults said.
BlockPlan plan(const BondBlock& block, std::size_t number, std::vector<Fault>& faults) {
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

/// The contact point that the k-th bond of the block is asked for.
ContactPoint contact_point(const BlockPlan& plan, Index k) {
  const double own = plan.fractions->empty() ? not_given : plan.fractions->at(std::size_t(k));
  return std::isnan(own) ? plan.contact_point : ContactPoint{ContactPoint::Kind::fraction, own};
}

/// Finding and cure, "; " between them; empty if nothing is wrong.
std::string evaluate(const BlockPlan& plan, ContactPoint point, const BondSite& site,
                     std::span<const double> values, BondProperties& out) {
  const BondLaw& law = *plan.law;
  if (!(site.length > 0) || !std::isfinite(site.length))
    return fmt::format("length = {} must be positive; move the particles apart, or remove the bond",
                       site.length);
  if (law.forbids)
    if (std::string finding = law.forbids(site, values); !finding.empty()) return finding;
  out = law.evaluate(site, values);
  out.fraction = contact_fraction(point, law, site);
  if (law.stiffness_at_own_contact_point && point.kind != ContactPoint::Kind::of_law) {
    const double own = contact_fraction(law.contact_point, law, site);
    out.stiffness = moved(out.stiffness, (out.fraction - own) * site.length);
  }
  if (sound(out)) return {};
  const SectionStiffness& c = out.stiffness;
  return fmt::format(
      "kn = {}, ks = {}, kt = {}, kb = {}, coupling = {}, contact point at {} of the branch: must be "
      "finite, kn positive, the others such that no motion yields energy; check the magnitudes of "
      "lengths, radii (Ra = {}, Rb = {}) and moduli",
      c.kn, c.ks, c.kt, c.kb, c.coupling, out.fraction, site.radius_a, site.radius_b);
}

Fault bond_fault(const Model& model, const Bond& bond, const BondLaw& law, const std::string& text) {
  const std::size_t split = text.find("; ");
  const Index a = model.particles[std::size_t(bond.a)].id, b = model.particles[std::size_t(bond.b)].id;
  return {{},
          fmt::format("bond {} between particles {} and {} (law {}): {}", bond.id, a, b, law.name,
                      text.substr(0, split)),
          split == std::string::npos ? "see `bondstatic laws`" : text.substr(split + 2)};
}

/// What is wrong with some of the bonds.
struct Findings {
  std::vector<Fault> faults;
  std::size_t unsaid = 0;      ///< faults beyond those
  std::exception_ptr failure;  ///< what a law threw: it must not leave its thread
};

/// Bonds [begin, end) into `out`.
void evaluate(const Model& model, const std::vector<BlockPlan>& plans, Index begin, Index end,
              std::vector<BondProperties>& out, Findings& findings) try {
  std::vector<std::string> found;
  std::vector<double> values;
  for (Index k = begin; k < end; ++k) {
    const Bond& bond = model.bonds[std::size_t(k)];
    const BlockPlan& plan = plans.at(std::size_t(bond.block));
    if (!plan.law) continue;
    const BondSite site = bond_site(model, bond);
    found.clear();
    BondProperties& own = out[std::size_t(k)];
    const ContactPoint point = contact_point(plan, bond.in_block);
    if (plan.overrides.empty()) {
      found.push_back(evaluate(plan, point, site, plan.values, own));
    } else {
      own_parameters(plan, std::size_t(bond.in_block), values);
      if (complete(plan.rules, values, found)) found.push_back(evaluate(plan, point, site, values, own));
    }
    for (const std::string& text : found) {
      if (text.empty()) continue;
      if (findings.faults.size() < most_faults)
        findings.faults.push_back(bond_fault(model, bond, *plan.law, text));
      else
        ++findings.unsaid;
    }
  }
} catch (...) {
  findings.failure = std::current_exception();
}

}  // namespace

BondSite bond_site(const Model& model, const Bond& bond) {
  const Particle& a = model.particles.at(std::size_t(bond.a));
  const Particle& b = model.particles.at(std::size_t(bond.b));
  return {bond.branch.norm(), a.radius, b.radius, a.id, b.id};
}

std::vector<BondProperties> bond_properties(const Model& model, int threads) {
  std::vector<Fault> faults;
  std::vector<BlockPlan> plans;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) plans.push_back(plan(model.blocks[b], b, faults));

  constexpr Index piece = 1 << 14;  // bonds that one thread takes at a time
  const Index bonds = Index(model.bonds.size()), pieces = (bonds + piece - 1) / piece;
  std::vector<BondProperties> out(model.bonds.size());
  std::vector<Findings> findings(static_cast<std::size_t>(pieces));
  threads = int(std::clamp<Index>(pieces, 1, std::max(1, threads)));
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1)
  for (Index i = 0; i < pieces; ++i)
    evaluate(model, plans, i * piece, std::min(bonds, (i + 1) * piece), out, findings[std::size_t(i)]);

  std::size_t unsaid = 0;
  for (Findings& found : findings) {
    unsaid += found.unsaid;
    for (Fault& fault : found.faults)
      if (faults.size() < most_faults)
        faults.push_back(std::move(fault));
      else
        ++unsaid;
    if (found.failure) std::rethrow_exception(found.failure);
  }
  if (unsaid > 0)
    faults.push_back({{}, fmt::format("and {} more faults of this kind in other bonds", unsaid), "as above"});
  if (!faults.empty()) throw InputError(std::move(faults));
  return out;
}

}  // namespace bondstatic
