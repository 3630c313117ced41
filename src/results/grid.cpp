#include "results/grid.hpp"

#include <algorithm>
#include <numeric>

#include "io/vtu_writer.hpp"
#include "results/columns.hpp"
#include "results/owned.hpp"

namespace bondstatic {

namespace {

std::vector<Index> all_of(std::size_t count) {
  std::vector<Index> numbers(count);
  std::iota(numbers.begin(), numbers.end(), Index(0));
  return numbers;
}

std::vector<double> positions(const Model& model, const std::vector<Index>& particles) {
  std::vector<double> points;
  points.reserve(3 * particles.size());
  for (const Index p : particles) {
    const Vector3& position = model.particles[std::size_t(p)].position;
    points.insert(points.end(), position.begin(), position.end());
  }
  return points;
}

std::vector<Column> chosen(const std::vector<Column>& columns, const std::vector<Index>& rows) {
  std::vector<Column> of_rows;
  for (const Column& column : columns) of_rows.push_back(rows_of(column, rows));
  return of_rows;
}

/// What acts on a particle is only known where all of its bonds are.
void hide_reactions_of_copies(std::vector<Column>& columns, Index first_copy) {
  for (Column& column : columns)
    if (column.name.starts_with("reaction"))
      column.at = Column::Numbers<double>(
          [at = std::get<Column::Numbers<double>>(column.at),
           known = first_copy * column.components](Index i) { return i < known ? at(i) : not_given; });
}

}  // namespace

void write_grid(OutputFile& file, const Model& model, const State& state) {
  std::vector<Index> lines;
  lines.reserve(2 * model.bonds.size());
  for (const Bond& bond : model.bonds) lines.insert(lines.end(), {bond.a, bond.b});
  write_vtu(file, LineGrid{positions(model, all_of(model.particles.size())), lines, point_data(model, state),
                           bond_columns(model, state)});
}

void write_grid_piece(OutputFile& file, const Piece& piece, const State& state) {
  const Model& model = piece.model;
  const std::vector<Index> bonds = owned_bonds(piece);
  std::vector<Index> particles = all_of(model.particles.size());
  std::vector<Index> number(particles.size(), -1);  // as a point
  std::copy_n(particles.begin(), piece.own, number.begin());
  particles.resize(std::size_t(piece.own));
  std::vector<Index> lines;
  lines.reserve(2 * bonds.size());
  for (const Index k : bonds)
    for (const Index p : {model.bonds[std::size_t(k)].a, model.bonds[std::size_t(k)].b}) {
      Index& point = number[std::size_t(p)];
      if (point < 0) {
        point = Index(particles.size());
        particles.push_back(p);
      }
      lines.push_back(point);
    }
  const std::vector<Column> of_points = point_data(model, state), of_lines = bond_columns(model, state);
  std::vector<Column> points = chosen(of_points, particles);
  hide_reactions_of_copies(points, piece.own);
  write_vtu(file, LineGrid{positions(model, particles), lines, points, chosen(of_lines, bonds), piece.own});
}

void write_grid_of_pieces(OutputFile& file, const std::vector<std::string>& pieces) {
  const Model none;
  const State nothing;
  write_pvtu(file, point_data(none, nothing), bond_columns(none, nothing), pieces);
}

}  // namespace bondstatic
