// The files of `export --to lammps`, told as numbered steps.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "formats/write/lammps_dump.hpp"
#include "formats/write/lammps_files.hpp"
#include "model/boundary.hpp"

namespace bondstatic {

namespace {

Index shift_of_ids(const Model& model, ExportNotes& notes) {
  Index first = 1, last = 1;
  for (const Particle& particle : model.particles) {
    first = std::min(first, particle.id);
    last = std::max(last, particle.id);
  }
  const Index shift = 1 - first;
  if (shift > 0)
    notes.remarks.push_back(
        fmt::format("LAMMPS' ids begin at 1: id {} of the case is {} there, and so on. dump.final "
                    "has the ids of the case, dump.bonds those of LAMMPS.",
                    first, first + shift));
  if (last + shift > std::numeric_limits<std::int32_t>::max())
    notes.remarks.push_back("Ids beyond 2147483647 need a LAMMPS built with -DLAMMPS_BIGBIG.");
  return shift;
}

/// Where particles are at some time: their reference positions, and those of the static answer.
std::vector<Vector3> places(const ExportInput& input) {
  std::vector<Vector3> out;
  for (const Particle& particle : input.model.particles) out.push_back(particle.position);
  for (std::size_t p = 0; input.state && p < input.model.particles.size(); ++p)
    out.push_back(relaxed_position(input, p));
  return out;
}

double largest_diameter(const Model& model) {
  double largest = 0;
  for (const Particle& particle : model.particles) largest = std::max(largest, 2 * particle.radius);
  return largest;
}

void tell_what_else_does_not_fit(const ExportInput& input, const LammpsModel& model, ExportNotes& notes) {
  if (boundary_of(input.model, 0).strain != Matrix3(Matrix3::Zero()))
    notes.not_expressed.push_back(
        "The mean strain of the periodic cell is not in the deck, whose box stays as it is.");
  Index left_out = 0;
  for (const LammpsRole& role : model.roles.roles)
    if (role.left_out) left_out += role.particles;
  if (left_out > 0)
    notes.remarks.push_back(
        fmt::format("{} particles that nothing supports are held where they are, as the static answer leaves "
                    "them out.",
                    left_out));
}

ParticleState static_state(const LammpsModel& model) {
  ParticleState state;
  const std::size_t count = model.input.model.particles.size();
  state.unwrapped = model.input.model.cell.has_value();
  for (std::size_t p = 0; p < count; ++p) {
    state.id.push_back(model.id(p));
    state.type.push_back(model.roles.type[p]);
    state.position.push_back(relaxed_position(model.input, p));
    state.orientation.push_back(relaxed_orientation(model.input, p));
  }
  state.velocity.assign(count, Vector3::Zero());
  state.angular_velocity = state.velocity;
  return state;
}

}  // namespace

void write_lammps(const ExportInput& input, FileSet& files, ExportNotes& notes) {
  // 1. The model in LAMMPS' terms.
  need_bonds(input.model, "LAMMPS");
  LammpsModel model{input, lammps_roles(input), lammps_bonds(input, notes), {}};
  model.id_shift = shift_of_ids(input.model, notes);
  model.box = lammps_box(input.model.cell, places(input),
                         std::max(model.bonds.longest, largest_diameter(input.model)));
  tell_what_else_does_not_fit(input, model, notes);

  // 2. Data, coefficients and the state at rest.
  write_lammps_data(model, create(files, notes, lammps_data_file));
  std::vector<LammpsVariable> variables;
  const std::string deck = lammps_deck(model, notes, variables);
  if (model.bonds.types.size() > lammps_types_in_deck) {
    OutputFile& file = create(files, notes, lammps_coefficient_file);
    for (std::size_t t = 0; t < model.bonds.types.size(); ++t) {
      file.append(fmt::format("bond_coeff {} {}\n", t + 1, lammps_coefficients(model.bonds.types[t])));
      file.flush_if_large();
    }
  }
  for (const LammpsVariable& variable : variables)
    write_lammps_variable(model, variable, create(files, notes, variable.name + ".txt"));
  if (input.relaxed)
    write_lammps_dump(create(files, notes, lammps_static_dump), static_state(model), model.box);

  // 3. The deck comes last: where it stands, all that it reads does.
  create(files, notes, lammps_deck_file).append(deck);
  notes.next_steps = {fmt::format("lmp -in {}", lammps_deck_file),
                      fmt::format("bondstatic compare {} dump.final{}", input.case_file, input.case_options)};
}

}  // namespace bondstatic
