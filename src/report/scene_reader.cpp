#include "report/scene_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bondstatic/error.hpp"
#include "bondstatic/model.hpp"
#include "report/column_meaning.hpp"

namespace bondstatic {

namespace {

using Of = Grid::Of;

bool is_colour(const GridArray& array) {
  return array.name != "id" && array.name != "a" && array.name != "b";
}

std::vector<double> rows_of(const std::vector<double>& numbers, const std::vector<Index>& places,
                            int components) {
  std::vector<double> rows;
  rows.reserve(places.size() * std::size_t(components));
  for (const Index place : places)
    for (int i = 0; i < components; ++i) rows.push_back(numbers[std::size_t(components * place + i)]);
  return rows;
}

std::vector<Index> rows_of(const std::vector<Index>& numbers, const std::vector<Index>& places) {
  std::vector<Index> rows;
  for (const Index place : places) rows.push_back(numbers[std::size_t(place)]);
  return rows;
}

bool has_a_number(const std::vector<double>& numbers) {
  return std::any_of(numbers.begin(), numbers.end(), [](double number) { return !std::isnan(number); });
}

}  // namespace

SceneReader::SceneReader(const Grid& first, bool si, const SceneLimits& limits, Blocks& blocks)
    : si_(si), blocks_(blocks), first_(first.path()) {
  const std::vector<bool> copies = first.copies();
  const Index particles = std::count(copies.begin(), copies.end(), false);
  const bool whole = particles <= limits.particles && first.count(Of::lines) <= limits.bonds;
  sample_ = take_sample(first, whole ? particles : limits.sampled_particles,
                        whole ? limits.bonds : limits.sampled_bonds);
  scene_.length_unit = unit_of("x", si);
  scene_.all_particles = sample_.all_particles;
  scene_.all_bonds = sample_.all_bonds;
  scene_.drawn_particles = sample_.drawn;
  ids_ = rows_of(first.whole_numbers(Of::points, "id"), sample_.points);
  bond_ids_ = rows_of(first.whole_numbers(Of::lines, "id"), sample_.lines);
  scene_.particle_id = blocks_.add_ids(ids_);
  scene_.bond_id = blocks_.add_ids(bond_ids_);
  scene_.bond_a = blocks_.add_rows(sample_.a);
  scene_.bond_b = blocks_.add_rows(sample_.b);
  place(first.positions());
  scene_.radius = blocks_.add_numbers(rows_of(first.numbers(Of::points, "radius"), sample_.points, 1));
  if (first.has(Of::lines, "radius"))
    if (const auto radius = rows_of(first.numbers(Of::lines, "radius"), sample_.lines, 1);
        has_a_number(radius))
      scene_.bond_radius = blocks_.add_numbers(radius);
}

double SceneReader::numbers_of(const Grid& grid) const {
  const auto components = [&](Of of) {
    int sum = 0;
    for (const GridArray& array : grid.arrays(of))
      if (is_colour(array)) sum += array.components;
    return sum;
  };
  const auto far_ends = double(sample_.points.size()) - double(sample_.drawn);
  return double(sample_.drawn) * components(Of::points) + 3 * far_ends +
         double(sample_.lines.size()) * components(Of::lines);
}

void SceneReader::add(const Grid& grid, const SceneState& state) {
  refuse_another_model(grid);
  PageState page{
      .load_case = state.load_case, .label = state.label, .step = state.step, .particle = {}, .bond = {}};
  add_columns(grid, Of::points, sample_.points, scene_.particle_columns, page.particle);
  add_columns(grid, Of::lines, sample_.lines, scene_.bond_columns, page.bond);
  scene_.states.push_back(std::move(page));
}

PageScene SceneReader::finish() {
  for (PageState& state : scene_.states) {
    state.particle.resize(scene_.particle_columns.size());
    state.bond.resize(scene_.bond_columns.size());
  }
  return std::move(scene_);
}

/// Positions from the middle of the model, so that single precision tells neighbours apart.
void SceneReader::place(const std::vector<double>& positions) {
  std::vector<double> rows = rows_of(positions, sample_.points, 3);
  const Eigen::Map<Eigen::Matrix3Xd> points(rows.data(), 3, Index(rows.size() / 3));
  // Halves, as the sum of two coordinates may be too large for a double.
  if (points.cols() > 0) scene_.origin = points.rowwise().minCoeff() / 2 + points.rowwise().maxCoeff() / 2;
  for (Index row = 0; row < points.cols(); ++row)
    for (int i = 0; i < 3; ++i) rows[std::size_t(3 * row + i)] -= scene_.origin[i];
  scene_.position = blocks_.add_numbers(rows, 3);
}

void SceneReader::refuse_another_model(const Grid& grid) const {
  const auto same = [&](Of of, const std::vector<Index>& places, const std::vector<Index>& ids) {
    const std::vector<Index> all = grid.whole_numbers(of, "id");
    for (std::size_t row = 0; row < places.size(); ++row)
      if (places[row] >= Index(all.size()) || all[std::size_t(places[row])] != ids[row]) return false;
    return true;
  };
  if (grid.count(Of::lines) == sample_.all_bonds && same(Of::points, sample_.points, ids_) &&
      same(Of::lines, sample_.lines, bond_ids_))
    return;
  throw InputError({{{grid.path()},
                     fmt::format("is of another model than {}", first_),
                     "solve the case again: the folder has files of different runs"}});
}

/// Far ends of bonds are not drawn: all that matters of them is where they go.
void SceneReader::add_columns(const Grid& grid, Grid::Of of, const std::vector<Index>& places,
                              std::vector<PageColumn>& columns, std::vector<BlockRef>& refs) {
  for (const GridArray& array : grid.arrays(of)) {
    if (!is_colour(array)) continue;
    std::vector<double> rows = rows_of(grid.numbers(of, array.name), places, array.components);
    if (of == Of::points && array.name != "radius" && array.name.find("displacement") == std::string::npos)
      std::fill(rows.begin() + sample_.drawn * array.components, rows.end(), not_given);
    if (!has_a_number(rows)) continue;
    const PageColumn column = page_column(array, si_);
    auto found = std::find_if(columns.begin(), columns.end(),
                              [&](const PageColumn& one) { return one.name == column.name; });
    if (found == columns.end()) found = columns.insert(found, column);
    refs.resize(columns.size());
    refs[std::size_t(found - columns.begin())] = blocks_.add_numbers(rows, array.components);
  }
}

}  // namespace bondstatic
