#include "case/generator_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "model/generators.hpp"

namespace bondstatic {
namespace {

constexpr Index most_points = 200'000'000;  // a slip in a count should end in a fault, not in swapping

std::optional<Index> read_count(TableReader& reader, Index lowest) {
  if (!reader.require("count", "add count = N, the number of particles")) return std::nullopt;
  const auto count = reader.whole("count", lowest);
  if (count && *count > most_points) {
    reader.reading().fault(reader.place_of("count"),
                           fmt::format("count = {} must be at most {}", *count, most_points), "lower it");
    return std::nullopt;
  }
  return count;
}

std::optional<std::vector<Vector3>> read_line(TableReader& reader) {
  const std::size_t before = reader.reading().faults.size();
  reader.require("from", "add from = [X, Y, Z], the first particle's centre");
  const Vector3 from = reader.vector("from", dimension::length).value_or(Vector3::Zero());
  const std::string key = reader.one_of(std::vector<std::string>{"to", "step"});
  const auto other = key.empty() ? std::nullopt : reader.vector(key, dimension::length);
  const auto count = read_count(reader, key == "to" ? 2 : 1);
  reader.finish();
  if (reader.reading().faults.size() != before) return std::nullopt;
  if (count && *count > 1 && other && (key == "to" ? *other == from : other->isZero(0))) {
    reader.reading().fault(reader.place_of(key), "all particles of the line would lie in one point",
                           "give it a length");
    return std::nullopt;
  }
  if (!other || !count) return std::nullopt;
  return key == "to" ? line_points(from, *other, *count) : stepped_points(from, *other, *count);
}

std::optional<std::vector<Vector3>> read_arc(TableReader& reader, bool helix) {
  const std::size_t before = reader.reading().faults.size();
  Arc arc;
  arc.centre = reader.vector_or("centre", Vector3::Zero(), dimension::length);
  reader.require("radius", "add radius = R, from the axis to the particle centres");
  const auto radius = reader.number("radius", dimension::length, Allowed::positive);
  arc.axis = reader.axis_or("axis", "z");
  if (const auto start = reader.vector("start", dimension::none)) arc.start = *start;
  const std::string key = reader.one_of(std::vector<std::string>{"turns", "angle"});
  const double given = key.empty() ? 0 : reader.number(key, dimension::none).value_or(0);
  if (helix) {
    reader.require("pitch", "add pitch = P, the advance along the axis for a full turn");
    arc.pitch = reader.number("pitch", dimension::length).value_or(0);
  }
  const auto count = read_count(reader, 2);
  reader.finish();
  if (reader.reading().faults.size() != before || !radius || !count) return std::nullopt;
  arc.radius = *radius;
  arc.angle = key == "turns" ? given * 2 * std::numbers::pi : given;
  arc.count = *count;
  const auto fail = [&](const std::string& where, const std::string& message, const std::string& cure) {
    reader.reading().fault(reader.place_of(where), message, cure);
    return std::nullopt;
  };
  if (arc.start_along_axis())
    return fail("start", "start lies along the axis", "give a direction across the axis");
  if (arc.angle == 0)
    return fail(key, fmt::format("{} must not be zero", key), "write turns = 1 for a full circle");
  if (arc.pitch == 0 && std::abs(arc.angle) > 2 * std::numbers::pi * (1 + 1e-12))
    return fail(key, "without pitch more than one turn runs over itself", "use helix with a pitch");
  return arc_points(arc);
}

std::optional<std::array<Index, 3>> read_cells(TableReader& reader) {
  if (!reader.require("count", "add count = [NX, NY, NZ], conventional cells along x, y, z"))
    return std::nullopt;
  const Node& node = *reader.find("count");
  if (!node.is_array() || node.items.size() != 3) {
    reader.reading().fault(node.place,
                           fmt::format("count = {} must be a list of three whole numbers", shown(node)),
                           "write count = [NX, NY, NZ]");
    return std::nullopt;
  }
  std::array<Index, 3> cells{};
  std::size_t i = 0;
  for (const Node& item : node.items) {
    const auto whole = read_whole(reader.reading(), item, fmt::format("count[{}]", i), 1);
    if (!whole) return std::nullopt;
    cells[i++] = *whole;
  }
  return cells;
}

std::optional<std::vector<Vector3>> read_lattice(TableReader& reader) {
  const std::size_t before = reader.reading().faults.size();
  const std::vector<std::string> kinds{"simple-cubic", "bcc", "fcc"};
  reader.require("kind", "add kind = \"simple-cubic\", \"bcc\" or \"fcc\"");
  const std::string name = reader.choice_or("kind", kinds.front(), kinds);
  const auto kind = name == "bcc"   ? LatticeKind::bcc
                    : name == "fcc" ? LatticeKind::fcc
                                    : LatticeKind::simple_cubic;
  const auto cells = read_cells(reader);
  reader.require("spacing", "add spacing = A, the lattice constant of the conventional cell");
  const auto spacing = reader.number("spacing", dimension::length, Allowed::positive);
  const Vector3 origin = reader.vector_or("origin", Vector3::Zero(), dimension::length);
  reader.finish();
  if (reader.reading().faults.size() != before || !cells || !spacing) return std::nullopt;
  double points = double(points_per_cell(kind));
  for (const Index c : *cells) points *= double(c);
  if (points > double(most_points)) {
    reader.reading().fault(
        reader.place_of("count"),
        fmt::format("count makes {:.3g} particles, at most {} are allowed", points, most_points), "lower it");
    return std::nullopt;
  }
  return lattice_points(kind, *cells, *spacing, origin);
}

}  // namespace

const std::vector<std::string>& generator_keys() {
  static const std::vector<std::string> keys{"line", "arc", "helix", "lattice"};
  return keys;
}

std::optional<std::vector<Vector3>> generated_points(TableReader& block, const std::string& key) {
  TableReader reader(block.reading(), *block.find(key), key);
  if (!block.find(key)->is_table()) return std::nullopt;
  if (key == "line") return read_line(reader);
  if (key == "lattice") return read_lattice(reader);
  return read_arc(reader, key == "helix");
}

}  // namespace bondstatic
