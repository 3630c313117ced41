#include "formats/lammps/columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/nearest_name.hpp"

namespace bondstatic {
namespace {

class Names {
 public:
  explicit Names(const DumpHeader& header) : names_(header.columns), used_(names_.size(), false) {}

  int take(const std::string& name) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) return -1;
    const auto at = std::size_t(found - names_.begin());
    used_[at] = true;
    return int(at);
  }

  /// All of them or none.
  template <std::size_t N>
  std::optional<std::array<int, N>> take_all(const std::array<std::string, N>& names) {
    for (const std::string& name : names)
      if (std::find(names_.begin(), names_.end(), name) == names_.end()) return std::nullopt;
    std::array<int, N> columns;
    for (std::size_t i = 0; i < N; ++i) columns[i] = take(names[i]);
    return columns;
  }

  /// c_NAME[1] ... c_NAME[4] in a row and no c_NAME[5], or f_NAME likewise, not used for anything else.
  std::optional<std::array<int, 4>> four_of_a_compute() {
    for (std::size_t at = 0; at + 4 <= names_.size(); ++at) {
      const std::string& first = names_[at];
      if (!(first.starts_with("c_") || first.starts_with("f_")) || !first.ends_with("[1]") || used_[at])
        continue;
      const std::string base = first.substr(0, first.size() - 3);
      std::array<std::string, 4> group;
      bool in_a_row = at + 4 == names_.size() || names_[at + 4] != base + "[5]";
      for (std::size_t i = 0; i < 4; ++i) {
        group[i] = fmt::format("{}[{}]", base, i + 1);
        in_a_row = in_a_row && names_[at + i] == group[i];
      }
      if (in_a_row) return take_all(group);
    }
    return std::nullopt;
  }

  std::vector<std::string> unused() const {
    std::vector<std::string> left;
    for (std::size_t i = 0; i < names_.size(); ++i)
      if (!used_[i]) left.push_back(names_[i]);
    return left;
  }

 private:
  const std::vector<std::string>& names_;
  std::vector<bool> used_;
};

}  // namespace

std::optional<ParticleColumns> particle_columns(const DumpHeader& header, const std::string& file,
                                                std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  const Place place{file, header.columns_line, 1};
  Names names(header);
  ParticleColumns found;
  found.id = names.take("id");
  found.type = names.take("type");
  found.radius = names.take("radius");
  found.diameter = names.take("diameter");
  found.mass = names.take("mass");
  found.density = names.take("density");

  const auto plain = names.take_all<3>({"x", "y", "z"}), scaled = names.take_all<3>({"xs", "ys", "zs"});
  const auto unwrapped = names.take_all<3>({"xu", "yu", "zu"});
  const auto scaled_unwrapped = names.take_all<3>({"xsu", "ysu", "zsu"});
  const auto image = names.take_all<3>({"ix", "iy", "iz"});
  found.unwrapped = unwrapped || scaled_unwrapped;
  if (!found.unwrapped) found.image = image;
  const auto position = unwrapped ? unwrapped : scaled_unwrapped ? scaled_unwrapped : plain ? plain : scaled;
  found.scaled = position && position != unwrapped && position != plain;
  if (position)
    found.position = *position;
  else
    faults.push_back({place, "the dump has no positions; its columns are " + name_list(header.columns),
                      "dump the columns x y z, xu yu zu, xs ys zs or xsu ysu zsu"});
  if (!header.box && (found.scaled || found.image))
    faults.push_back({place, "positions in parts of a box that the dump does not tell",
                      "see that \"ITEM: BOX BOUNDS\" is there, or dump the columns xu yu zu"});

  found.velocity = names.take_all<3>({"vx", "vy", "vz"});
  found.force = names.take_all<3>({"fx", "fy", "fz"});
  found.angular_velocity = names.take_all<3>({"omegax", "omegay", "omegaz"});
  found.torque = names.take_all<3>({"tqx", "tqy", "tqz"});
  // quat1 ... quat4 are LIGGGHTS's names (dump_custom.cpp, superquadric particles).
  auto quaternion = names.take_all<4>({"quatw", "quati", "quatj", "quatk"});
  if (!quaternion) quaternion = names.take_all<4>({"quat1", "quat2", "quat3", "quat4"});
  if (!quaternion) {
    quaternion = names.four_of_a_compute();
    found.quaternion_guessed = quaternion.has_value();
  }
  if (quaternion) found.quaternion = *quaternion;
  found.unused = names.unused();
  if (faults.size() != before) return std::nullopt;
  return found;
}

}  // namespace bondstatic
