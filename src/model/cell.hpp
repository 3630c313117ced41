// A periodic cell's geometry: images, shortest branches, volume, the strains that it can take.
#pragma once

#include <array>
#include <vector>

#include "bondstatic/model.hpp"

namespace bondstatic {

/// How many edges of the cell an image is away, along each of them; zero where the edge is not periodic.
using CellImage = std::array<int, 3>;

inline Vector3 shift_of(const Cell& cell, const CellImage& image) {
  return cell.edges * Vector3(image[0], image[1], image[2]);
}

double volume(const Cell& cell);

/// Distance between the faces that edge i joins.
double height(const Cell& cell, int edge);

/// The image that brings `branch` + shift_of(image) nearest to zero, and how far the others are at least:
/// where their lengths are hardly different, nobody can tell which one is meant.
struct NearestImage {
  CellImage image{};
  double length = 0;
  double next_length = 0;  ///< of no other image is `branch` shorter; infinite where no edge is periodic
};
NearestImage nearest_image(const Cell& cell, const Vector3& branch);

/// How far the end of a bond lies from its particle b where it goes across a periodic face; zero elsewhere.
Vector3 shift_of_end(const Model& model, const Bond& bond);

/// The image that lies in the cell, edges counted from its origin on.
CellImage image_inside(const Cell& cell, const Vector3& position);

/// All images but the one itself of a position in the cell that come as near as `distance` to the cell's
/// inside, faces taken as planes.
std::vector<CellImage> images_within(const Cell& cell, const Vector3& position, double distance);

/// Six independent strains: 1 for the normal ones, engineering shear 1 (component 1/2) for the others; in
/// Voigt's order.
struct UnitStrain {
  const char* name;  ///< "xx", "yy", "zz", "yz", "xz", "xy"
  int row, column;
  Matrix3 value;
};
const std::array<UnitStrain, 6>& unit_strains();

/// The part of a strain that goes along directions in which the cell ends: of nothing but rounding where the
/// strain is one that the periodic edges can take.
double strain_across_ends(const Cell& cell, const Matrix3& strain);

}  // namespace bondstatic
