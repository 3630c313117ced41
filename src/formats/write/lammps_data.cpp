// Sections and columns as in LAMMPS' documentation of read_data (Atoms: bpm/sphere).
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "formats/write/lammps_files.hpp"
#include "io/ordered_blocks.hpp"

namespace bondstatic {

namespace {

constexpr Index lines_a_block = 8192;

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

void write_header(const LammpsModel& model, OutputFile& file) {
  const Model& of = model.input.model;
  const LammpsBox& box = model.box;
  // LAMMPS skips the first line; a data file says nowhere else which directions are periodic, and in which
  // units. The title, which may say of such things what it likes, comes behind.
  file.append(fmt::format("bondstatic, boundary = {}, {}{}\n\n", box.boundary(),
                          model.input.si ? "units = si, " : "", one_line(model.input.title)));
  file.append(fmt::format("{} atoms\n{} bonds\n{} atom types\n{} bond types\n\n", of.particles.size(),
                          of.bonds.size(), model.roles.roles.size(), model.bonds.types.size()));
  const char axes[] = {'x', 'y', 'z'};
  for (int i = 0; i < 3; ++i)
    file.append(fmt::format("{} {} {}lo {}hi\n", box.low[i], box.high[i], axes[i], axes[i]));
  if (box.triclinic()) file.append(fmt::format("{} {} {} xy xz yz\n", box.tilt[0], box.tilt[1], box.tilt[2]));
}

}  // namespace

std::string lammps_coefficients(const SectionStiffness& type) {
  return fmt::format("{0} {1} {2} {3} {4} {4} {4} {4} 0 0 0 0", type.kn, type.ks, type.kt, type.kb,
                     lammps_strength);
}

void write_lammps_data(const LammpsModel& model, OutputFile& file) {
  const Model& of = model.input.model;
  write_header(model, file);
  file.append("\nBond Coeffs # bpm/rotational\n\n");
  for (std::size_t t = 0; t < model.bonds.types.size(); ++t) {
    file.append(fmt::format("{} {}\n", t + 1, lammps_coefficients(model.bonds.types[t])));
    file.flush_if_large();
  }
  file.append("\nAtoms # bpm/sphere\n\n");
  write_blocks(
      file, Index(of.particles.size()), lines_a_block, [&](Index begin, Index end, fmt::memory_buffer& text) {
        for (auto p = std::size_t(begin); p < std::size_t(end); ++p) {
          const Particle& particle = of.particles[p];
          const Vector3& x = particle.position;
          fmt::format_to(std::back_inserter(text), "{} 1 {} {} {} {} {} {}\n", model.id(p),
                         model.roles.type[p], 2 * particle.radius, particle.density, x[0], x[1], x[2]);
        }
      });
  file.append("\nBonds\n\n");
  write_blocks(file, Index(of.bonds.size()), lines_a_block,
               [&](Index begin, Index end, fmt::memory_buffer& text) {
                 for (auto k = std::size_t(begin); k < std::size_t(end); ++k) {
                   const Bond& bond = of.bonds[k];
                   fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", bond.id, model.bonds.type[k],
                                  model.id(std::size_t(bond.a)), model.id(std::size_t(bond.b)));
                 }
               });
}

void write_lammps_variable(const LammpsModel& model, const LammpsVariable& variable, OutputFile& file) {
  file.append(fmt::format("{}\n", variable.particles.size()));
  write_blocks(file, Index(variable.particles.size()), lines_a_block,
               [&](Index begin, Index end, fmt::memory_buffer& text) {
                 for (auto i = std::size_t(begin); i < std::size_t(end); ++i)
                   fmt::format_to(std::back_inserter(text), "{} {}\n", model.id(variable.particles[i]),
                                  variable.values[i]);
               });
}

}  // namespace bondstatic
