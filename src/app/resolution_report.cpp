#include "app/resolution_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace bondstatic {

namespace {

constexpr double quiet_below = 1e-3;

std::string range(double from, double to) {
  const std::string first = fmt::format("{:.3g}", from), last = fmt::format("{:.3g}", to);
  return first == last ? last : first + " to " + last;
}

std::string range(const Spread& spread) {
  return range(spread.smallest, spread.largest);
}

std::string bends(const Spread& error) {
  const double from = 100 * error.smallest, to = 100 * error.largest;
  if (from < 0 && to > 0) return fmt::format("{:.3g} % less to {:.3g} % more", -from, to);
  return to <= 0 ? range(-to, -from) + " % less" : range(from, to) + " % more";
}

std::string basis(const BlockResolution& block) {
  return fmt::format("lambda_b {}{}", range(block.slenderness),
                     block.poisson_assumed > 0 ? fmt::format(", nu = {:g} assumed", assumed_poisson) : "");
}

std::string beside_a_beam(const BlockResolution& block) {
  const std::string one = block.row.largest > 1 ? fmt::format("one bond {}; ", bends(block.single)) : "";
  std::string text = fmt::format("a row of {} such bonds bends {} than Timoshenko's beam ({}{})",
                                 range(block.row), bends(block.deflection), one, basis(block));
  for (std::size_t i = 0; i < std::min<std::size_t>(2, block.advice.size()); ++i)
    text += "; " + block.advice[i];
  return text;
}

/// Where bonds do not stand in rows neither law is wrong.
std::string beside_a_beam_bond(const BlockResolution& block) {
  const bool same = block.transverse.largest_magnitude() < quiet_below;
  std::string text = fmt::format(
      "ks {} times a Timoshenko bond's ({}), kn and kb the same",
      same ? "1" : range(1 + block.transverse.smallest, 1 + block.transverse.largest), basis(block));
  if (block.offset.largest > quiet_below)
    text += fmt::format(", contact points up to {:.2g} L off mid-length", block.offset.largest);
  return text + "; a difference of bond laws, no error of a packing";
}

std::string text_of(const BlockResolution& block, bool numbered) {
  return fmt::format("{}{}: {}", numbered ? fmt::format("bonds.{} ", block.block) : "", block.law,
                     block.is_of_rows() ? beside_a_beam(block) : beside_a_beam_bond(block));
}

}  // namespace

std::vector<std::string> resolution_texts(const std::vector<BlockResolution>& blocks) {
  std::vector<std::string> texts;
  for (const BlockResolution& block : blocks)
    if (block.deflection.largest_magnitude() >= quiet_below)
      texts.push_back(text_of(block, blocks.size() > 1));
  return texts;
}

}  // namespace bondstatic
