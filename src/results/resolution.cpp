#include "bondstatic/resolution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "bondstatic/bond_law.hpp"
#include "results/bond_beam.hpp"
#include "results/bond_rows.hpp"
#include "results/resolution_advice.hpp"

namespace bondstatic {

namespace {

constexpr double coarse_from = 0.01;

bool is_known(const BondBlock& block) {
  for (const char* law : {"parallel", "pfc-parallel", "euler-bernoulli", "obermayr", "edem-v2"})
    if (block.law == law) return true;
  const ContactPoint::Kind kind = block.contact_point.kind;
  const bool elsewhere = kind != ContactPoint::Kind::of_law && kind != ContactPoint::Kind::beam;
  return block.law == "timoshenko" && (elsewhere || !block.fractions.empty());
}

/// Where a block says nu.
class PoissonGiven {
 public:
  explicit PoissonGiven(const BondBlock& block) {
    const BondLaw& law = *find_bond_law(block.law);
    const Index poisson = law.find("poisson");
    if (poisson < 0) return;
    of_block_ = !std::isnan(block.parameters.at(std::size_t(poisson)));
    own_poisson_ = own(block, poisson), own_kappa_ = own(block, law.find("kappa"));
  }

  /// Does the k-th bond? What it says of itself comes first.
  bool operator()(std::size_t k) const {
    if (own_poisson_ && !std::isnan(own_poisson_->at(k))) return true;
    return of_block_ && !(own_kappa_ && !std::isnan(own_kappa_->at(k)));
  }

 private:
  static const std::vector<double>* own(const BondBlock& block, Index parameter) {
    const auto found = block.overrides.find(std::size_t(parameter));
    return found == block.overrides.end() ? nullptr : &found->second;
  }

  bool of_block_ = false;
  const std::vector<double>*own_poisson_ = nullptr, *own_kappa_ = nullptr;
};

/// Wherever kappa is not given, kb/kt = E I/G J = 1 + nu holds exactly.
double poisson_of(const SectionStiffness& stiffness) {
  return stiffness.kb / stiffness.kt - 1;
}

/// Puts `values` into another order.
Spread spread_of(std::vector<double>& values) {
  const auto rank = [&](double part) {
    return values.begin() + std::ptrdiff_t(std::lround(part * double(values.size() - 1)));
  };
  const auto lower = rank(0.25), median = rank(0.5), upper = rank(0.75);
  std::nth_element(values.begin(), median, values.end());
  std::nth_element(values.begin(), lower, median);
  std::nth_element(median, upper, values.end());
  return {*std::min_element(values.begin(), lower + 1), *lower, *median, *upper,
          *std::max_element(upper, values.end())};
}

Index coarse_bonds(const std::vector<double>& errors) {
  Index coarse = 0;
  for (std::size_t i = 0; i < errors.size(); i += 2)
    coarse += std::max(std::abs(errors[i]), std::abs(errors[i + 1])) > coarse_from;
  return coarse;
}

/// The bonds of a block that count, with what is asked of each.
struct Beams {
  const Model& model;
  const std::vector<BondProperties>& properties;
  const UnbranchedRows& rows;
  double poisson = 0;              ///< assumed
  std::vector<std::size_t> bonds;  ///< positions in the model
  std::vector<bool> assumed;       ///< by position here: nu

  const BondProperties& of(std::size_t i) const { return properties[bonds[i]]; }
  double length(std::size_t i) const { return model.bonds[bonds[i]].branch.norm(); }
  double row(std::size_t i) const { return double(rows.length[bonds[i]]); }
  BondBeam beam(std::size_t i) const {
    const SectionStiffness& c = of(i).stiffness;
    return {length(i) / (2 * of(i).radius), c.kn / c.ks, assumed[i] ? poisson : poisson_of(c),
            std::abs(of(i).fraction - 0.5)};
  }

  template <class Value>
  Spread spread(Value value) const {
    std::vector<double> values(bonds.size());
    for (std::size_t i = 0; i < bonds.size(); ++i) values[i] = value(i);
    return spread_of(values);
  }

