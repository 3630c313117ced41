#include "bond/strength/draws.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "bond/laws/scatter.hpp"

namespace bondstatic {
namespace {

/// Uniform in (0, 1), neither end included.
double open_uniform(std::uint64_t bits) {
  return (double(bits >> 12) + 0.5) * 0x1p-52;
}

/// By Box and Muller: std::normal_distribution differs from library to library.
double standard_normal(double u, double v) {
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
}

}  // namespace

std::vector<Index> ordinals_in_pair(const Model& model) {
  std::vector<std::tuple<Index, Index, Index>> pairs;  // smaller end, larger end, bond
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    const auto [smaller, larger] = std::minmax(model.bonds[k].a, model.bonds[k].b);
    pairs.emplace_back(smaller, larger, Index(k));
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<Index> ordinals(model.bonds.size());
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    const auto& [a, b, bond] = pairs[i];
    const auto& [a_before, b_before, before] = pairs[i - 1];
    if (a == a_before && b == b_before) ordinals[std::size_t(bond)] = ordinals[std::size_t(before)] + 1;
  }
  return ordinals;
}

std::uint64_t bond_key(Index seed, Index id_a, Index id_b, Index ordinal) {
  return splitmix64(pair_key(std::uint64_t(seed), id_a, id_b) + std::uint64_t(ordinal));
}

double drawn_strength(BondStrength::Scatter scatter, double given, double spread, std::uint64_t key,
                      std::uint64_t stream) {
  using Scatter = BondStrength::Scatter;
  if (scatter == Scatter::none || spread == 0 || std::isinf(given)) return given;
  std::uint64_t state = splitmix64(key + stream);
  const auto uniform = [&] { return open_uniform(state = splitmix64(state)); };
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const double u = uniform();
    const double strength = scatter == Scatter::normal ? given * (1 + spread * standard_normal(u, uniform()))
                            : scatter == Scatter::uniform ? given + spread * (2 * u - 1)
                                                          : given * std::pow(-std::log(u), 1 / spread);
    if (strength > 0 && std::isfinite(strength)) return strength;
  }
  return not_given;
}

}  // namespace bondstatic
