// Twice the precision of double (106 bits, QD's double-double) as an Eigen scalar, the same on every machine.
// With the 64 bits of an x87 long double, one displacement in a thousand would change its last digit with the
// order of a sum somewhere in the factorisation; with 106 none does, unless it is smaller than the largest by
// 10^15.
#pragma once

#include <qd/dd_real.h>

#include <Eigen/Core>

#include "bondstatic/types.hpp"

namespace bondstatic {

using Extended = dd_real;

inline constexpr double extended_rounding = 0x1p-104;

/// What is smaller than this part of the terms that it was formed from is rounding and stands for zero: so
/// that a component that vanishes by symmetry does not carry noise into the results. Far above the rounding
/// of Extended, far below the last digit of a double.
inline constexpr double negligible = 0x1p-85;

}  // namespace bondstatic

template <>
struct Eigen::NumTraits<dd_real> : Eigen::GenericNumTraits<dd_real> {
  using Real = dd_real;
  using NonInteger = dd_real;
  using Literal = dd_real;
  using Nested = dd_real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 20,
    MulCost = 20
  };
  static Real epsilon() { return 0x1p-104; }
  static Real dummy_precision() { return 0x1p-90; }
  static int digits10() { return 31; }
};

template <>
struct Eigen::internal::cast_impl<dd_real, double> {
  static double run(const dd_real& value) { return to_double(value); }
};
