// Particles by what is done to them: those with the same supports and loads share an atom type, so that the
// deck can name them in groups.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "formats/write/export_formats.hpp"

namespace bondstatic {

struct LammpsRole {
  std::uint8_t held = 0;  ///< bit i: degree of freedom i is prescribed; all six where left out
  bool left_out = false;  ///< of the static answer: nothing supports it
  bool loaded = false;
  Vector6 load = Vector6::Zero();  ///< on each; zero where loads are told particle by particle
  Index particles = 0;

  bool held_altogether() const { return held == 0b111111; }
  bool holds_all_rotations() const { return (held >> 3) == 0b111; }
  /// "free", "all held", "x y held", with "loaded" behind it.
  std::string text() const;
};

struct LammpsRoles {
  std::vector<LammpsRole> roles;    ///< role of type t is roles[t - 1]
  std::vector<int> type;            ///< of each particle, from 1
  std::vector<Vector6> load;        ///< of each particle
  std::vector<Vector6> prescribed;  ///< motion of each particle where it is held
  bool loads_by_particle = false;   ///< too many distinct ones for a group each
};

LammpsRoles lammps_roles(const ExportInput& input);

}  // namespace bondstatic
