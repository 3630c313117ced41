#include "formats/lammps/data_periodic.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/id_table.hpp"

namespace bondstatic {
namespace {

/// Bonds longer than this many times their particles' radii together are taken through a face, if that makes
/// them shorter than this.
constexpr double longest_bond = 2;

struct LongBonds {
  std::array<Index, 3> through{};  ///< of each direction, bonds that reach through a face
  Index doubtful = 0;              ///< more than half the box long, but nothing proves how they run
};

LongBonds find_long_bonds(const Cell& box, const ForeignModel& model) {
  LongBonds found;
  IdTable positions;
  positions.expect(Index(model.particles.size()));
  for (std::size_t i = 0; i < model.particles.size(); ++i) positions.add(model.particles[i].id, Index(i));
  const Matrix3 to_parts = box.edges.inverse();
  for (const ForeignBond& bond : model.bonds) {
    const Particle& a = model.particles[std::size_t(*positions.position_of(bond.a))];
    const Particle& b = model.particles[std::size_t(*positions.position_of(bond.b))];
    const Vector3 branch = b.position - a.position, parts = to_parts * branch;
    const Vector3 shift = parts.array().round();
    if (shift.isZero()) continue;
    const double reach = longest_bond * (a.radius + b.radius);  // NaN without radii
    if (!(branch.norm() > reach && (branch - box.edges * shift).norm() <= reach)) {
      ++found.doubtful;
      continue;
    }
    for (int d = 0; d < 3; ++d)
      if (shift[d] != 0) ++found.through[std::size_t(d)];
  }
  return found;
}

std::string box_text(const Cell& box) {
  const auto vector = [](const Vector3& v) { return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z()); };
  return fmt::format("origin {}, edges {}, {}, {}", vector(box.origin), vector(box.edges.col(0)),
                     vector(box.edges.col(1)), vector(box.edges.col(2)));
}

}  // namespace

void find_periodic_directions(const DataHeader& header, const ImageFlags& images, ForeignModel& model) {
  Cell cell = header.box;
  std::array<std::string, 3> why;
  if (header.periodic) {
    for (std::size_t d = 0; d < 3; ++d)
      if ((*header.periodic)[d]) why[d] = "the first line says so";
  } else {
    std::array<Index, 3> wandered{};
    for (const auto& image : images)
      for (std::size_t d = 0; d < 3; ++d) wandered[d] += image[d] != 0;
    const LongBonds bonds = find_long_bonds(cell, model);
    for (std::size_t d = 0; d < 3; ++d) {
      if (wandered[d] > 0)
        why[d] = fmt::format("{} particles have image flags that are not zero", wandered[d]);
      if (bonds.through[d] > 0)
        why[d] += fmt::format("{}{} bonds fit their particles only through a face",
                              why[d].empty() ? "" : ", ", bonds.through[d]);
    }
    if (bonds.doubtful > 0)
      model.notes.assumed.push_back(
          fmt::format("{} bonds are more than half the box long and taken as straight through it: say which "
                      "directions are periodic if they are not.",
                      bonds.doubtful));
  }
  bool any = false;
  std::string rest;
  for (std::size_t d = 0; d < 3; ++d) {
    cell.periodic[d] = !why[d].empty();
    any = any || cell.periodic[d];
    const char name = "xyz"[d];
    if (cell.periodic[d])
      model.notes.assumed.push_back(fmt::format("The box is periodic along its {} edge: {}.", name, why[d]));
    else
      rest += fmt::format("{}{}", rest.empty() ? "" : ", ", name);
  }
  if (any) model.cell = cell;
  model.box = header.box;
  model.notes.taken.push_back("The box: " + box_text(header.box) + ".");
  if (!rest.empty() && !header.periodic)
    model.notes.assumed.push_back(
        fmt::format("Nothing shows that the box is periodic along {}; a data file does not say it (the input "
                    "script's `boundary` does).",
                    rest));
}

}  // namespace bondstatic
