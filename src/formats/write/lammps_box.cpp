#include "formats/write/lammps_box.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

/// Edges along the axes where nothing says otherwise.
Matrix3 edges_of(const std::optional<Cell>& cell) {
  return cell ? cell->edges : Matrix3(Matrix3::Identity());
}

void refuse_other_edges(const Matrix3& edges) {
  // Column i is edge i: below the diagonal nothing, on it positive lengths.
  const double rounding = 1e-12 * edges.cwiseAbs().maxCoeff();
  const double below = std::max({std::abs(edges(1, 0)), std::abs(edges(2, 0)), std::abs(edges(2, 1))});
  if (below <= rounding && edges.diagonal().minCoeff() > 0) return;
  throw Error(
      ExitCode::invalid_input,
      fmt::format("the cell's edges are ({}, {}, {}), ({}, {}, {}), ({}, {}, {}); LAMMPS takes the first "
                  "along +x, the second in the xy plane with y > 0, the third with z > 0\n    cure: "
                  "turn the model so that its cell lies that way",
                  edges(0, 0), edges(1, 0), edges(2, 0), edges(0, 1), edges(1, 1), edges(2, 1), edges(0, 2),
                  edges(1, 2), edges(2, 2)));
}

}  // namespace

bool LammpsBox::large_tilt() const {
  const Vector3 half = 0.5 * (high - low);
  return std::abs(tilt[0]) > half[0] || std::abs(tilt[1]) > half[0] || std::abs(tilt[2]) > half[1];
}

std::string LammpsBox::boundary() const {
  std::string text;
  for (const bool repeats : periodic) text += std::string(text.empty() ? "" : " ") + (repeats ? "p" : "f");
  return text;
}

LammpsBox lammps_box(const std::optional<Cell>& cell, const std::vector<Vector3>& places, double margin) {
  const Matrix3 edges = edges_of(cell);
  refuse_other_edges(edges);
  LammpsBox box;
  if (cell) box.periodic = cell->periodic;
  const Vector3 corner = cell ? cell->origin : Vector3(Vector3::Zero());
  Vector3 origin = corner;
  Matrix3 sides = edges;
  const Matrix3 inverse = edges.inverse();
  for (int i = 0; i < 3; ++i) {
    if (box.periodic[std::size_t(i)]) continue;
    // Along an edge where nothing repeats, the box may begin and end anywhere: in parts of that edge.
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for (const Vector3& place : places) {
      const double part = inverse.row(i).dot(place - corner);
      first = std::min(first, part);
      last = std::max(last, part);
    }
    const double beyond = margin * inverse.row(i).norm();  // the margin is measured across the face
    origin += (first - beyond) * edges.col(i);
    sides.col(i) = (last - first + 2 * beyond) * edges.col(i);
  }
  box.low = origin;
  box.high = origin + sides.diagonal();
  box.tilt = {sides(0, 1), sides(0, 2), sides(1, 2)};
  return box;
}

}  // namespace bondstatic
