#include "results/grid.hpp"

#include <algorithm>
#include <numeric>

#include "io/vtu_writer.hpp"
#include "model/cell.hpp"
#include "results/columns.hpp"
#include "results/owned.hpp"

namespace bondstatic {

namespace {

/// Points of the grid: particles first, then copies of particles, of other ranks or across a periodic face.
struct Points {
  std::vector<Index> particle;  ///< of each point
  Index own = 0;                ///< points 0 ... own-1 are no copies
  std::vector<std::pair<Index, Vector3>>
      shifted;               ///< ascending points, and how far from the particle they lie
  std::vector<Index> lines;  ///< two points a bond

  explicit Points(Index first_particles) : particle(std::size_t(first_particles)), own(first_particles) {
    std::iota(particle.begin(), particle.end(), Index(0));
  }
  Index add(Index copied) {
    particle.push_back(copied);
    return Index(particle.size()) - 1;
  }
};

/// A line across a periodic face ends beside the face, not at the other end of the cell. `point_of` gives the
/// point of a particle.
template <class PointOf>
void add_line(Points& points, const Model& model, const Bond& bond, PointOf point_of) {
  points.lines.push_back(point_of(bond.a));
  const Vector3 shift = shift_of_end(model, bond);
  if (shift.isZero(0)) {
    points.lines.push_back(point_of(bond.b));
    return;
  }
  points.lines.push_back(points.add(bond.b));
  points.shifted.emplace_back(points.lines.back(), shift);
}

std::vector<double> positions(const Model& model, const Points& points) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.particle.size());
  for (const Index p : points.particle) {
    const Vector3& position = model.particles[std::size_t(p)].position;
    coordinates.insert(coordinates.end(), position.begin(), position.end());
  }
  for (const auto& [point, shift] : points.shifted)
    for (int i = 0; i < 3; ++i) coordinates[std::size_t(3 * point + i)] += shift[i];
  return coordinates;
}

/// Across a periodic face, displacement has grown by what the cell's strain has moved the image.
void strain_images(std::vector<Column>& columns, const Points& points, const Matrix3& strain) {
  if (strain.isZero(0) || points.shifted.empty()) return;
  for (Column& column : columns)
    if (column.name == "displacement" || column.name == "run_displacement")
      column.at = Column::Numbers<double>([at = std::get<Column::Numbers<double>>(column.at), &points,
                                           strain](Index i) {
        const auto found = std::lower_bound(points.shifted.begin(), points.shifted.end(), i / 3,
                                            [](const auto& one, Index point) { return one.first < point; });
        if (found == points.shifted.end() || found->first != i / 3) return at(i);
        return at(i) + strain.row(i % 3).dot(found->second);
      });
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

void write_grid(OutputFile& file, const Model& model, const State& state,
                const std::vector<Column>& more_of_particles, const std::vector<Column>& more_of_bonds) {
  Points points{Index(model.particles.size())};
  points.lines.reserve(2 * model.bonds.size());
  for (const Bond& bond : model.bonds) add_line(points, model, bond, [](Index p) { return p; });
  std::vector<Column> of_points = point_data(model, state),
                      of_lines = line_data(model, state, file.threads());
  of_points.insert(of_points.end(), more_of_particles.begin(), more_of_particles.end());
  of_lines.insert(of_lines.end(), more_of_bonds.begin(), more_of_bonds.end());
  if (points.shifted.empty()) {
    write_vtu(file, LineGrid{positions(model, points), points.lines, of_points, of_lines});
    return;
  }
  std::vector<Column> with_images = chosen(of_points, points.particle);
  hide_reactions_of_copies(with_images, points.own);
  strain_images(with_images, points, state.strain);
  write_vtu(file, LineGrid{positions(model, points), points.lines, with_images, of_lines, points.own});
}

void write_grid_piece(OutputFile& file, const Piece& piece, const State& state) {
  const Model& model = piece.model;
  const std::vector<Index> bonds = owned_bonds(piece);
  Points points{piece.own};
  std::vector<Index> number(model.particles.size(), -1);  // as a point
  std::iota(number.begin(), number.begin() + piece.own, Index(0));
  points.lines.reserve(2 * bonds.size());
  for (const Index k : bonds)
    add_line(points, model, model.bonds[std::size_t(k)], [&](Index p) {
      Index& point = number[std::size_t(p)];
      return point < 0 ? point = points.add(p) : point;
    });
  const std::vector<Column> of_points = point_data(model, state),
                            of_lines = line_data(model, state, file.threads());
  std::vector<Column> data = chosen(of_points, points.particle);
  hide_reactions_of_copies(data, points.own);
  strain_images(data, points, state.strain);
  write_vtu(file,
            LineGrid{positions(model, points), points.lines, data, chosen(of_lines, bonds), points.own});
}

void write_grid_of_pieces(OutputFile& file, const std::vector<std::string>& pieces) {
  const Model none;
  const State nothing;
  write_pvtu(file, point_data(none, nothing), line_data(none, nothing, 1), pieces);
}

}  // namespace bondstatic
