// What the columns of tables are called: in this project, in EDEM's exports, in PFC's, YADE's and LAMMPS's
// listings and in ParaView's spreadsheets.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bondstatic {

/// A heading taken apart: "Q05 : Particle Position X (mm):" is "particle_position_x" in "mm".
struct ColumnName {
  std::string text;  ///< as the file has it
  std::string name;  ///< lower case, words joined by _, without unit and the number of an EDEM query
  std::string unit;  ///< what stands in (..) or [..] at its end; empty where nothing does
};
ColumnName column_name(std::string_view text);

/// All names of one column, in the form of ColumnName::name; the first is this project's own.
using Aliases = std::vector<std::string>;

/// What a case's own tables may call them, in any letter case (case/particle_file.hpp, case/bond_table.hpp).
/// Fewer, as such tables have nothing that is to be converted: neither units nor stiffnesses per area.
namespace own_columns {

extern const Aliases x, y, z, particle_id, radius, diameter, density, group;
extern const Aliases bond_id, bond_a, bond_b, contact_point;

}  // namespace own_columns

/// What tables of any origin may; own_columns among them.
namespace columns {

extern const Aliases x, y, z;
extern const Aliases particle_id, radius, diameter, volume, mass, density;
extern const Aliases group;  ///< that only: what a [[particles]] file calls so
extern const Aliases kind;   ///< material or type, taken as group where no column `group` is there
extern const std::vector<Aliases> displacement, rotation;  ///< x, y, z
extern const std::vector<Aliases> velocity, angular_velocity, force, torque;
extern const std::vector<Aliases> quaternion;  ///< w, x, y, z

extern const Aliases bond_id, bond_a, bond_b, bond_type, bond_radius, bond_diameter, contact_point;
extern const Aliases kn, ks, kt, kb;
extern const Aliases normal_stiffness, shear_stiffness;  ///< of a bond per area of its section

}  // namespace columns

bool among(const std::string& name, const Aliases& aliases);

}  // namespace bondstatic
