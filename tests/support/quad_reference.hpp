// An independent route to the displacement: dense, in quadruple precision (113 bits), from the element
// written out in the bond's own axes. It shares with the program only the properties that a law gives (C in
// double).
#pragma once

#include <vector>

#include "bondstatic/model.hpp"

namespace bondstatic::test {

/// Displacement of every particle in load case `load_case`; for models of some hundred unknowns.
std::vector<Vector6T<long double>> quad_displacement(const Model& model, Index load_case = 0);

}  // namespace bondstatic::test
