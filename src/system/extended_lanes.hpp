// Extended numbers of four links at a time. The same sums of two doubles as dd_real, formed by the same
// error-free transformations (T. J. Dekker, Numer. Math. 18 (1971) 224); where one factor is a plain double,
// as every number of a link is, a product takes half of the operations.
#pragma once

#include "io/wide.hpp"
#include "system/extended.hpp"

namespace bondstatic {

typedef double FourDoubles __attribute__((vector_size(32)));

inline constexpr int links_at_once = 4;

struct FourExtended {
  FourDoubles high, low;

  Extended operator[](int lane) const { return Extended(high[lane], low[lane]); }
};

/// |a| >= |b|, or a = 0
ALWAYS_INLINE FourExtended quick_sum(const FourDoubles& a, const FourDoubles& b) {
  const FourDoubles s = a + b;
  return {s, b - (s - a)};
}

ALWAYS_INLINE FourExtended exact_sum(const FourDoubles& a, const FourDoubles& b) {
  const FourDoubles s = a + b, of_b = s - a;
  return {s, (a - (s - of_b)) + (b - of_b)};
}

ALWAYS_INLINE FourExtended split(const FourDoubles& a) {
  const FourDoubles t = 134217729.0 * a, high = t - (t - a);  // 2^27 + 1
  return {high, a - high};
}

ALWAYS_INLINE FourExtended exact_product(const FourDoubles& a, const FourDoubles& b) {
  const FourDoubles p = a * b;
  const FourExtended x = split(a), y = split(b);
  return {p, ((x.high * y.high - p) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

ALWAYS_INLINE FourExtended operator-(const FourExtended& a) {
  return {-a.high, -a.low};
}
ALWAYS_INLINE FourExtended operator+(const FourExtended& a, const FourExtended& b) {
  const FourExtended s = exact_sum(a.high, b.high);
  return quick_sum(s.high, s.low + (a.low + b.low));
}
ALWAYS_INLINE FourExtended operator-(const FourExtended& a, const FourExtended& b) {
  return a + -b;
}
ALWAYS_INLINE FourExtended operator*(const FourExtended& a, const FourDoubles& b) {
  const FourExtended p = exact_product(a.high, b);
  return quick_sum(p.high, p.low + a.low * b);
}
ALWAYS_INLINE FourExtended operator*(const FourExtended& a, const FourExtended& b) {
  const FourExtended p = exact_product(a.high, b.high);
  return quick_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

/// 1 / a, by one step of Newton's method.
ALWAYS_INLINE FourExtended inverse(const FourExtended& a) {
  const FourDoubles y = 1.0 / a.high;
  const FourExtended left = a * -y + FourExtended{y * 0 + 1, y * 0};
  return quick_sum(y, y * left.high);
}

/// 1 / sqrt(a), likewise.
ALWAYS_INLINE FourExtended inverse_root(const FourExtended& a) {
  FourDoubles y = a.high;
  for (int i = 0; i < links_at_once; ++i) y[i] = 1 / __builtin_sqrt(y[i]);
  const FourExtended left = a * exact_product(y, -y) + FourExtended{y * 0 + 1, y * 0};
  return quick_sum(y, 0.5 * y * left.high);
}

struct FourVectors {
  FourExtended x, y, z;
};
/// Whose entries are plain doubles.
struct FourBranches {
  FourDoubles x, y, z;
};

ALWAYS_INLINE FourVectors operator+(const FourVectors& a, const FourVectors& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
ALWAYS_INLINE FourVectors operator-(const FourVectors& a, const FourVectors& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Factor>
ALWAYS_INLINE FourVectors operator*(const FourVectors& a, const Factor& b) {
  return {a.x * b, a.y * b, a.z * b};
}
ALWAYS_INLINE FourVectors operator*(const FourExtended& a, const FourBranches& b) {
  return {a * b.x, a * b.y, a * b.z};
}
template <class Other>
ALWAYS_INLINE FourExtended dot(const FourVectors& a, const Other& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
ALWAYS_INLINE FourVectors cross(const FourVectors& a, const FourBranches& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace bondstatic
