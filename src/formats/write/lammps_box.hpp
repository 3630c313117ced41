// The box of a LAMMPS data file: x along the first edge, y in the plane of the first two, and the tilt
// factors xy, xz, yz (LAMMPS documentation, Howto_triclinic).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bondstatic/model.hpp"

namespace bondstatic {

struct LammpsBox {
  Vector3 low = Vector3::Zero();
  Vector3 high = Vector3::Zero();
  Vector3 tilt = Vector3::Zero();  ///< xy, xz, yz
  std::array<bool, 3> periodic{};

  bool triclinic() const { return tilt != Vector3(Vector3::Zero()); }
  /// Tilted by more than half an edge, which LAMMPS and LIGGGHTS refuse unless told `box tilt large`
  /// (documentation of command box).
  bool large_tilt() const;
  /// "f f p"
  std::string boundary() const;
};

/// The model's cell; where it is not periodic, the box reaches beyond all `places` by `margin`, so that
/// LAMMPS loses no particle. Throws Error (invalid_input) where the cell's edges do not lie as LAMMPS wants
/// them.
LammpsBox lammps_box(const std::optional<Cell>& cell, const std::vector<Vector3>& places, double margin);

}  // namespace bondstatic
