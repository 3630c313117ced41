#include "formats/write/lammps_dump.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>

#include "io/ordered_blocks.hpp"

namespace bondstatic {

namespace {

struct DumpColumns {
  std::string names;
  std::function<void(std::size_t, fmt::memory_buffer&)> append;
};

void add_vectors(std::vector<DumpColumns>& columns, const std::vector<Vector3>& of,
                 const std::string& names) {
  if (of.empty()) return;
  columns.push_back({names, [&of](std::size_t p, fmt::memory_buffer& text) {
                       fmt::format_to(std::back_inserter(text), " {} {} {}", of[p][0], of[p][1], of[p][2]);
                     }});
}

std::vector<DumpColumns> columns_of(const ParticleState& state) {
  std::vector<DumpColumns> columns;
  if (!state.type.empty())
    columns.push_back({" type", [&](std::size_t p, fmt::memory_buffer& text) {
                         fmt::format_to(std::back_inserter(text), " {}", state.type[p]);
                       }});
  add_vectors(columns, state.position, state.unwrapped ? " xu yu zu" : " x y z");
  if (!state.orientation.empty())
    columns.push_back({" quatw quati quatj quatk", [&](std::size_t p, fmt::memory_buffer& text) {
                         const Eigen::Quaterniond& q = state.orientation[p];
                         fmt::format_to(std::back_inserter(text), " {} {} {} {}", q.w(), q.x(), q.y(), q.z());
                       }});
  add_vectors(columns, state.velocity, " vx vy vz");
  add_vectors(columns, state.angular_velocity, " omegax omegay omegaz");
  add_vectors(columns, state.force, " fx fy fz");
  add_vectors(columns, state.torque, " tqx tqy tqz");
  if (!state.radius.empty())
    columns.push_back({" radius", [&](std::size_t p, fmt::memory_buffer& text) {
                         fmt::format_to(std::back_inserter(text), " {}", state.radius[p]);
                       }});
  return columns;
}

/// Dumps bound a tilted box by the box around it (LAMMPS, Howto_triclinic).
void write_box(OutputFile& file, const LammpsBox& box) {
  const bool tilted = box.triclinic();
  std::string faces;
  for (const bool repeats : box.periodic) faces += repeats ? " pp" : " ff";
  file.append(fmt::format("ITEM: BOX BOUNDS{}{}\n", tilted ? " xy xz yz" : "", faces));
  const double xy = box.tilt[0], xz = box.tilt[1], yz = box.tilt[2];
  const Vector3 low = box.low + Vector3(std::min({0.0, xy, xz, xy + xz}), std::min(0.0, yz), 0);
  const Vector3 high = box.high + Vector3(std::max({0.0, xy, xz, xy + xz}), std::max(0.0, yz), 0);
  for (int i = 0; i < 3; ++i)
    file.append(tilted ? fmt::format("{} {} {}\n", low[i], high[i], box.tilt[i])
                       : fmt::format("{} {}\n", low[i], high[i]));
}

}  // namespace

void write_lammps_dump(OutputFile& file, const ParticleState& state, const LammpsBox& box) {
  file.append(fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n", state.step, state.id.size()));
  write_box(file, box);
  const std::vector<DumpColumns> columns = columns_of(state);
  std::string names;
  for (const DumpColumns& column : columns) names += column.names;
  file.append("ITEM: ATOMS id" + names + '\n');
  write_blocks(file, Index(state.id.size()), 8192, [&](Index begin, Index end, fmt::memory_buffer& text) {
    for (auto p = std::size_t(begin); p < std::size_t(end); ++p) {
      fmt::format_to(std::back_inserter(text), "{}", state.id[p]);
      for (const DumpColumns& column : columns) column.append(p, text);
      text.push_back('\n');
    }
  });
}

}  // namespace bondstatic
