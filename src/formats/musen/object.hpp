// An object of MUSEN's text export (ETXTCommands in MUSENDefinitions.h; geometries by
// CSphere and CBond::GetObjectGeometryText).
#pragma once

#include <bitset>
#include <limits>
#include <set>
#include <string_view>

#include "formats/musen/line.hpp"

namespace bondstatic {

struct MusenObject {
  enum class Type { sphere = 1, solid_bond = 9, liquid_bond = 13, wall = 14 };

  Index id = 0;
  Type type = Type::sphere;
  std::array<double, 9>
      geometry{};             ///< sphere: radius, contact radius; bonds: two ids, diameter, first length
  std::string_view material;  ///< key, "" where none is given; stands as long as the line
  double active_from = 0, active_to = std::numeric_limits<double>::infinity();

  bool has_state = false;     ///< of the time asked for
  bool has_position = false;  ///< likewise
  double time = 0;
  Vector3 position = Vector3::Zero(), velocity = Vector3::Zero(), angular_velocity = Vector3::Zero(),
          force = Vector3::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< at that time
  Eigen::Quaterniond first_orientation = Eigen::Quaterniond::Identity();

  std::bitset<64> keys;  ///< that the line has
};

/// What stands after the key 0 of a line. The state is that of `wanted_time`, or where that is infinite of
/// the last time of the line; all times are added to `times`. Nothing where something is at fault.
std::optional<MusenObject> read_musen_object(MusenLine& line, double wanted_time, std::set<double>& times);

/// Keys that tell what a file has.
namespace musen_key {
inline constexpr int coordinate = 12, velocity = 15, angular_velocity = 16, force = 20, activity = 24,
                     orientation = 31;
}

}  // namespace bondstatic
