#include "formats/musen/object.hpp"

#include <fmt/format.h>

#include <cmath>

namespace bondstatic {
namespace {

constexpr int type_key = 1, time_key = 2, geometry_key = 5, material_key = 23;

/// How many numbers follow a key that is not of use here; 0: no object has it.
int numbers_after(int key) {
  switch (key) {
    case 10:  // accelerations and angles, of old versions
    case 11:
    case 17:
    case 42:  // principal stresses
    case 45:  // tangential overlap
      return 3;
    case 18:  // force amplitude
    case 37:  // temperature
    case 43:  // torque
      return 1;
    case 36:  // stress
    case 44:  // corners of a wall
      return 9;
    default:
      return 0;
  }
}

bool read_type(MusenLine& line, MusenObject& object) {
  const auto type = line.whole("the type of the object");
  if (!type) return false;
  object.type = MusenObject::Type(*type);
  if (*type == 1 || *type == 9 || *type == 13 || *type == 14) return true;
  line.fault(fmt::format(
      "type {} of an object is unknown: 1 is a sphere, 9 a solid bond, 13 a liquid bond, 14 a wall", *type));
  return false;
}

bool read_geometry(MusenLine& line, MusenObject& object) {
  if (!object.keys.test(type_key)) {
    line.fault("the geometry stands before the type of the object");
    return false;
  }
  const int count = object.type == MusenObject::Type::sphere ? 2
                    : object.type == MusenObject::Type::wall ? 0
                                                             : 4;
  const auto numbers = line.numbers(count);
  if (numbers) object.geometry = *numbers;
  return numbers.has_value();
}

bool read_time(MusenLine& line, double wanted_time, std::set<double>& times, MusenObject& object,
               bool& wanted) {
  const auto time = line.numbers(1);
  if (!time) return false;
  times.insert((*time)[0]);
  wanted = std::isinf(wanted_time) || (*time)[0] == wanted_time;
  if (wanted) {
    object.time = (*time)[0];
    object.has_state = true;
    object.has_position = false;
  }
  return true;
}

bool read_orientation(MusenLine& line, MusenObject& object, bool wanted) {
  const auto q = line.numbers(4);
  if (!q) return false;
  const Eigen::Quaterniond orientation((*q)[0], (*q)[1], (*q)[2], (*q)[3]);
  const double norm = orientation.norm();
  if (norm != 0 && !(std::abs(norm - 1) <= 1e-2)) {  // all zero: not known
    line.fault(fmt::format("the quaternion has the norm {}, which must be 1", norm));
    return false;
  }
  if (!object.keys.test(musen_key::orientation)) object.first_orientation = orientation;
  if (wanted) object.orientation = orientation;
  return true;
}

}  // namespace

std::optional<MusenObject> read_musen_object(MusenLine& line, double wanted_time, std::set<double>& times) {
  MusenObject object;
  const auto id = line.whole("the id of the object");
  if (!id) return std::nullopt;
  object.id = *id;
  bool wanted = false;  // whether the state that is read is that of the time asked for
  Vector3 ignored;
  while (!line.at_end()) {
    const auto read_key = line.whole("the key");
    if (!read_key) return std::nullopt;
    const int key = int(std::min<Index>(*read_key, 1000));
    bool sound = true;
    if (key == type_key) {
      sound = read_type(line, object);
    } else if (key == geometry_key) {
      sound = read_geometry(line, object);
    } else if (key == material_key) {
      if (line.at_end()) return line.numbers(1), std::nullopt;
      object.material = line.next_text();
    } else if (key == musen_key::activity) {
      const auto interval = line.numbers(2);
      if (!interval) return std::nullopt;
      object.active_from = (*interval)[0];
      object.active_to = (*interval)[1];
    } else if (key == time_key) {
      sound = read_time(line, wanted_time, times, object, wanted);
    } else if (key == musen_key::coordinate) {
      sound = line.vector(wanted ? object.position : ignored);
      object.has_position |= wanted;
    } else if (key == musen_key::velocity) {
      sound = line.vector(wanted ? object.velocity : ignored);
    } else if (key == musen_key::angular_velocity) {
      sound = line.vector(wanted ? object.angular_velocity : ignored);
    } else if (key == musen_key::force) {
      sound = line.vector(wanted ? object.force : ignored);
    } else if (key == musen_key::orientation) {
      sound = read_orientation(line, object, wanted);
    } else if (const int count = numbers_after(key); count > 0) {
      sound = line.numbers(count).has_value();
    } else {
      line.fault(fmt::format("{} names nothing of an object", *read_key));
      sound = false;
    }
    if (!sound) return std::nullopt;
    object.keys.set(std::size_t(key));
  }
  if (object.keys.test(type_key) && object.keys.test(geometry_key)) return object;
  line.fault(fmt::format("object {} has no {}", object.id, object.keys.test(type_key) ? "geometry" : "type"));
  return std::nullopt;
}

}  // namespace bondstatic
