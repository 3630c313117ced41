#include "formats/lammps/atoms.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "formats/lammps/atom_style.hpp"
#include "io/nearest_name.hpp"

namespace bondstatic {
namespace {

/// As asked for, or as the comment behind the section's name says.
std::optional<AtomStyle> atom_style(DataSections& sections, const LineReader& reader,
                                    const ReadOptions& options, ImportNotes& notes,
                                    std::vector<Fault>& faults) {
  const Place place{reader.file(), sections.line(), 1};
  const std::string said = sections.style();
  const std::string text = options.atom_style.empty() ? said : options.atom_style;
  if (text.empty()) {
    std::size_t width = 0;
    if (const auto row = sections.next_row()) {
      RowFields fields(reader, faults);
      fields.take(*row);
      width = fields.size();
    }
    const std::string fitting = atom_styles_of_width(width);
    faults.push_back(
        {place, "the section Atoms does not say its atom style, as \"Atoms # bpm/sphere\" does",
         fmt::format(
             "give that of the input script, for instance --atom-style \"bpm/sphere\"; its lines have {} "
             "fields, as those of {} or a hybrid style may",
             width, fitting.empty() ? "no single style" : fitting)});
    return std::nullopt;
  }
  Fault wrong;
  auto style = find_atom_style(text, wrong);
  if (!style) {
    wrong.place = place;
    faults.push_back(wrong);
  } else if (!said.empty() && said != text) {
    notes.assumed.push_back(
        fmt::format("Atom style \"{}\" as asked for, although the file says \"{}\".", text, said));
  }
  return style;
}

void note_style(const AtomStyle& style, ForeignModel& model) {
  ImportNotes& notes = model.notes;
  notes.taken.push_back(fmt::format("{} particles, atom style {}.", model.particles.size(), style.name));
  if (style.find("diameter") < 0)
    notes.left_out.push_back(fmt::format(
        "Atom style {} has no radii: they must be given. The file of a hybrid style needs its name.",
        style.name));
  std::vector<std::string> unused;
  for (const std::string& name : style.columns)
    if (name.size() > 1 && name != "id" && name != "type" && name != "diameter" && name != "density")
      unused.push_back(name);
  if (!unused.empty())
    notes.left_out.push_back("Columns that a model has no use for: " + name_list(unused) + ".");
}

std::array<std::int32_t, 3> image_flags(RowFields& fields, std::size_t first) {
  constexpr Index lowest = std::numeric_limits<std::int32_t>::min();
  std::array<std::int32_t, 3> flags{};
  for (std::size_t d = 0; d < 3; ++d)
    flags[d] = std::int32_t(fields.whole_number(first + d, "image flag", lowest, highest_type).value_or(0));
  return flags;
}

}  // namespace

std::optional<Index> read_lammps_atoms(DataSections& sections, const LineReader& reader, Index announced,
                                       const ReadOptions& options, const TypeNumbers& type_numbers,
                                       ForeignModel& model, LammpsAtoms& atoms, std::vector<Fault>& faults) {
  const auto style = atom_style(sections, reader, options, model.notes, faults);
  if (!style) return std::nullopt;
  model.format = fmt::format("{} ({})", format_name(FileFormat::lammps_data), style->name);
  const std::size_t columns = style->columns.size();
  const int id = style->find("id"), type = style->find("type"), x = style->find("x");
  const int diameter = style->find("diameter"), density = style->find("density");
  // No more than the file can hold: a wrong count must not allocate.
  const std::size_t room = std::size_t(std::min<std::uint64_t>(std::uint64_t(announced), reader.size() / 10));
  model.particles.reserve(room);
  model.particle_line.reserve(room);
  atoms.types.reserve(room);
  RowFields fields(reader, faults);
  Index rows = 0;
  while (const auto row = sections.next_row()) {
    ++rows;
    fields.take(*row);
    const bool flags = fields.size() == columns + 3;
    if (fields.size() != columns && !flags) {
      fields.fault(columns,
                   fmt::format("{} fields where atom style {} has {} ({}), with image flags {}",
                               fields.size(), style->name, columns, name_list(style->columns), columns + 3),
                   "see that --atom-style, or the comment behind Atoms, is that of the input script");
    } else {
      Particle particle;
      particle.id = fields.whole_number(std::size_t(id), "id").value_or(0);
      for (int d = 0; d < 3; ++d)
        particle.position[d] =
            fields.number(std::size_t(x + d), style->columns[std::size_t(x + d)]).value_or(0);
      particle.radius = not_given;
      if (diameter >= 0)
        particle.radius =
            fields.positive_number(std::size_t(diameter), "diameter", "leave point particles out")
                .value_or(1) /
            2;
      if (density >= 0)
        particle.density =
            fields.positive_number(std::size_t(density), "density", "give the particle's density")
                .value_or(1);
      atoms.types.push_back(type_numbers.number(fields, std::size_t(type), 1).value_or(1));
      model.particles.push_back(particle);
      model.particle_line.push_back(reader.line());
      if (flags) atoms.images.push_back(image_flags(fields, columns));
      if (!atoms.images.empty() && atoms.images.size() != model.particles.size())
        fields.fault(columns, "image flags in some lines and not in others",
                     "give image flags in all lines of the section, or in none");
    }
    if (fields.gave_up()) return std::nullopt;
  }
  note_style(*style, model);
  return rows;
}

}  // namespace bondstatic
