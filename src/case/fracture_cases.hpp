// What a run of fracture asks of the bonds and of the load cases that it stays under and scales.
#pragma once

#include "case/draft.hpp"

namespace bondstatic {

/// A fault where no bond can break, at the first block of `bonds`, or `otherwise` where there is none.
void need_strength(Draft& draft, const Node* bonds, const Place& otherwise);

/// Faults where loads or motions belong to pattern and preload both, where the two hold different degrees of
/// freedom, and where the pattern does nothing, or does what has no one load and displacement. `place`: of
/// the pattern's name.
void check_fracture_cases(Draft& draft, const FractureOptions& options, const Place& place);

/// Of d in fracture.hpp: a length, or a pure number (strains, or moments or rotations alone).
Dimension dimension_of_displacement(const Model& model, Index pattern);

}  // namespace bondstatic
