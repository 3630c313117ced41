#include "model/cell.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace bondstatic {

double volume(const Cell& cell) {
  return std::abs(cell.edges.determinant());
}

double height(const Cell& cell, int edge) {
  const Vector3 normal = cell.edges.col((edge + 1) % 3).cross(cell.edges.col((edge + 2) % 3));
  return volume(cell) / normal.norm();
}

namespace {

// Row i: the coordinate along edge i of what lies in the span of the periodic edges; zero where edge i is not
// one of them. Directions across that span take the other edges' places, so that the inverse's rows are the
// pseudo-inverse's.
Matrix3 coordinates_along_periodic_edges(const Cell& cell) {
  Matrix3 basis = cell.edges;
  auto known = std::count(cell.periodic.begin(), cell.periodic.end(), true);
  if (known == 0) return Matrix3::Zero();
  for (int i = 0; i < 3; ++i) {
    if (cell.periodic[std::size_t(i)]) continue;
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (known++ == 1)
      basis.col(i) = basis.col(cell.periodic[std::size_t(j)] ? j : k).unitOrthogonal();
    else
      basis.col(i) = basis.col(j).cross(basis.col(k)).normalized();
  }
  Matrix3 coordinates = basis.inverse();
  for (int i = 0; i < 3; ++i)
    if (!cell.periodic[std::size_t(i)]) coordinates.row(i).setZero();
  return coordinates;
}

}  // namespace

NearestImage nearest_image(const Cell& cell, const Vector3& branch) {
  NearestImage nearest{{}, branch.norm(), std::numeric_limits<double>::infinity()};
  // Coordinates along the periodic edges of what lies in their span, rounded, come near; in a skewed cell
  // the nearest is one of those around.
  const Matrix3 coordinates = coordinates_along_periodic_edges(cell);
  const Vector3 steepness = coordinates.rowwise().norm();
  if (!(steepness.maxCoeff() > 0)) return nearest;
  const Vector3 along = coordinates * branch;
  CellImage start{};
  for (int i = 0; i < 3; ++i) start[std::size_t(i)] = -int(std::lround(along[i]));
  const auto length_of = [&](const CellImage& image) { return (branch + shift_of(cell, image)).norm(); };
  // No two images are nearer to each other than the faces that an edge joins.
  const double apart = 1 / steepness.maxCoeff();
  if (const double length = length_of(start); length < apart / 2) return {start, length, apart - length};

  // What lies in the span is at most half the edges' lengths together away from the nearest image, and that
  // and one edge from the next.
  double half_way = 0, shortest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (!cell.periodic[std::size_t(i)]) continue;
    half_way += cell.edges.col(i).norm() / 2;
    shortest = std::min(shortest, cell.edges.col(i).norm());
  }
  std::array<int, 3> most{};
  for (std::size_t i = 0; i < 3; ++i)
    if (cell.periodic[i]) most[i] = 1 + int((half_way + shortest) * steepness[Index(i)]);
  nearest.length = std::numeric_limits<double>::infinity();
  for (int i = -most[0]; i <= most[0]; ++i)
    for (int j = -most[1]; j <= most[1]; ++j)
      for (int k = -most[2]; k <= most[2]; ++k) {
        const CellImage image{start[0] + i, start[1] + j, start[2] + k};
        const double length = length_of(image);
        if (length < nearest.length) {
          nearest.next_length = nearest.length;
          nearest.length = length;
          nearest.image = image;
        } else {
          nearest.next_length = std::min(nearest.next_length, length);
        }
      }
  return nearest;
}

Vector3 shift_of_end(const Model& model, const Bond& bond) {
  if (!model.cell) return Vector3::Zero();
  const auto at = [&](Index p) -> const Vector3& { return model.particles[std::size_t(p)].position; };
  const Vector3 shift = bond.branch - (at(bond.b) - at(bond.a));
  return shift.norm() > 1e-6 * bond.branch.norm() ? shift : Vector3(Vector3::Zero());
}

CellImage image_inside(const Cell& cell, const Vector3& position) {
  const Vector3 along = cell.edges.partialPivLu().solve(position - cell.origin);
  CellImage image{};
  for (std::size_t i = 0; i < 3; ++i)
    if (cell.periodic[i]) image[i] = -int(std::floor(along[Index(i)]));
  return image;
}

std::vector<CellImage> images_within(const Cell& cell, const Vector3& position, double distance) {
  const Vector3 along = cell.edges.partialPivLu().solve(position - cell.origin);
  std::array<int, 3> low{}, high{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!cell.periodic[i]) continue;
    // A little wider, so that rounding leaves nothing out.
    const double reach = distance / height(cell, int(i)) * (1 + 1e-9) + 1e-9;
    low[i] = int(std::ceil(-reach - along[Index(i)]));
    high[i] = int(std::floor(1 + reach - along[Index(i)]));
  }
  std::vector<CellImage> images;
  for (int i = low[0]; i <= high[0]; ++i)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int k = low[2]; k <= high[2]; ++k)
        if (i != 0 || j != 0 || k != 0) images.push_back({i, j, k});
  return images;
}

const std::array<UnitStrain, 6>& unit_strains() {
  static const std::array<UnitStrain, 6> strains = [] {
    std::array<UnitStrain, 6> all{{{"xx", 0, 0, {}},
                                   {"yy", 1, 1, {}},
                                   {"zz", 2, 2, {}},
                                   {"yz", 1, 2, {}},
                                   {"xz", 0, 2, {}},
                                   {"xy", 0, 1, {}}}};
    for (UnitStrain& one : all) {
      one.value.setZero();
      one.value(one.row, one.column) += 0.5;
      one.value(one.column, one.row) += 0.5;
    }
    return all;
  }();
  return strains;
}

double strain_across_ends(const Cell& cell, const Matrix3& strain) {
  // Onto the span of the periodic edges, by Gram and Schmidt.
  Matrix3 onto = Matrix3::Zero();
  for (int i = 0; i < 3; ++i) {
    if (!cell.periodic[std::size_t(i)]) continue;
    const Vector3 edge = cell.edges.col(i), rest = edge - onto * edge, unit = rest.normalized();
    onto += unit * unit.transpose();
  }
  return (strain - onto * strain * onto).cwiseAbs().maxCoeff();
}

}  // namespace bondstatic
