// Where generated particles sit. All ends and counts are as a user counts them: both ends of a line are
// particles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bondstatic/types.hpp"

namespace bondstatic {

/// `count` >= 2 points evenly spaced, both ends included.
std::vector<Vector3> line_points(const Vector3& from, const Vector3& to, Index count);

/// from, from + step, ...
std::vector<Vector3> stepped_points(const Vector3& from, const Vector3& step, Index count);

/// Arc of a circle, or of a helix where pitch is not zero.
struct Arc {
  Vector3 centre = Vector3::Zero();  ///< of the circle through the first point
  double radius = 0;
  Vector3 axis = Vector3::UnitZ();  ///< unit vector; positive angles turn right-handed about it
  Vector3 start = Vector3::Zero();  ///< direction of the first point, made normal to the axis; zero: any
  double angle = 0;                 ///< from the first to the last point, radians
  double pitch = 0;                 ///< advance along the axis for a full turn
  Index count = 0;

  /// One full turn without pitch, whose last point would fall on the first.
  bool closed() const;
  /// `start` leaves no direction normal to the axis.
  bool start_along_axis() const;
};

/// Evenly spaced, both ends included; a closed circle leaves its last point out: count points 2 pi / count
/// apart.
std::vector<Vector3> arc_points(const Arc& arc);

enum class LatticeKind { simple_cubic, bcc, fcc };

/// Points of one conventional cell: 1, 2 or 4.
Index points_per_cell(LatticeKind kind);

/// count[0] x count[1] x count[2] conventional cells of edge `spacing`, the lattice constant a: a simple
/// cubic count is that of the particles; nearest neighbours are a, a sqrt(3)/2 (bcc), a/sqrt(2) (fcc) apart.
/// x runs fastest.
std::vector<Vector3> lattice_points(LatticeKind kind, const std::array<Index, 3>& count, double spacing,
                                    const Vector3& origin);

/// Moves each coordinate of point i by a uniform number in [-most[i], most[i]].
void jitter(std::span<Vector3> points, std::span<const double> most, std::uint64_t seed);

/// Ascending positions of what stays when round(fraction * count) of `count`, drawn at random, are removed.
std::vector<Index> survivors(Index count, double fraction, std::uint64_t seed);

}  // namespace bondstatic
