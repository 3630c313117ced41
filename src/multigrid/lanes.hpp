// Eight floats or four doubles to a register, and bodies turned into such lanes: one link, or one body, a
// lane.
//
// A motion or a force of a body is stored as eight numbers, x y z rx ry rz 0 0, so that it is one aligned
// load.
#pragma once

#include <cstdint>

#include "io/wide.hpp"

namespace bondstatic::multigrid {

/// Numbers that a body takes in a vector.
inline constexpr int stride = 8;

/// Links in a pack, bodies in a pack of blocks.
inline constexpr int pack_size = 8;

typedef float WideFloat __attribute__((vector_size(32), may_alias));
typedef double WideDouble __attribute__((vector_size(32), may_alias));

template <class Scalar>
struct WideOf;
template <>
struct WideOf<float> {
  using Type = WideFloat;
};
template <>
struct WideOf<double> {
  using Type = WideDouble;
};
template <class Scalar>
using Wide = typename WideOf<Scalar>::Type;

template <class Scalar>
inline constexpr int lanes = int(32 / sizeof(Scalar));

typedef float EightFloats __attribute__((vector_size(32), aligned(4), may_alias));
typedef float FourFloats __attribute__((vector_size(16), aligned(4), may_alias));
typedef double FourDoubles __attribute__((vector_size(32), aligned(8), may_alias));

/// Numbers of a pack, from any address, in the precision of the arithmetic.
template <class Scalar, class Stored>
ALWAYS_INLINE Wide<Scalar> load(const Stored* at) {
  if constexpr (sizeof(Scalar) == sizeof(float)) {
    return *reinterpret_cast<const EightFloats*>(at);
  } else if constexpr (sizeof(Stored) == sizeof(float)) {
    return __builtin_convertvector(*reinterpret_cast<const FourFloats*>(at), WideDouble);
  } else {
    return *reinterpret_cast<const FourDoubles*>(at);
  }
}

template <class Scalar>
struct Wide3 {
  Wide<Scalar> x, y, z;
};

template <class Scalar>
ALWAYS_INLINE Wide3<Scalar> operator+(const Wide3<Scalar>& a, const Wide3<Scalar>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Scalar>
ALWAYS_INLINE Wide3<Scalar> operator-(const Wide3<Scalar>& a, const Wide3<Scalar>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Scalar>
ALWAYS_INLINE Wide3<Scalar> operator*(const Wide<Scalar>& s, const Wide3<Scalar>& v) {
  return {s * v.x, s * v.y, s * v.z};
}
template <class Scalar>
ALWAYS_INLINE Wide<Scalar> dot(const Wide3<Scalar>& a, const Wide3<Scalar>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Scalar>
ALWAYS_INLINE Wide3<Scalar> cross(const Wide3<Scalar>& a, const Wide3<Scalar>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Scalar, class Stored>
ALWAYS_INLINE Wide3<Scalar> load3(const Stored (&of)[3][pack_size], int lane) {
  return {load<Scalar>(of[0] + lane), load<Scalar>(of[1] + lane), load<Scalar>(of[2] + lane)};
}

/// Motions or forces of as many bodies as there are lanes.
template <class Scalar>
struct Bodies {
  Wide3<Scalar> linear, angular;
};

ALWAYS_INLINE void transpose(Wide<double>& a, Wide<double>& b, Wide<double>& c, Wide<double>& d) {
  const Wide<double> ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6),
                     ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Wide<double> cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6),
                     cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

ALWAYS_INLINE void transpose(Wide<float> (&r)[8]) {
  Wide<float> pairs[8];
  for (int i = 0; i < 8; i += 2) {
    pairs[i] = __builtin_shufflevector(r[i], r[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    pairs[i + 1] = __builtin_shufflevector(r[i], r[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  Wide<float> fours[8];
  for (int i = 0; i < 8; i += 4)
    for (int k = 0; k < 2; ++k) {
      fours[i + 2 * k] = __builtin_shufflevector(pairs[i + k], pairs[i + 2 + k], 0, 1, 8, 9, 4, 5, 12, 13);
      fours[i + 2 * k + 1] =
          __builtin_shufflevector(pairs[i + k], pairs[i + 2 + k], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  for (int i = 0; i < 4; ++i) {
    r[i] = __builtin_shufflevector(fours[i], fours[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    r[i + 4] = __builtin_shufflevector(fours[i], fours[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

ALWAYS_INLINE const Wide<float>& row(const float* values, std::size_t body) {
  return *reinterpret_cast<const Wide<float>*>(values + stride * body);
}
ALWAYS_INLINE const Wide<double>* row(const double* values, std::size_t body) {
  return reinterpret_cast<const Wide<double>*>(values + stride * body);
}

ALWAYS_INLINE Bodies<float> gather(const float* values, const std::uint32_t* body) {
  Wide<float> r[8];
  for (int i = 0; i < 8; ++i) r[i] = row(values, body[i]);
  transpose(r);
  return {{r[0], r[1], r[2]}, {r[3], r[4], r[5]}};
}

ALWAYS_INLINE Bodies<double> gather(const double* values, const std::uint32_t* body) {
  Wide<double> low[4], high[4];
  for (int i = 0; i < 4; ++i) {
    low[i] = row(values, body[i])[0];
    high[i] = row(values, body[i])[1];
  }
  transpose(low[0], low[1], low[2], low[3]);
  transpose(high[0], high[1], high[2], high[3]);
  return {{low[0], low[1], low[2]}, {low[3], high[0], high[1]}};
}

/// Forces of eight bodies, or of four, a row each.
struct FloatRows {
  Wide<float> of[8];
};
ALWAYS_INLINE FloatRows rows(const Bodies<float>& of) {
  FloatRows r = {{of.linear.x, of.linear.y, of.linear.z, of.angular.x, of.angular.y, of.angular.z, {}, {}}};
  transpose(r.of);
  return r;
}
struct DoubleRows {
  Wide<double> low[4], high[4];
};
ALWAYS_INLINE DoubleRows rows(const Bodies<double>& of) {
  DoubleRows r = {{of.linear.x, of.linear.y, of.linear.z, of.angular.x},
                  {of.angular.y, of.angular.z, {}, {}}};
  transpose(r.low[0], r.low[1], r.low[2], r.low[3]);
  transpose(r.high[0], r.high[1], r.high[2], r.high[3]);
  return r;
}

/// Adds each lane to its body, one after another; bodies count from `first`.
ALWAYS_INLINE void scatter_add(const Bodies<float>& of, const std::uint32_t* body, std::size_t first,
                               float* values) {
  const FloatRows r = rows(of);
  for (int i = 0; i < 8; ++i) *reinterpret_cast<Wide<float>*>(values + stride * (body[i] - first)) += r.of[i];
}
ALWAYS_INLINE void scatter_add(const Bodies<double>& of, const std::uint32_t* body, std::size_t first,
                               double* values) {
  const DoubleRows r = rows(of);
  for (int i = 0; i < 4; ++i) {
    auto* to = reinterpret_cast<Wide<double>*>(values + stride * (body[i] - first));
    to[0] += r.low[i];
    to[1] += r.high[i];
  }
}

/// Writes the lanes to bodies one after another.
ALWAYS_INLINE void scatter(const Bodies<float>& of, float* values) {
  const FloatRows r = rows(of);
  for (int i = 0; i < 8; ++i) *reinterpret_cast<Wide<float>*>(values + stride * i) = r.of[i];
}
ALWAYS_INLINE void scatter(const Bodies<double>& of, double* values) {
  const DoubleRows r = rows(of);
  for (int i = 0; i < 4; ++i) {
    auto* to = reinterpret_cast<Wide<double>*>(values + stride * i);
    to[0] = r.low[i];
    to[1] = r.high[i];
  }
}

}  // namespace bondstatic::multigrid
