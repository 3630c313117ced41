// A number and its derivative by one parameter, carried forward through a formula by the chain rule: exact to
// rounding. Laws write their formula once, over the scalar type.
//
// Of its own, and not Eigen's AutoDiffScalar: that one divides by the square of the denominator, which leaves
// the range of doubles long before the quotient does, and its expressions do not survive `auto`.
#pragma once

namespace bondstatic {

struct Dual {
  double value = 0;
  double slope = 0;  ///< d(value)/d(parameter)

  constexpr Dual(double number = 0, double change = 0) : value(number), slope(change) {}

  /// Lets the slope go: for what a formula looks up or asks, not for what it computes with.
  explicit constexpr operator double() const { return value; }

  friend constexpr Dual operator+(Dual x, Dual y) { return {x.value + y.value, x.slope + y.slope}; }
  friend constexpr Dual operator-(Dual x, Dual y) { return {x.value - y.value, x.slope - y.slope}; }
  friend constexpr Dual operator-(Dual x) { return {-x.value, -x.slope}; }
  friend constexpr Dual operator*(Dual x, Dual y) {
    return {x.value * y.value, x.slope * y.value + x.value * y.slope};
  }
  friend constexpr Dual operator/(Dual x, Dual y) {
    const double quotient = x.value / y.value;
    return {quotient, (x.slope - quotient * y.slope) / y.value};
  }
  friend constexpr bool operator<(Dual x, Dual y) { return x.value < y.value; }
  friend constexpr bool operator>(Dual x, Dual y) { return x.value > y.value; }
};

}  // namespace bondstatic
