#include "model/cell.hpp"

#include <Eigen/QR>
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

NearestImage nearest_image(const Cell& cell, const Vector3& branch) {
  // Coordinates along the periodic edges of what lies in their span, rounded, come near; in a skewed cell
  // the nearest is one of those around.
  std::vector<int> edge;
  for (int i = 0; i < 3; ++i)
    if (cell.periodic[std::size_t(i)]) edge.push_back(i);
  const Eigen::MatrixXd edges = cell.edges(Eigen::all, edge);
  const Eigen::MatrixXd inverse = edges.completeOrthogonalDecomposition().pseudoInverse();
  const Eigen::VectorXd along = inverse * branch;
  NearestImage nearest{{}, branch.norm(), std::numeric_limits<double>::infinity()};
  if (edge.empty()) return nearest;
  CellImage start{};
  for (std::size_t e = 0; e < edge.size(); ++e)
    start[std::size_t(edge[e])] = -int(std::lround(along[Index(e)]));
  const auto length_of = [&](const CellImage& image) { return (branch + shift_of(cell, image)).norm(); };
  // No two images are nearer to each other than the faces that an edge joins.
  const double apart = 1 / inverse.rowwise().norm().maxCoeff();
  if (const double length = length_of(start); length < apart / 2) return {start, length, apart - length};

  // What lies in the span is at most half the edges' lengths together away from the nearest image, and that
  // and one edge from the next.
  const double reach = edges.colwise().norm().sum() / 2 + edges.colwise().norm().minCoeff();
  std::array<int, 3> most{};
  for (std::size_t e = 0; e < edge.size(); ++e)
    most[std::size_t(edge[e])] = 1 + int(reach * inverse.row(Index(e)).norm());
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
