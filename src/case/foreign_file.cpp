#include "case/foreign_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "io/line_reader.hpp"
#include "io/table_fields.hpp"

namespace bondstatic {
namespace {

ReadOptions options_of(TableReader& block, WantedOf wanted) {
  ReadOptions options;
  options.atom_style = block.text("atom_style").value_or("");
  options.step = block.whole("step", 0);
  if (wanted == WantedOf::bonds)
    options.bond_columns = block.texts("bond_columns").value_or(std::vector<std::string>{});
  options.particles = wanted == WantedOf::particles;
  options.bonds = wanted == WantedOf::bonds;
  return options;
}

/// Column names in the first line that is neither empty nor a comment, lower case; none where it cannot be
/// read.
std::vector<std::string> header_names(const std::string& path) {
  std::vector<Fault> unsaid;
  auto reader = LineReader::open(path, {path, 0, 0}, unsaid);
  std::vector<std::string> names;
  while (reader && names.empty()) {
    const auto line = reader->next(unsaid);
    if (!line) break;
    const char separator = separator_of(*line);
    std::vector<std::size_t> starts;
    append_field_starts(*line, separator, 0, starts);
    for (const std::size_t start : starts) {
      std::string& name = names.emplace_back(unquoted(field_at(*line, start, separator)));
      for (char& c : name) c = char(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return names;
}

void heed(Reading& reading, const std::string& path, const ForeignModel& model) {
  reading.si |= model.si;
  if (model.notes.assumed.empty()) return;
  const std::string warning =
      fmt::format("{}: read on assumptions; `bondstatic import {} --out DIR` lists them", path, path);
  // The blocks of particles and bonds may name the same file.
  if (std::find(reading.warnings.begin(), reading.warnings.end(), warning) == reading.warnings.end())
    reading.warnings.push_back(warning);
}

}  // namespace

bool is_foreign_file(const std::string& path) {
  std::vector<Fault> unsaid;
  const auto format = detect_format(path, {path, 0, 0}, unsaid);
  return format && *format != FileFormat::table;
}

std::optional<ForeignModel> read_foreign_file(TableReader& block, const std::string& path, WantedOf wanted) {
  ReadOptions options = options_of(block, wanted);
  options.particles = true;  // between which bonds a data file proves that its box is periodic
  auto model = read_foreign_model(path, options, block.place_of("file"), block.reading().faults);
  if (model) heed(block.reading(), path, *model);
  return model;
}

std::optional<ForeignModel> try_foreign_table(TableReader& block, const std::string& path, WantedOf wanted,
                                              const std::vector<std::string>& own) {
  for (const std::string& name : header_names(path))
    if (std::find(own.begin(), own.end(), name) != own.end()) return std::nullopt;
  std::vector<Fault> unsaid;
  auto model = read_foreign_model(path, options_of(block, wanted), block.place_of("file"), unsaid);
  if (!model || (wanted == WantedOf::particles ? model->particles.empty() : model->bonds.empty()))
    return std::nullopt;
  heed(block.reading(), path, *model);
  return model;
}

void accept_foreign_keys(TableReader& block, WantedOf wanted) {
  block.has("atom_style");
  block.has("step");
  if (wanted == WantedOf::bonds) block.has("bond_columns");
}

}  // namespace bondstatic
