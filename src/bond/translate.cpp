#include "bond/translate.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "bond/contact_point.hpp"

namespace bondstatic {
namespace {

/// Without the moments that stay in the bond.
BondProperties acting(BondProperties properties) {
  if (!properties.moments_fed_back) properties.stiffness.kt = properties.stiffness.kb = 0;
  return properties;
}

std::array<double, 4> four(const SectionStiffness& c) {
  return {c.kn, c.ks, c.kt, c.kb};
}

/// Blocks at the end of a model, whose bonds all have numbers of their own.
class OwnBlocks {
 public:
  explicit OwnBlocks(Model& model) : model_(model) {}

  /// Numbers in the order of the law's parameters. No block is made that has no bond: it would lack numbers.
  void join(Bond& bond, const std::string& law, std::initializer_list<double> numbers, double fraction) {
    const auto [found, made] = places_.try_emplace(law, model_.blocks.size());
    if (made) model_.blocks.emplace_back().law = law;
    BondBlock& block = model_.blocks[found->second];
    bond.block = Index(found->second);
    bond.in_block = Index(block.fractions.size());
    std::size_t parameter = 0;
    for (const double number : numbers) block.overrides[parameter++].push_back(number);
    block.fractions.push_back(fraction);
  }

 private:
  Model& model_;
  std::map<std::string, std::size_t> places_;
};

}  // namespace

TranslatedBond translate(const BondCode& code, const BondSite& site, BondProperties wanted) {
  const BondLaw& any = bond_laws().front();  // asked for a contact point of our choice
  const double fraction = contact_fraction(code.contact_point, any, site);
  if (wanted.stiffness.coupling != 0) {
    wanted.stiffness = moved(wanted.stiffness, (fraction - wanted.fraction) * site.length);
    wanted.fraction = fraction;
  }
  TranslatedBond out{wanted, code.stored_for(site, wanted), {}};
  out.realised = code.realised(site, out.stored);
  out.realised.fraction = fraction;
  return out;
}

Translation translate(const Model& model, const BondCode& code, int threads) {
  Translation out{&code, std::vector<std::vector<double>>(code.stored.size()), {}, {}};
  out.wanted = bond_properties(model, threads);
  out.realised.resize(out.wanted.size());
  for (std::vector<double>& numbers : out.stored) numbers.resize(out.wanted.size());
  for (std::size_t k = 0; k < out.wanted.size(); ++k) {
    const TranslatedBond bond = translate(code, bond_site(model, model.bonds[k]), out.wanted[k]);
    out.wanted[k] = bond.wanted;
    out.realised[k] = bond.realised;
    for (std::size_t p = 0; p < bond.stored.size(); ++p) out.stored[p][k] = bond.stored[p];
  }
  return out;
}

std::vector<BlockFit> block_fits(const Model& model, const Translation& translation) {
  const BondCode& code = *translation.code;
  std::vector<BlockFit> fits(model.blocks.size());
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    const BondProperties wanted = acting(translation.wanted[k]), realised = acting(translation.realised[k]);
    BlockFit& fit = fits[std::size_t(model.bonds[k].block)];
    const std::array<double, 4> want = four(wanted.stiffness), real = four(realised.stiffness);
    for (std::size_t i = 0; i < 4; ++i)
      if (real[i] != want[i]) {
        const double misfit = std::abs(real[i] - want[i]) / want[i];
        fit.misfit[i] =
            std::isnan(misfit) ? std::numeric_limits<double>::infinity() : std::max(fit.misfit[i], misfit);
      }
    fit.coupled += wanted.stiffness.coupling != 0;
    fit.moved = std::max(fit.moved, std::abs(realised.fraction - wanted.fraction));
    if (code.departure) {
      // Positions are sums of rounded numbers: touching particles hardly ever touch to the last digit.
      const double departure = code.departure(bond_site(model, model.bonds[k]));
      fit.departing += departure > 1e-9;
      fit.departure = std::max(fit.departure, departure);
    }
    if (fit.bonds++ == 0) {
      for (const std::vector<double>& numbers : translation.stored) fit.lowest.push_back(numbers[k]);
      fit.highest = fit.lowest;
    }
    for (std::size_t p = 0; p < fit.lowest.size(); ++p) {
      fit.lowest[p] = std::min(fit.lowest[p], translation.stored[p][k]);
      fit.highest[p] = std::max(fit.highest[p], translation.stored[p][k]);
    }
  }
  return fits;
}

Model as_realised(const Model& model, const Translation& translation, Convention convention) {
  Model out = model;
  if (convention == Convention::contact_point) {
    // The law's own way of moving: stepped sections move their stiffness along.
    for (std::size_t b = 0; b < out.blocks.size(); ++b) out.blocks[b].fractions.clear();
    for (std::size_t k = 0; k < out.bonds.size(); ++k) {
      const Bond& bond = out.bonds[k];
      std::vector<double>& fractions = out.blocks[std::size_t(bond.block)].fractions;
      if (fractions.size() <= std::size_t(bond.in_block))
        fractions.resize(std::size_t(bond.in_block) + 1, not_given);
      fractions[std::size_t(bond.in_block)] = translation.realised[k].fraction;
    }
    return out;
  }
  OwnBlocks blocks(out);
  for (std::size_t k = 0; k < out.bonds.size(); ++k) {
    const BondProperties realised = acting(translation.realised[k]);
    const SectionStiffness& c = realised.stiffness;
    const double fraction =
        convention == Convention::both ? realised.fraction : translation.wanted[k].fraction;
    // edem-v2 knows moments that stay in the bond, but wants shear, without which there is none to keep.
    if (realised.moments_fed_back || c.ks == 0)
      blocks.join(out.bonds[k], "generic", {c.kn, c.ks, c.kt, c.kb, realised.radius}, fraction);
    else
      blocks.join(out.bonds[k], "edem-v2",
                  {translation.stored[0][k], translation.stored[1][k], translation.stored[2][k], 0, 0, 1, 0},
                  fraction);
  }
  return out;
}

}  // namespace bondstatic
