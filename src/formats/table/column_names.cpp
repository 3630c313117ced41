#include "formats/table/column_names.hpp"

#include <algorithm>

namespace bondstatic {
namespace {

constexpr std::string_view blank = " \t";

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blank), text.size()));
  while (!text.empty() && blank.find(text.back()) != std::string_view::npos) text.remove_suffix(1);
  return text;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Without "Q05 :", which numbers a query of EDEM.
std::string_view without_query_number(std::string_view text) {
  if (text.size() < 2 || (text[0] != 'Q' && text[0] != 'q') || !is_digit(text[1])) return text;
  std::size_t at = 1;
  while (at < text.size() && is_digit(text[at])) ++at;
  const std::string_view rest = trimmed(text.substr(at));
  return rest.starts_with(':') ? trimmed(rest.substr(1)) : text;
}

/// Words in lower case, joined by _; "posX" is not two words, as nobody writes it in two ways.
std::string joined_words(std::string_view text) {
  std::string name;
  for (const char c : text) {
    const bool letter = (c >= 'a' && c <= 'z') || is_digit(c) || (unsigned char)(c) >= 0x80;
    if (c >= 'A' && c <= 'Z')
      name += char(c - 'A' + 'a');
    else if (letter)
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (name.ends_with('_')) name.pop_back();
  return name;
}

/// The same for x, y and z: the names with * replaced.
std::vector<Aliases> per_axis(const std::vector<std::string>& patterns) {
  std::vector<Aliases> axes;
  for (const char axis : {'x', 'y', 'z'}) {
    Aliases names = patterns;
    for (std::string& name : names) name.replace(name.find('*'), 1, 1, axis);
    axes.push_back(std::move(names));
  }
  return axes;
}

Aliases with(Aliases names, const Aliases& others) {
  names.insert(names.end(), others.begin(), others.end());
  return names;
}

Aliases own_position(char axis) {
  const std::string a(1, axis);
  return {a, "pos_" + a, "pos" + a, "position_" + a, "p" + a, a + "0"};
}

Aliases other_position(char axis) {
  // ParaView's spreadsheets number the components from 0.
  const std::string a(1, axis), number(1, char('0' + (axis - 'x')));
  return {"particle_position_" + a,
          a + "_position",
          "coordinate_" + a,
          a + "_coordinate",
          "coord_" + a,
          "center_" + a,
          "centre_" + a,
          "points_" + number};
}

}  // namespace

ColumnName column_name(std::string_view text) {
  ColumnName column;
  text = trimmed(text);
  column.text = text;
  text = without_query_number(text);
  while (text.ends_with(':')) text = trimmed(text.substr(0, text.size() - 1));
  const char opening = text.ends_with(')') ? '(' : text.ends_with(']') ? '[' : '\0';
  const std::size_t open = opening ? text.rfind(opening) : std::string_view::npos;
  if (open != std::string_view::npos && open > 0) {
    column.unit = trimmed(text.substr(open + 1, text.size() - open - 2));
    text = text.substr(0, open);
  }
  column.name = joined_words(text);
  return column;
}

bool among(const std::string& name, const Aliases& aliases) {
  return std::find(aliases.begin(), aliases.end(), name) != aliases.end();
}

namespace own_columns {

const Aliases x = own_position('x'), y = own_position('y'), z = own_position('z');
const Aliases particle_id{"id", "particle_id", "particle", "pid", "number"};
const Aliases radius{"radius", "r", "rad", "radii"};
const Aliases diameter{"diameter", "d", "diam"};
const Aliases density{"density", "rho"};
const Aliases group{"group"};
const Aliases bond_id{"id", "bond_id"};
const Aliases bond_a{"a", "id_a", "id1", "particle_a"};
const Aliases bond_b{"b", "id_b", "id2", "particle_b"};
const Aliases contact_point{"contact_point"};

}  // namespace own_columns

