#include "formats/lammps/data_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "formats/row_fields.hpp"
#include "io/nearest_name.hpp"
#include "io/number_field.hpp"

namespace bondstatic {
namespace {

const std::vector<std::string> count_names{"atoms",
                                           "bonds",
                                           "angles",
                                           "dihedrals",
                                           "impropers",
                                           "atom types",
                                           "bond types",
                                           "angle types",
                                           "dihedral types",
                                           "improper types",
                                           "ellipsoids",
                                           "lines",
                                           "triangles",
                                           "bodies",
                                           "extra bond per atom",
                                           "extra angle per atom",
                                           "extra dihedral per atom",
                                           "extra improper per atom",
                                           "extra special per atom"};

/// Keywords of the box, and how many numbers stand before them.
const std::map<std::string, std::size_t> box_names{{"xlo xhi", 2},  {"ylo yhi", 2},   {"zlo zhi", 2},
                                                   {"xy xz yz", 3}, {"avec", 3},      {"bvec", 3},
                                                   {"cvec", 3},     {"abc origin", 3}};

std::vector<std::string> all_names() {
  std::vector<std::string> names = count_names;
  for (const auto& [name, numbers] : box_names) names.push_back(name);
  return names;
}

/// What stands after "KEY =" in the title, up to `fields` words.
std::vector<std::string_view> value_in_title(const std::string& title, const std::string& key,
                                             std::size_t fields) {
  std::vector<std::string_view> words;
  const std::size_t at = title.find(key + " = ");
  if (at == std::string::npos) return words;
  split_at_blanks(std::string_view(title).substr(at + key.size() + 3), words);
  if (words.size() > fields) words.resize(fields);
  for (std::string_view& word : words)
    if (word.ends_with(',')) word.remove_suffix(1);
  return words;
}

void read_title(std::string_view line, DataHeader& header) {
  header.title = std::string(line);
  if (const auto units = value_in_title(header.title, "units", 1); !units.empty()) header.units = units[0];
  if (const auto step = value_in_title(header.title, "timestep", 1); !step.empty())
    header.step = whole_number_field(step[0]);
  const auto boundary = value_in_title(header.title, "boundary", 3);
  std::array<bool, 3> periodic{};
  for (std::size_t d = 0; d < boundary.size(); ++d) periodic[d] = boundary[d] == "p";
  if (boundary.size() == 3) header.periodic = periodic;
}

class Header {
 public:
  Header(LineReader& reader, ImportNotes& notes, std::vector<Fault>& faults)
      : reader_(reader), notes_(notes), faults_(faults), fields_(reader, faults) {}

  std::optional<DataHeaderEnd> read() {
    const std::size_t before = faults_.size();
    auto line = reader_.next(faults_);
    if (line) read_title(*line, end_.header);
    while ((line = reader_.next(faults_))) {
      fields_.take(*line);
      if (fields_.size() == 0) continue;
      if (!is_number_field(fields_.text(0))) {
        end_.section = std::string(*line);
        break;
      }
      keyword();
      if (fields_.gave_up()) break;
    }
    if (!reader_.failed()) make_box();
    if (faults_.size() != before) return std::nullopt;
    return std::move(end_);
  }

 private:
  void keyword() {
    std::size_t numbers = 0;
    while (numbers < fields_.size() && is_number_field(fields_.text(numbers))) ++numbers;
    std::string name;
    for (std::size_t i = numbers; i < fields_.size(); ++i)
      name += (name.empty() ? "" : " ") + std::string(fields_.text(i));
    const bool counts = std::find(count_names.begin(), count_names.end(), name) != count_names.end();
    const auto box = box_names.find(name);
    if (!counts && box == box_names.end()) return unknown(numbers, name);
    const std::size_t wanted = counts ? 1 : box->second;
    if (numbers != wanted)
      return fields_.fault(0, fmt::format("{} numbers before \"{}\", which takes {}", numbers, name, wanted),
                           "correct the line");
    if (!seen_.insert(name).second)
      return fields_.fault(numbers, fmt::format("\"{}\" is there twice", name), "remove one of the lines");
    if (counts) {
      if (const auto value = fields_.whole_number(0, name))
        end_.header.counts[name] = {*value, reader_.line()};
      return;
    }
    auto& values = box_[name];
    for (std::size_t i = 0; i < wanted; ++i)
      if (const auto value = fields_.number(i, name)) values[i] = *value;
    box_line_ = reader_.line();
  }

