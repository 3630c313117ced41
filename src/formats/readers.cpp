#include "formats/readers.hpp"

#include "formats/lammps/data.hpp"
#include "formats/lammps/dump.hpp"
#include "formats/lammps/dump_steps.hpp"
#include "formats/lammps/local.hpp"
#include "formats/musen/scene.hpp"
#include "formats/musen/text.hpp"
#include "formats/table/foreign_table.hpp"
#include "formats/yade_text.hpp"
#include "io/line_reader.hpp"
#include "io/number_field.hpp"

namespace bondstatic {
namespace {

/// The first lines of a file, in which its format shows.
constexpr int telling_lines = 200;

/// "2068 atoms" and the like: a number and a keyword of a data file's header, whose first line says nothing.
bool heads_lammps_data(const std::vector<std::string_view>& fields) {
  if (fields.size() == 2 && (fields[1] == "atoms" || fields[1] == "bonds"))
    return whole_number_field(fields[0]).has_value();
  return fields.size() == 4 && fields[2] == "xlo" && fields[3] == "xhi";
}

void refuse(FileFormat format, const std::string& path, const std::string& wanted, const std::string& instead,
            const Place& named_at, std::vector<Fault>& faults) {
  faults.push_back(
      {named_at, "file \"" + path + "\" is a " + format_name(format) + ", which has no " + wanted, instead});
}

}  // namespace

std::optional<FileFormat> detect_format(const std::string& path, const Place& named_at,
                                        std::vector<Fault>& faults) {
  auto reader = LineReader::open(path, named_at, faults);
  if (!reader) return std::nullopt;
  std::vector<std::string_view> fields;
  bool dump = false;
  while (const auto line = reader->next(faults)) {
    if (reader->line() > telling_lines) break;
    dump = dump || line->starts_with("ITEM: ");
    if (line->starts_with("ITEM: ATOMS") || line->starts_with("ITEM: NUMBER OF ATOMS"))
      return FileFormat::lammps_dump;
    if (line->starts_with("ITEM: NUMBER OF ") || line->starts_with("ITEM: ENTRIES"))
      return FileFormat::lammps_local;
    if (line->starts_with("#format ")) return FileFormat::yade_text;
    split_at_blanks(*line, fields);
    if (reader->line() > 1 && heads_lammps_data(fields)) return FileFormat::lammps_data;
    if (heads_musen_text(fields)) return FileFormat::musen_text;
  }
  if (reader->failed()) return std::nullopt;
  return dump ? FileFormat::lammps_dump : FileFormat::table;
}

std::string format_name(FileFormat format) {
  switch (format) {
    case FileFormat::table:
      return "table";
    case FileFormat::lammps_data:
      return "LAMMPS data file";
    case FileFormat::lammps_dump:
      return "LAMMPS dump";
    case FileFormat::lammps_local:
      return "LAMMPS local dump";
    case FileFormat::yade_text:
      return "YADE text export";
    case FileFormat::musen_text:
      return "MUSEN text export";
  }
  return "file";
}

std::optional<ForeignModel> read_foreign_model(const std::string& path, const ReadOptions& options,
                                               const Place& named_at, std::vector<Fault>& faults) {
  const auto format = detect_format(path, named_at, faults);
  if (!format) return std::nullopt;
  switch (*format) {
    case FileFormat::table:
      return read_foreign_table(path, options, named_at, faults);
    case FileFormat::lammps_data:
      return read_lammps_data(path, options, named_at, faults);
    case FileFormat::lammps_dump:
      return read_lammps_dump(path, options, named_at, faults);
    case FileFormat::lammps_local:
      return read_lammps_local(path, options, named_at, faults);
    case FileFormat::yade_text:
      return read_yade_text(path, options, named_at, faults);
    case FileFormat::musen_text:
      return read_musen_text(path, options, named_at, faults);
  }
  return std::nullopt;
}

std::optional<ParticleState> read_particle_state(const std::string& path, const ReadOptions& options,
                                                 const Place& named_at, std::vector<Fault>& faults) {
  const auto format = detect_format(path, named_at, faults);
  if (!format) return std::nullopt;
  switch (*format) {
    case FileFormat::table:
      return read_state_table(path, options, named_at, faults);
    case FileFormat::lammps_data:
      return read_lammps_data_state(path, options, named_at, faults);
    case FileFormat::lammps_dump:
      return read_lammps_dump_state(path, options, named_at, faults);
    case FileFormat::musen_text:
      return read_musen_state(path, options, named_at, faults);
    default:
      break;
  }
  refuse(*format, path, "particles with ids",
         "give a dump of LAMMPS or LIGGGHTS with the column id, or a table with the columns id, x, y, z",
         named_at, faults);
  return std::nullopt;
}

std::optional<BondState> read_bond_state(const std::string& path, const ReadOptions& options,
                                         const Place& named_at, std::vector<Fault>& faults) {
  const auto format = detect_format(path, named_at, faults);
  if (!format) return std::nullopt;
  if (*format == FileFormat::table) return read_bond_state_table(path, options, named_at, faults);
  if (*format == FileFormat::lammps_local) return read_lammps_local_state(path, options, named_at, faults);
  refuse(*format, path, "bonds of a step",
         "give a local dump of LAMMPS or LIGGGHTS (dump local), or a table with the columns a, b", named_at,
         faults);
  return std::nullopt;
}

std::optional<std::vector<Index>> dump_steps(const std::string& path, const Place& named_at,
                                             std::vector<Fault>& faults) {
  const auto format = detect_format(path, named_at, faults);
  if (!format) return std::nullopt;
  if (*format != FileFormat::lammps_dump && *format != FileFormat::lammps_local) {
    refuse(*format, path, "steps", "give a dump of LAMMPS or LIGGGHTS", named_at, faults);
    return std::nullopt;
  }
  auto reader = LineReader::open(path, named_at, faults);
  if (!reader) return std::nullopt;
  const auto steps = find_dump_steps(*reader, nullptr, faults);
  if (!steps) return std::nullopt;
  std::vector<Index> numbers;
  for (const DumpStep& step : *steps)
    if (step.complete) numbers.push_back(step.step);
  return numbers;
}

}  // namespace bondstatic
