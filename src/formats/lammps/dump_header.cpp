#include "formats/lammps/dump_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "formats/row_fields.hpp"
#include "io/number_field.hpp"

namespace bondstatic {
namespace {

constexpr std::string_view item = "ITEM: ";

/// "pp", "ff", "sm" ...: the lower and the upper face of a direction.
bool is_boundary(std::string_view word) {
  constexpr std::string_view letters = "pfsm";
  return word.size() == 2 && letters.find(word[0]) != letters.npos && letters.find(word[1]) != letters.npos;
}

class Header {
 public:
  Header(LineReader& reader, DumpHeader& header, std::vector<Fault>& faults)
      : reader_(reader), header_(header), faults_(faults) {}

  HeaderEnd read(std::string_view line) {
    header_.step = -1;
    while (true) {
      if (!reader_.line_ended()) return HeaderEnd::cut;
      if (!line.starts_with(item)) {
        fault(
            fmt::format("\"{}\" stands where a step of the dump must begin or go on", shown(line)),
            "every item of a dump begins with \"ITEM: \"; if rows were added, correct the number above them");
        return HeaderEnd::at_fault;
      }
      line.remove_prefix(item.size());
      if (counted_ && !label_.empty() && (line == label_ || line.starts_with(label_ + " ")))
        return rows(line);
      if (!read_item(line)) return at_fault_ || reader_.failed() ? HeaderEnd::at_fault : HeaderEnd::cut;
      const auto next = reader_.next(faults_);
      if (!next) return reader_.failed() ? HeaderEnd::at_fault : HeaderEnd::cut;
      line = *next;
    }
  }

 private:
  bool fault(const std::string& message, const std::string& cure, int column = 1) {
    faults_.push_back({reader_.place(column), message, cure});
    at_fault_ = true;
    return false;
  }

  bool next_fields() {
    const auto line = reader_.next(faults_);
    if (!line || !reader_.line_ended()) return false;
    split_at_blanks(*line, fields_);
    return true;
  }

  /// The value under an item; false where there is none.
  bool whole(const std::string& what, Index& value) {
    if (!next_fields()) return false;
    const auto found = fields_.size() == 1 ? whole_number_field(fields_[0]) : std::nullopt;
    if (!found || *found < 0 || *found >= above_every_whole_number)
      return fault(fmt::format("the {} must be one whole number from 0 on, below 9e15", what),
                   "see that the dump is whole and was not changed by hand");
    value = *found;
    return true;
  }

  bool read_item(std::string_view name) {
    if (name == "TIMESTEP") {
      Index step = 0;
      if (!whole("step", step)) return false;
      header_.step = step;
      return true;
    }
    if (name.starts_with("NUMBER OF ")) {
      label_ = std::string(name.substr(std::string_view("NUMBER OF ").size()));
      while (label_.ends_with(' ')) label_.pop_back();
      counted_ = whole("number of rows", header_.rows);
      return counted_;
    }
    if (name.starts_with("BOX BOUNDS")) return box(name.substr(std::string_view("BOX BOUNDS").size()));
    if (name == "UNITS") {
      if (!next_fields()) return false;
      header_.units = fields_.empty() ? "" : std::string(fields_[0]);
      return true;
    }
    if (name == "TIME") {
      if (!next_fields()) return false;
      header_.time = fields_.size() == 1 ? number_field(fields_[0]) : not_given;
      return std::isfinite(header_.time) || fault("the time must be one number", "correct or remove it");
    }
    if (!counted_)
      return fault(fmt::format("\"ITEM: {}\" stands before the number of rows, or is unknown", shown(name)),
                   "dumps of LAMMPS and LIGGGHTS in style atom, custom or local are understood");
    return fault(fmt::format("\"ITEM: {}\" where \"ITEM: {}\" and the column names must be", shown(name),
                             shown(label_)),
                 "dumps of LAMMPS and LIGGGHTS in style atom, custom or local are understood");
  }

  bool box(std::string_view words) {
    std::vector<std::string_view> names;
    split_at_blanks(words, names);
    const bool tilted = names.size() >= 3 && names[0] == "xy" && names[1] == "xz" && names[2] == "yz";
    const bool general = names.size() >= 2 && names[0] == "abc" && names[1] == "origin";
    names.erase(names.begin(), names.begin() + (tilted ? 3 : general ? 2 : 0));
    header_.boundary_known = names.size() == 3 && std::all_of(names.begin(), names.end(), is_boundary);
    std::array<bool, 3> periodic{};
    for (std::size_t d = 0; d < 3 && header_.boundary_known; ++d) periodic[d] = names[d] == "pp";

    const std::size_t columns = general ? 4 : tilted ? 3 : 2;
    Eigen::Matrix<double, 3, 4> value = Eigen::Matrix<double, 3, 4>::Zero();
    for (int row = 0; row < 3; ++row) {
      if (!next_fields()) return false;
      bool sound = fields_.size() == columns;
      for (std::size_t i = 0; i < columns && sound; ++i) {
        value(row, Index(i)) = number_field(fields_[i]);
        sound = std::isfinite(value(row, Index(i)));
      }
      if (!sound)
        return fault(fmt::format("a line of the box must have {} numbers", columns),
                     "see that the dump is whole and was not changed by hand");
    }
    Cell cell;
    cell.periodic = periodic;
    if (general) {
      cell.edges = value.leftCols<3>().transpose();
      cell.origin = value.col(3);
    } else {
      // The bounds of a tilted box are those of the upright one around it (documentation, "Howto triclinic").
      const double xy = value(0, 2), xz = value(1, 2), yz = value(2, 2);
      Vector3 low = value.col(0), high = value.col(1);
      low.x() -= std::min({0.0, xy, xz, xy + xz});
      high.x() -= std::max({0.0, xy, xz, xy + xz});
      low.y() -= std::min(0.0, yz);
      high.y() -= std::max(0.0, yz);
      cell.origin = low;
      cell.edges << high.x() - low.x(), xy, xz, 0, high.y() - low.y(), yz, 0, 0, high.z() - low.z();
    }
    const double volume = cell.edges.determinant();
    if (!(volume > 0) || !std::isfinite(volume) || !(general || (cell.edges.diagonal().array() > 0).all()))
      return fault("the box has no volume", "each lower bound must be below its upper one");
    header_.box = cell;
    return true;
  }

  HeaderEnd rows(std::string_view line) {
    if (header_.step < 0) {
      fault("no \"ITEM: TIMESTEP\" above these rows",
            "see that the dump is whole and was not changed by hand");
      return HeaderEnd::at_fault;
    }
    header_.label = label_;
    header_.columns_line = reader_.line();
    split_at_blanks(line.substr(label_.size()), fields_);
    for (const std::string_view name : fields_) {
      const int at = int(name.data() - line.data() + Index(item.size())) + 1;
      const auto& known = header_.columns;
      if (std::find(known.begin(), known.end(), name) != known.end()) {
        fault(fmt::format("column \"{}\" is there twice", shown(name)), "dump each quantity once", at);
        return HeaderEnd::at_fault;
      }
      header_.columns.emplace_back(name);
      header_.column_at.push_back(at);
    }
    return HeaderEnd::rows;
  }

  LineReader& reader_;
  DumpHeader& header_;
  std::vector<Fault>& faults_;
  std::vector<std::string_view> fields_;
  std::string label_;
  bool counted_ = false, at_fault_ = false;
};

}  // namespace

HeaderEnd read_dump_header(LineReader& reader, std::string_view line, DumpHeader& header,
                           std::vector<Fault>& faults) {
  header = {};
  return Header(reader, header, faults).read(line);
}

}  // namespace bondstatic
