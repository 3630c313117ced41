#include "formats/write/lammps_roles.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <set>

#include "model/boundary.hpp"

namespace bondstatic {

namespace {

/// LAMMPS has 32 groups, and the deck needs some for supports.
constexpr std::size_t most_load_groups = 8;

using Numbers = std::array<double, 6>;

Numbers numbers(const Vector6& v) {
  Numbers out;
  for (int i = 0; i < 6; ++i) out[std::size_t(i)] = v[i] + 0.0;  // one zero, not two
  return out;
}

}  // namespace

std::string LammpsRole::text() const {
  if (left_out) return "supported by nothing, left out";
  std::string text;
  if (held_altogether()) {
    text = "all held";
  } else if (held == 0) {
    text = "free";
  } else {
    const char* const names[] = {"x", "y", "z", "rx", "ry", "rz"};
    for (int i = 0; i < 6; ++i)
      if ((held >> i) & 1) text += std::string(names[i]) + ' ';
    text += "held";
  }
  return loaded ? text + ", loaded" : text;
}

LammpsRoles lammps_roles(const ExportInput& input) {
  const Boundary boundary = boundary_of(input.model, 0);
  const std::size_t count = input.model.particles.size();
  LammpsRoles out;
  out.load = boundary.load;
  out.prescribed = boundary.prescribed;
  std::vector<LammpsRole> of(count);
  std::set<Numbers> loads;
  for (std::size_t p = 0; p < count; ++p) {
    LammpsRole& role = of[p];
    role.held = std::uint8_t(~boundary.free[p] & 0b111111);
    role.left_out = input.state && !input.state->displacement[p].allFinite();
    if (role.left_out) role.held = 0b111111;
    // What acts on a particle that cannot move is the support's alone.
    if (role.held_altogether()) out.load[p].setZero();
    role.loaded = out.load[p] != Vector6(Vector6::Zero());
    if (role.loaded && loads.size() <= most_load_groups) loads.insert(numbers(out.load[p]));
  }
  out.loads_by_particle = loads.size() > most_load_groups;

  std::map<std::tuple<int, bool, bool, Numbers>, int> known;
  for (std::size_t p = 0; p < count; ++p) {
    if (!out.loads_by_particle) of[p].load = out.load[p];
    const auto [found, is_new] = known.try_emplace(
        {of[p].held, of[p].left_out, of[p].loaded, numbers(of[p].load)}, int(out.roles.size()) + 1);
    if (is_new) out.roles.push_back(of[p]);
    out.roles[std::size_t(found->second) - 1].particles += 1;
    out.type.push_back(found->second);
  }
  return out;
}

}  // namespace bondstatic