  void unknown(std::size_t numbers, const std::string& name) {
    const std::string near = nearest_name(name, all_names());
    if (name.empty() || !near.empty())
      return fields_.fault(numbers, fmt::format("\"{}\" in the header of a data file", shown(name)),
                           near.empty() ? "a number there needs its keyword, as in \"1000 atoms\""
                                        : fmt::format("did you mean \"{}\"?", near));
    notes_.left_out.push_back(
        fmt::format("Line {}, \"{}\", which is not LAMMPS's own.", reader_.line(), shown(name)));
  }

  std::array<double, 3> of_box(const std::string& name, std::array<double, 3> otherwise) const {
    const auto found = box_.find(name);
    return found == box_.end() ? otherwise : found->second;
  }

  void make_box() {
    Cell& cell = end_.header.box;
    cell.periodic = {false, false, false};
    const auto any_of = [&](std::initializer_list<const char*> names) {
      return std::any_of(names.begin(), names.end(), [&](const char* name) { return box_.contains(name); });
    };
    const bool general = any_of({"avec", "bvec", "cvec", "abc origin"});
    if (general && any_of({"xlo xhi", "ylo yhi", "zlo zhi", "xy xz yz"})) {
      faults_.push_back({{reader_.file(), box_line_, 1},
                         "the header gives two boxes",
                         "give either xlo xhi, ylo yhi, zlo zhi, xy xz yz, or avec, bvec, cvec, abc origin"});
      return;
    }
    const auto axis = [](const std::array<double, 3>& of) { return Vector3(of[0], of[1], of[2]); };
    if (general) {
      cell.origin = axis(of_box("abc origin", {0, 0, 0}));
      cell.edges << axis(of_box("avec", {1, 0, 0})), axis(of_box("bvec", {0, 1, 0})),
          axis(of_box("cvec", {0, 0, 1}));
    } else {
      const auto x = of_box("xlo xhi", {-0.5, 0.5, 0}), y = of_box("ylo yhi", {-0.5, 0.5, 0});
      const auto z = of_box("zlo zhi", {-0.5, 0.5, 0}), tilt = of_box("xy xz yz", {0, 0, 0});
      cell.origin = {x[0], y[0], z[0]};
      cell.edges << x[1] - x[0], tilt[0], tilt[1], 0, y[1] - y[0], tilt[2], 0, 0, z[1] - z[0];
    }
    const double volume = cell.edges.determinant();
    if (!(volume > 0) || !std::isfinite(volume) || (!general && !(cell.edges.diagonal().array() > 0).all()))
      faults_.push_back({{reader_.file(), std::max(box_line_, 1), 1},
                         "the box has no volume",
                         general ? "avec, bvec and cvec must be a right-handed system, not in one plane"
                                 : "each lower bound must be below its upper one"});
  }

  LineReader& reader_;
  ImportNotes& notes_;
  std::vector<Fault>& faults_;
  RowFields fields_;
  DataHeaderEnd end_;
  std::set<std::string> seen_;
  std::map<std::string, std::array<double, 3>> box_;
  int box_line_ = 0;
};

}  // namespace

Index DataHeader::count(const std::string& of) const {
  const auto found = counts.find(of);
  return found == counts.end() ? 0 : found->second.value;
}

std::optional<DataHeaderEnd> read_data_header(LineReader& reader, ImportNotes& notes,
                                              std::vector<Fault>& faults) {
  return Header(reader, notes, faults).read();
}

}  // namespace bondstatic
