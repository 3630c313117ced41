// MUSEN's "Export as text".
#pragma once

#include "formats/readers.hpp"

namespace bondstatic {

/// Spheres and solid bonds, the latter with kn, ks, kt, kb where the file has the materials:
///
///     kn = E A / L0   ks = G A / L0   kt = 2 G I / L0   kb = E I / L0   contact point in the middle
///
/// with A = pi d^2 / 4, I = pi d^4 / 64, G = E / 2(1 + nu) and the bond's first length L0 (MUSEN,
/// ModelSBElastic.cpp, CSolidBond). Groups are materials. options.step counts time points from 1.
std::optional<ForeignModel> read_musen_text(const std::string& path, const ReadOptions& options,
                                            const Place& named_at, std::vector<Fault>& faults);

/// Orientations are those since the first time point, where there are two or more and MUSEN followed them.
std::optional<ParticleState> read_musen_state(const std::string& path, const ReadOptions& options,
                                              const Place& named_at, std::vector<Fault>& faults);

}  // namespace bondstatic
