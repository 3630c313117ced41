#include "results/resolution_advice.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bondstatic/bond_law.hpp"
#include "results/bond_beam.hpp"

namespace bondstatic {

namespace {

constexpr double worth_saying = 1e-3;  // relative

bool is_given(const BondBlock& block, const std::string& parameter) {
  const Index p = find_bond_law(block.law)->find(parameter);
  return p >= 0 && std::size_t(p) < block.parameters.size() && !std::isnan(block.parameters[std::size_t(p)]);
}

/// The law's own words for kn/ks.
std::string ratio_name(const BondBlock& block) {
  if (block.law == "parallel") return "kappa";
  return is_given(block, "stiffness_ratio") ? "stiffness_ratio" : "normal_stiffness/shear_stiffness";
}

std::string timoshenko_advice(const BondBlock& given, const Inputs& inputs) {
  const bool takes_young = find_bond_law(given.law)->find("young") >= 0;
  return fmt::format(
      "law = \"timoshenko\"{} is exact for any number of bonds",
      takes_young ? "" : fmt::format(" with young = {} (kn L/A) and a poisson", range_text(inputs.young)));
}

std::string ratio_advice(const BlockResolution& block, const BondBlock& given, const Inputs& inputs) {
  const bool moved = block.offset.largest > worth_saying;
  const auto sentence = [&](const std::string& name, const Spread& exact, const Spread& now) {
    return fmt::format("{} = {} (now {}){} is exact for these", name, range_text(exact), range_text(now),
                       moved ? " with contact_point = \"beam\"" : "");
  };
  if (given.law == "obermayr")
    return sentence("shear_coefficient", inputs.beam_coefficient, inputs.shear_coefficient);
  return sentence(ratio_name(given), block.beam_kappa, block.kappa);
}

/// These laws derive kt from ks.
std::string twisting_advice(const BlockResolution& block) {
  const double twisting = (1 + block.twisting.median) * block.kappa.median / block.beam_kappa.median;
  return fmt::format("twisting stiffness is then {:.3g} times the beam's", twisting);
}

std::string length_advice(const BlockResolution& block) {
  if (block.law == "euler-bernoulli")
    return "other lengths of the bonds change nothing: what is missing is shear deformation";
  const BondBeam typical{block.slenderness.median, block.kappa.median, block.poisson.median, 0};
  const double now = deflection_error(typical, block.row.median);
  const double then = halved_error(typical, block.row.median);
  if (std::abs(then) >= std::abs(now)) return "";
  return fmt::format("bonds half as long, twice as many: the error falls from {:.3g} % to {:.3g} %",
                     100 * now, 100 * then);
}

}  // namespace

std::string range_text(const Spread& spread) {
  if (spread.largest - spread.smallest <= 1e-9 * std::abs(spread.largest))
    return fmt::format("{:.8g}", spread.median);
  return fmt::format("{:.4g} to {:.4g}", spread.smallest, spread.largest);
}

std::vector<std::string> advice_for(const BlockResolution& block, const BondBlock& given,
                                    const Inputs& inputs) {
  std::vector<std::string> advice;
  const bool shear_differs = block.transverse.largest_magnitude() > worth_saying;
  const bool moved = block.offset.largest > worth_saying;
  const bool takes_ratio = given.law != "euler-bernoulli" && given.law != "timoshenko";
  if (shear_differs) advice.push_back(timoshenko_advice(given, inputs));
  if (shear_differs && takes_ratio) advice.push_back(ratio_advice(block, given, inputs));
  if (shear_differs && takes_ratio && given.law != "obermayr") advice.push_back(twisting_advice(block));
  if (moved && !(shear_differs && takes_ratio))
    advice.push_back("contact_point = \"beam\" acts at mid-length, as beams do");
  if (shear_differs && !moved && block.is_of_rows())
    if (const std::string text = length_advice(block); !text.empty()) advice.push_back(text);
  return advice;
}

}  // namespace bondstatic
