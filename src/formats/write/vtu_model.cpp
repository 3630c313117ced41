// model.vtu before any solve: what the case says of particles and bonds.
#include <functional>
#include <numeric>
#include <optional>

#include "formats/write/export_formats.hpp"
#include "io/vtu_writer.hpp"
#include "model/boundary.hpp"
#include "model/cell.hpp"

namespace bondstatic {

namespace {

template <class Value>
Column column(const std::string& name, std::size_t rows, Value value) {
  using Number = decltype(value(std::size_t(0)));
  return {name, Index(rows), Column::Numbers<Number>([value](Index i) { return value(std::size_t(i)); })};
}

/// Three of each particle's six, from `first`.
Column vectors(const std::string& name, const std::vector<Vector6>& of, int first) {
  return {name, 3 * Index(of.size()),
          Column::Numbers<double>([&of, first](Index i) { return of[std::size_t(i / 3)][first + i % 3]; }),
          3};
}

/// 1 where a degree of freedom is held, of three from `first`.
Column held(const std::string& name, const Boundary& boundary, int first) {
  return {name, 3 * Index(boundary.free.size()), Column::Numbers<Index>([&boundary, first](Index i) {
            return Index(1) - ((boundary.free[std::size_t(i / 3)] >> (first + i % 3)) & 1);
          }),
          3};
}

std::vector<Column> particle_columns(const ExportInput& input, const Boundary& boundary) {
  const auto& particles = input.model.particles;
  const std::size_t count = particles.size();
  return {column("id", count, [&](std::size_t p) { return particles[p].id; }),
          column("radius", count, [&](std::size_t p) { return particles[p].radius; }),
          column("density", count, [&](std::size_t p) { return particles[p].density; }),
          held("held_translation", boundary, 0),
          held("held_rotation", boundary, 3),
          vectors("prescribed_translation", boundary.prescribed, 0),
          vectors("prescribed_rotation", boundary.prescribed, 3),
          vectors("load_force", boundary.load, 0),
          vectors("load_moment", boundary.load, 3)};
}

std::vector<Column> bond_columns(const ExportInput& input) {
  const Model& model = input.model;
  const std::size_t count = model.bonds.size();
  std::vector<Column> columns{column("id", count, [&](std::size_t k) { return model.bonds[k].id; }),
                              column("block", count, [&](std::size_t k) { return model.bonds[k].block; })};
  const auto add = [&](const std::string& name, double SectionStiffness::*value) {
    columns.push_back(
        column(name, count, [&input, value](std::size_t k) { return input.properties[k].stiffness.*value; }));
  };
  add("kn", &SectionStiffness::kn);
  add("ks", &SectionStiffness::ks);
  add("kt", &SectionStiffness::kt);
  add("kb", &SectionStiffness::kb);
  add("coupling", &SectionStiffness::coupling);
  columns.push_back(
      column("contact_point", count, [&](std::size_t k) { return input.properties[k].fraction; }));
  columns.push_back(column("radius", count, [&](std::size_t k) { return input.properties[k].radius; }));
  columns.push_back(column("length", count, [&](std::size_t k) { return model.bonds[k].branch.norm(); }));
  return columns;
}

}  // namespace

void write_vtu_model(const ExportInput& input, FileSet& files, ExportNotes& notes) {
  const Model& model = input.model;
  const Boundary boundary = boundary_of(model, 0);
  std::vector<Column> points = particle_columns(input, boundary), lines = bond_columns(input);
  if (input.relaxed) {
    points.push_back(vectors("displacement", input.state->displacement, 0));
    points.push_back(vectors("rotation", input.state->displacement, 3));
    points.push_back(vectors("reaction_force", input.state->reaction, 0));
    points.push_back(vectors("reaction_moment", input.state->reaction, 3));
    lines.push_back(column("normal_force", model.bonds.size(),
                           [&](std::size_t k) { return input.state->bonds[k].normal_force; }));
    for (const int first : {0, 3})
      lines.push_back({first == 0 ? "force" : "moment", 3 * Index(model.bonds.size()),
                       Column::Numbers<double>([&input, first](Index i) {
                         return input.state->bonds[std::size_t(i / 3)].force[first + i % 3];
                       }),
                       3});
  }
  std::vector<double> places;
  const auto place = [&](std::size_t p, const Vector3& shift) {
    const Vector3 x = shift + (input.relaxed ? relaxed_position(input, p) : model.particles[p].position);
    places.insert(places.end(), x.begin(), x.end());
  };
  std::vector<Index> particle(model.particles.size()), ends;  // of each point; points of each bond
  std::iota(particle.begin(), particle.end(), Index(0));
  for (std::size_t p = 0; p < particle.size(); ++p) place(p, Vector3::Zero());
  for (const Bond& bond : model.bonds) {
    ends.insert(ends.end(), {bond.a, bond.b});
    const Vector3 shift = shift_of_end(model, bond);
    if (shift.isZero(0)) continue;
    // A line across a periodic face ends beside it, at a copy of the particle.
    ends.back() = Index(particle.size());
    particle.push_back(bond.b);
    place(std::size_t(bond.b), input.relaxed ? shift + input.state->strain * shift : shift);
  }
  std::vector<Column> of_points;
  for (const Column& column : points) of_points.push_back(rows_of(column, particle));
  const auto own = Index(model.particles.size());
  if (input.relaxed)
    notes.remarks.emplace_back(
        "Points stand at the relaxed positions; displacements are small, scale them with the filter Warp By "
        "Vector on a model exported without --relaxed.");
  write_vtu(create(files, notes, "model.vtu"),
            LineGrid{places, ends, of_points, lines,
                     Index(particle.size()) > own ? std::optional(own) : std::nullopt});
}

}  // namespace bondstatic
