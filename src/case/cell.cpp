#include "case/cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "case/table_reader.hpp"
#include "io/nearest_name.hpp"
#include "model/cell.hpp"
#include "model/hold_cell.hpp"

namespace bondstatic {
namespace {

const std::vector<std::string>& edge_names() {
  static const std::vector<std::string> names{"x", "y", "z"};
  return names;
}

std::optional<Matrix3> read_edges(TableReader& cell) {
  Reading& reading = cell.reading();
  const std::string way = cell.one_of(std::vector<std::string>{"size", "edges"});
  if (way == "size") {
    const auto size = cell.vector("size", dimension::length);
    if (!size) return std::nullopt;
    if (size->minCoeff() > 0) return Matrix3(size->asDiagonal());
    reading.fault(
        cell.place_of("size"),
        fmt::format("size = [{}, {}, {}] must be positive", size->x(), size->y(), size->z()),
        "give the lengths of the three edges; of a direction that is not periodic, how far the model goes");
    return std::nullopt;
  }
  Node* node = way == "edges" ? cell.find("edges") : nullptr;
  if (!node) return std::nullopt;
  if (!node->is_array() || node->items.size() != 3) {
    reading.fault(node->place, "edges must be three vectors",
                  "write edges = [[AX, AY, AZ], [BX, BY, BZ], [CX, CY, CZ]]");
    return std::nullopt;
  }
  Matrix3 edges;
  int i = 0;
  for (const Node& item : node->items) {
    const auto edge = read_vector(reading, item, fmt::format("edges[{}]", i), dimension::length);
    if (!edge) return std::nullopt;
    edges.col(i++) = *edge;
  }
  const double box = edges.colwise().norm().prod();
  if (std::abs(edges.determinant()) > 1e-6 * box) return edges;
  reading.fault(node->place, "the three edges lie in a plane", "give three independent vectors");
  return std::nullopt;
}

std::array<bool, 3> read_periodic(TableReader& cell) {
  const auto names = cell.texts("periodic");
  if (!names) {
    Node all;
    all.kind = Node::Kind::array;
    for (const std::string& name : edge_names()) all.items.push_back(Node::of(name));
    if (!cell.has("periodic")) cell.set_default("periodic", std::move(all));
    return {true, true, true};
  }
  std::array<bool, 3> periodic{};
  for (const std::string& name : *names) {
    const auto found = std::find(edge_names().begin(), edge_names().end(), name);
    if (found == edge_names().end())
      cell.reading().fault(
          cell.place_of("periodic"), fmt::format("periodic: there is no edge \"{}\"", name),
          fmt::format("name some of {}: the first, second and third edge", name_list(edge_names())));
    else
      periodic[std::size_t(found - edge_names().begin())] = true;
  }
  if (names->empty())
    cell.reading().fault(cell.place_of("periodic"), "periodic is empty", "name an edge, or remove [cell]");
  return periodic;
}

}  // namespace

void read_cell(Draft& draft, Node* table) {
  if (!table) return;
  TableReader cell(draft.reading, *table, "[cell]");
  Cell made;
  const auto edges = read_edges(cell);
  made.origin = cell.vector_or("origin", Vector3::Zero(), dimension::length);
  made.periodic = read_periodic(cell);
  cell.finish();
  if (draft.reading.purpose == Purpose::dynamics)
    draft.reading.fault(table->place, "[cell]: a run through time knows no periodic cell",
                        "use `bondstatic solve`, or a specimen between platens");
  if (!edges) return;
  made.edges = *edges;
  draft.model.cell = made;
}

void complete_cell(Draft& draft, bool has_loads, bool has_supports) {
  Model& model = draft.model;
  if (!model.cell || !draft.bonds_known) return;
  const auto periodic = std::count(model.cell->periodic.begin(), model.cell->periodic.end(), true);
  if (!has_supports && periodic >= 2) hold_translation(model);
  if (has_loads || periodic < 3 || model.load_cases != std::vector<std::string>{""}) return;
  model.load_cases.clear();
  for (const UnitStrain& unit : unit_strains()) {
    model.strains.push_back({unit.value, Index(model.load_cases.size())});
    model.load_cases.push_back(unit.name);
  }
}

std::optional<Matrix3> read_strain(Draft& draft, TableReader& block) {
  Node* node = block.find("strain");
  if (!node) return std::nullopt;
  const std::size_t before = draft.reading.faults.size();
  TableReader strain(draft.reading, *node, "strain");
  Matrix3 tensor = Matrix3::Zero();
  for (const UnitStrain& unit : unit_strains())
    if (const auto value = strain.number(unit.name, dimension::none))
      tensor(unit.row, unit.column) = tensor(unit.column, unit.row) = *value;
  strain.finish();
  if (draft.reading.faults.size() != before) return std::nullopt;
  if (!draft.model.cell) {
    draft.reading.fault(node->place, "strain, but there is no [cell]",
                        "add [cell] with its size, or prescribe the motion of particles by [[supports]]");
    return std::nullopt;
  }
  if (strain_across_ends(*draft.model.cell, tensor) > 1e-12 * tensor.cwiseAbs().maxCoeff()) {
    draft.reading.fault(node->place, "strain along a direction in which the cell is not periodic",
                        "such a strain is an answer: load or move the particles at the ends instead");
    return std::nullopt;
  }
  return tensor;
}

}  // namespace bondstatic