namespace columns {

const Aliases x = with(own_columns::x, other_position('x'));
const Aliases y = with(own_columns::y, other_position('y'));
const Aliases z = with(own_columns::z, other_position('z'));
const Aliases particle_id = with(own_columns::particle_id, {"ball_id", "body_id", "atom_id"});
const Aliases radius = with(own_columns::radius, {"ball_radius", "particle_radius", "physical_radius"});
const Aliases diameter = with(own_columns::diameter, {"particle_diameter"});
const Aliases volume{"volume", "particle_volume"};
const Aliases mass{"mass", "m", "particle_mass"};
const Aliases density = with(own_columns::density, {"particle_density"});
const Aliases group = own_columns::group;
const Aliases kind{"material",          "material_id", "mat_id",  "matid",
                   "particle_material", "type",        "type_id", "particle_type"};

const std::vector<Aliases> displacement =
    per_axis({"u*", "disp_*", "displacement_*", "particle_displacement_*"});
const std::vector<Aliases> rotation = per_axis({"r*", "rot_*", "rotation_*"});
const std::vector<Aliases> velocity =
    per_axis({"v*", "vel_*", "vel*", "velocity_*", "particle_velocity_*", "*_velocity"});
const std::vector<Aliases> angular_velocity =
    per_axis({"w*", "omega*", "omega_*", "ang_vel_*", "angvel_*", "spin_*", "angular_velocity_*",
              "particle_angular_velocity_*"});
const std::vector<Aliases> force =
    per_axis({"f*", "force_*", "force*", "total_force_*", "particle_force_*", "particle_total_force_*"});
const std::vector<Aliases> torque = per_axis(
    {"t*", "tq*", "torque_*", "torque*", "moment_*", "particle_torque_*", "particle_total_torque_*"});
// q0 is the scalar part where the components are numbered (MUSEN, PFC).
const std::vector<Aliases> quaternion{{"qw", "quat_w", "quatw", "orientation_w", "ori_w", "q0"},
                                      {"qx", "quat_x", "quatx", "orientation_x", "ori_x", "q1"},
                                      {"qy", "quat_y", "quaty", "orientation_y", "ori_y", "q2"},
                                      {"qz", "quat_z", "quatz", "orientation_z", "ori_z", "q3"}};

const Aliases bond_id = with(own_columns::bond_id, {"contact_id"});
// IDfirst and IDsecond are the custom properties in which an EDEM contact model keeps the particle ids.
const Aliases bond_a = with(
    own_columns::bond_a, {"id_1", "i", "end1", "end1_id", "particle_1", "particle1", "ball1", "ball_1",
                          "atom1", "body1", "first_id", "idfirst", "id_first", "element_1", "contact_idfirst",
                          "particle_id_1", "first_particle_id", "bond_idfirst", "particle_1_id"});
const Aliases bond_b =
    with(own_columns::bond_b,
         {"id_2", "j", "end2", "end2_id", "particle_2", "particle2", "ball2", "ball_2", "atom2", "body2",
          "second_id", "idsecond", "id_second", "element_2", "contact_idsecond", "particle_id_2",
          "second_particle_id", "bond_idsecond", "particle_2_id"});
const Aliases bond_type{"type", "bond_type"};
const Aliases bond_radius{"radius", "bond_radius", "r", "pb_radius", "disk_radius", "bonded_disk_radius"};
const Aliases bond_diameter{"diameter", "bond_diameter"};
const Aliases contact_point = with(own_columns::contact_point, {"contact_fraction"});
const Aliases kn{"kn"}, ks{"ks"}, kt{"kt"}, kb{"kb"};
const Aliases normal_stiffness{"normal_stiffness",
                               "bond_normal_stiffness",
                               "normal_stiffness_per_unit_area",
                               "bond_normal_stiffness_per_unit_area",
                               "pb_kn",
                               "sn"};
const Aliases shear_stiffness{"shear_stiffness",
                              "bond_shear_stiffness",
                              "shear_stiffness_per_unit_area",
                              "bond_shear_stiffness_per_unit_area",
                              "tangential_stiffness",
                              "bond_tangential_stiffness",
                              "tangential_stiffness_per_unit_area",
                              "bond_tangential_stiffness_per_unit_area",
                              "pb_ks",
                              "st"};

}  // namespace columns
}  // namespace bondstatic
