// An answer with numbers everywhere, made by hand, and the same one moved a little along another: what a
// derivative with respect to the state is tested with.
#pragma once

#include <random>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/sensitivity.hpp"
#include "bondstatic/statics.hpp"

namespace bondstatic::test {

/// An answer, and the section radii that its stresses are taken at. What follows from other fields
/// (normal_force ... tau, work, the effective stiffness) is filled in by settle().
struct AnswerWithSections {
  StaticSolution solution;
  std::vector<BondProperties> properties;
};

/// Random in all fields, about 1, displacements stretched along all axes; six load cases whose strains are
/// independent. The particle `left_out` is left out of all but the first load case.
AnswerWithSections random_answer(const Model& model, std::mt19937_64& random, Index left_out);

/// answer + step * direction, field by field.
AnswerWithSections moved(const Model& model, const AnswerWithSections& answer,
                         const AnswerWithSections& direction, double step);

/// What the functionals say that the change along `direction` is, and the sum of the magnitudes of its parts.
struct Change {
  double value = 0, magnitude = 0;
};
Change applied(const Functionals& functionals, const AnswerWithSections& direction);

}  // namespace bondstatic::test
