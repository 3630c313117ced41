// The twelve coefficients of LAMMPS's bond_style bpm/rotational, in their order, under the names of this
// project's bond tables.
//
// Source: BondBPMRotational::coeff in src/BPM/bond_bpm_rotational.cpp, which reads the strength of twisting
// before that of bending; the documentation page bond_bpm_rotational lists these two the other way round.
#pragma once

#include <array>

namespace bondstatic {

inline constexpr std::array<const char*, 12> bpm_rotational_columns{
    "kn",
    "ks",
    "kt",
    "kb",
    "strength_normal",
    "strength_shear",
    "strength_twisting",
    "strength_bending",
    "damping_normal",
    "damping_shear",
    "damping_bending",
    "damping_twisting",
};
inline constexpr std::size_t bpm_rotational_stiffnesses =
    4;  ///< the first ones; a static solve uses no other

}  // namespace bondstatic
