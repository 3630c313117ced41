// Which columns of a dump of particles mean what (documentation page "dump", attributes of style custom).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "formats/lammps/dump_header.hpp"

namespace bondstatic {

using ThreeColumns = std::optional<std::array<int, 3>>;

/// Positions in DumpHeader::columns, -1 for what is not there.
struct ParticleColumns {
  int id = -1, type = -1, radius = -1, diameter = -1, mass = -1, density = -1;
  std::array<int, 3> position{};
  bool scaled = false;     ///< in parts of the box's edges, from its origin
  bool unwrapped = false;  ///< in the column itself
  ThreeColumns image;      ///< to be added; only where the columns are wrapped
  ThreeColumns velocity, force, angular_velocity, torque;
  std::array<int, 4> quaternion{-1, -1, -1, -1};  ///< w, i, j, k
  bool quaternion_guessed = false;                ///< columns of a compute or fix: only their values can tell
  std::vector<std::string> unused;
};

/// Faults where there are no positions, and where those need a box that is not there.
std::optional<ParticleColumns> particle_columns(const DumpHeader& header, const std::string& file,
                                                std::vector<Fault>& faults);

}  // namespace bondstatic
