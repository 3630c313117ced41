// How isotropic_fit() changes with the stiffness: its derivatives, component by component.
#pragma once

#include <optional>

#include "bondstatic/types.hpp"

namespace bondstatic {

Matrix6 isotropic_young_slope(const Matrix6& stiffness);
Matrix6 isotropic_poisson_slope(const Matrix6& stiffness);

/// Nothing where the stiffness is isotropic to eight digits: the misfit is then made of rounding.
std::optional<Matrix6> isotropic_misfit_slope(const Matrix6& stiffness);

}  // namespace bondstatic
