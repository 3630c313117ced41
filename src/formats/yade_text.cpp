#include "formats/yade_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "formats/table/columns.hpp"
#include "formats/table/model.hpp"
#include "io/line_reader.hpp"

namespace bondstatic {
namespace {

constexpr std::string_view format_line = "#format";

struct YadeHeader {
  std::string format;  ///< "x_y_z_r_matId"
  Place place;
  std::vector<std::string> comment;     ///< words of the last one above the rows
  std::optional<std::string_view> row;  ///< the first; it stands until the reader goes on
};

std::vector<std::string> words(std::string_view text, std::string_view separators) {
  std::vector<std::string> out;
  for (std::size_t at = text.find_first_not_of(separators); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    out.emplace_back(text.substr(at, end - at));
    at = text.find_first_not_of(separators, end);
  }
  return out;
}

YadeHeader read_header(LineReader& reader, std::vector<Fault>& faults) {
  YadeHeader header;
  header.place = {reader.file(), 1, 1};
  while (const auto line = reader.next(faults)) {
    if (line->starts_with(format_line)) {
      const auto format = words(line->substr(format_line.size()), " \t");
      if (!format.empty()) header.format = format.front();
      header.place = reader.place();
    } else if (line->starts_with('#')) {
      header.comment = words(line->substr(1), " \t");
    } else if (!words(*line, " \t").empty()) {
      header.row = line;
      break;
    }
  }
  return header;
}

/// The words of the format; `attrs` stands for columns that the comment names, if it names all there are.
std::vector<std::string> column_words(const YadeHeader& header) {
  std::vector<std::string> names = words(header.format, "_");
  if (names.empty() || names.back() != "attrs") return names;
  const std::size_t fields = words(header.row.value_or(""), " \t").size();
  if (header.comment.size() == fields) return header.comment;
  names.pop_back();
  while (names.size() < fields) names.push_back(fmt::format("attribute {}", names.size() - 3));
  return names;
}

TableColumns columns_of(const std::vector<std::string>& names, const Place& place) {
  TableColumns table;
  table.file = place.file;
  table.header = place;
  for (const std::string& word : names) {
    TableColumn column;
    column.heading.text = word;
    column.heading.name = word == "r" ? "radius" : word == "matId" ? "material_id" : word;
    column.place = place;
    column.wanted = wanted_of_particles(column.heading.name);
    table.columns.push_back(std::move(column));
  }
  return table;
}

}  // namespace

std::optional<ForeignModel> read_yade_text(const std::string& path, const ReadOptions& options,
                                           const Place& named_at, std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  if (!options.particles) {
    faults.push_back(
        {named_at, fmt::format("\"{}\" is a YADE text export, which has no bonds", path),
         "run the exporter script yade.py inside YADE, or let bonds form by contact_radius_factor"});
    return std::nullopt;
  }
  auto reader = LineReader::open(path, named_at, faults);
  if (!reader) return std::nullopt;
  const YadeHeader header = read_header(*reader, faults);
  if (reader->failed()) return std::nullopt;
  TableColumns table = columns_of(column_words(header), header.place);
  if (kind_of(table) != TableKind::particles || !table.has({"radius"})) {
    faults.push_back(
        {header.place,
         fmt::format("format \"{}\" has no columns x, y, z, r of spheres", header.format.substr(0, 60)),
         "export with yade.export.text(file) or textExt(file, 'id_x_y_z_r_matId'), or run the "
         "exporter script yade.py inside YADE"});
    return std::nullopt;
  }
  read_table_rows(*reader, header.row, ' ', options, table, faults);
  if (faults.size() != before) return std::nullopt;

  ForeignModel model;
  model.format = fmt::format("YADE text export ({})", header.format);
  take_particles(table, model, faults);
  if (faults.size() != before) return std::nullopt;
  for (std::string& name : model.group_names) name = "material " + name;
  model.notes.assumed.push_back(
      "YADE writes six digits here: positions and radii are rounded to 1e-6 of themselves, and gaps between "
      "particles are not what they were.");
  model.notes.left_out.push_back(
      "Bonds: this format has none. Run the exporter script yade.py inside YADE, which writes the bonds of "
      "the "
      "scene with their stiffness, or let bonds form by contact_radius_factor in [[bonds]].");
  return model;
}

}  // namespace bondstatic
