// What holds a cell that nothing else does.
#pragma once

#include "bondstatic/model.hpp"

namespace bondstatic {

/// Holds the translation of the first particle of the largest connected body, and of every other one that
/// goes round the cell, bonded to its own images, and so carries a strain by itself. Strains move none of the
/// answers with it but displacements, by a constant in each body.
void hold_translation(Model& model);

}  // namespace bondstatic
