// Numbers that look random but depend on the seed and the bonded pair alone: the same bond gets the same draw
// whatever the order of bonds, of its ends, or of threads.
#pragma once

#include <algorithm>
#include <cstdint>

#include "bondstatic/types.hpp"

namespace bondstatic {

/// One step of SplitMix64 (Steele, Lea & Flood, OOPSLA 2014).
inline std::uint64_t splitmix64(std::uint64_t state) {
  std::uint64_t z = state + 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

inline std::uint64_t pair_key(std::uint64_t seed, Index id_a, Index id_b) {
  const auto [smaller, larger] = std::minmax(id_a, id_b);
  return splitmix64(splitmix64(splitmix64(seed) + std::uint64_t(smaller)) + std::uint64_t(larger));
}

/// Uniform in [-1, 1); streams of one key are independent.
inline double scatter(std::uint64_t key, std::uint64_t stream) {
  return double(splitmix64(key + stream) >> 11) * 0x1p-52 - 1;
}

}  // namespace bondstatic
