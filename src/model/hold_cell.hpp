// What holds a cell that nothing else does.
#pragma once

#include "bondstatic/model.hpp"

namespace bondstatic {

/// Holds the translation of one particle, the first of the largest connected body: strains move none of the
/// answers with it but displacements, by a constant.
void hold_translation(Model& model);

}  // namespace bondstatic