  /// e_n, held at one end and at the other.
  std::vector<double> deflection_errors(bool in_row) const {
    std::vector<double> errors;
    errors.reserve(2 * bonds.size());
    for (std::size_t i = 0; i < bonds.size(); ++i) {
      BondBeam held = beam(i);
      errors.push_back(deflection_error(held, in_row ? row(i) : 1));
      held.offset = -held.offset;
      errors.push_back(deflection_error(held, in_row ? row(i) : 1));
    }
    return errors;
  }
};

BlockResolution describe(const Beams& beams) {
  BlockResolution out;
  out.bonds = Index(beams.bonds.size());
  for (const std::size_t k : beams.bonds) out.in_rows += beams.rows.unbranched[k];
  out.poisson_assumed = std::count(beams.assumed.begin(), beams.assumed.end(), true);

  const auto of_beam = [&](auto value) {
    return beams.spread([&](std::size_t i) { return value(beams.beam(i)); });
  };
  const auto exact = [](const BondBeam& b) { return beam_kappa(b.slenderness, b.poisson); };
  out.slenderness = of_beam([](const BondBeam& b) { return b.slenderness; });
  out.poisson = of_beam([](const BondBeam& b) { return b.poisson; });
  out.row = beams.spread([&](std::size_t i) { return beams.row(i); });
  std::vector<double> errors = beams.deflection_errors(true);
  out.coarse = double(coarse_bonds(errors)) / double(out.bonds);
  out.deflection = spread_of(errors);
  errors = beams.deflection_errors(false);
  out.single = spread_of(errors);
  out.enough = of_beam([](const BondBeam& b) { return bonds_for_tolerance(b, coarse_from); });
  out.transverse = of_beam([&](const BondBeam& b) { return exact(b) / b.kappa - 1; });
  out.twisting = beams.spread([&](std::size_t i) {
    return beams.assumed[i] ? (1 + beams.poisson) / (1 + poisson_of(beams.of(i).stiffness)) - 1 : 0;
  });
  out.offset = of_beam([](const BondBeam& b) { return b.offset; });
  out.kappa = of_beam([](const BondBeam& b) { return b.kappa; });
  out.beam_kappa = of_beam(exact);
  return out;
}

Inputs inputs_of(const Beams& beams) {
  Inputs out;
  out.young = beams.spread([&](std::size_t i) {
    const double radius = beams.of(i).radius;
    return beams.of(i).stiffness.kn * beams.length(i) / (std::numbers::pi * radius * radius);
  });
  const auto coefficient = [&](auto kappa) {
    return beams.spread([&](std::size_t i) {
      const BondBeam beam = beams.beam(i);
      return 2 * (1 + beam.poisson) / kappa(beam);
    });
  };
  out.shear_coefficient = coefficient([](const BondBeam& b) { return b.kappa; });
  out.beam_coefficient = coefficient([](const BondBeam& b) { return beam_kappa(b.slenderness, b.poisson); });
  return out;
}

}  // namespace

std::vector<BlockResolution> resolution_of(const Model& model, int threads, double poisson) {
  std::vector<BlockResolution> out;
  if (std::none_of(model.blocks.begin(), model.blocks.end(), is_known)) return out;
  const std::vector<BondProperties> properties = bond_properties(model, threads);
  const UnbranchedRows rows = bond_rows(model);
  std::vector<Beams> blocks(model.blocks.size(), {model, properties, rows, poisson, {}, {}});
  std::vector<std::optional<PoissonGiven>> known(model.blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b)
    if (is_known(model.blocks[b])) known[b].emplace(model.blocks[b]);
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    const auto b = std::size_t(model.bonds[k].block);
    if (!known[b] || !properties[k].moments_fed_back) continue;
    blocks[b].bonds.push_back(k);
    blocks[b].assumed.push_back(!(*known[b])(std::size_t(model.bonds[k].in_block)));
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (blocks[b].bonds.empty()) continue;
    BlockResolution& block = out.emplace_back(describe(blocks[b]));
    block.block = Index(b);
    block.law = model.blocks[b].law;
    block.advice = advice_for(block, model.blocks[b], inputs_of(blocks[b]));
  }
  return out;
}

}  // namespace bondstatic
