// A scene in MUSEN's text export at one time. All numbers are SI.
#pragma once

#include <bitset>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "formats/readers.hpp"

namespace bondstatic {

struct MusenSphere {
  Index id = 0;
  int line = 0;
  int material = -1;  ///< in material_keys; -1: none
  double radius = 0;
  Vector3 position, velocity, angular_velocity, force;
  Eigen::Quaterniond turned;  ///< since the first time of the file
};

struct MusenBond {
  Index id = 0, a = 0, b = 0;
  int line = 0;
  int material = -1;
  double diameter = 0, length = 0;  ///< when it was made
};

struct MusenMaterial {
  std::string name;
  std::map<Index, double> property;  ///< by MUSEN's numbers, as below
};
namespace musen_property {
inline constexpr Index density = 0, young = 7, normal_strength = 8, tangential_strength = 9, poisson = 10;
}

struct MusenScene {
  double time = 0;
  Index times = 0;  ///< that the file has
  std::vector<MusenSphere> spheres;
  std::vector<MusenBond> bonds;
  Index inactive = 0;                 ///< spheres and bonds that are not active at `time`: removed or broken
  std::map<std::string, Index> left;  ///< lines that were skipped, by what they hold
  std::vector<std::string> material_keys;          ///< that spheres and bonds name
  std::map<std::string, MusenMaterial> materials;  ///< by key
  std::optional<Cell> cell;
  std::bitset<64> sphere_keys;                ///< keys that every sphere has
  std::optional<bool> orientations_followed;  ///< MUSEN's "consider anisotropy"
};

/// "0 17 1 9 5 ...": an object with id, type and geometry.
bool heads_musen_text(const std::vector<std::string_view>& fields);

/// At the last time of the file, or the one of options.step, counted from 1.
std::optional<MusenScene> read_musen_scene(const std::string& path, const ReadOptions& options,
                                           const Place& named_at, std::vector<Fault>& faults);

}  // namespace bondstatic
