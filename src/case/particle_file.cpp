#include "case/particle_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/foreign_file.hpp"
#include "formats/join_models.hpp"
#include "formats/table/column_names.hpp"
#include "io/nearest_name.hpp"
#include "io/table.hpp"

namespace bondstatic {
namespace {

enum { x, y, z, id, radius, diameter, density, group, count };

/// By what they mean, in the order above.
const Aliases& aliases(int what) {
  static const Aliases* const names[count] = {
      &own_columns::x,      &own_columns::y,        &own_columns::z,       &own_columns::particle_id,
      &own_columns::radius, &own_columns::diameter, &own_columns::density, &own_columns::group};
  return *names[what];
}

void warn_unused(TableReader& block, const Table& table, const std::vector<int>& used) {
  std::vector<std::string> unused;
  for (std::size_t c = 0; c < table.names().size(); ++c)
    if (std::find(used.begin(), used.end(), int(c)) == used.end()) unused.push_back(table.names()[c]);
  if (!unused.empty())
    block.reading().warnings.push_back(
        fmt::format("{}: columns not used: {}", table.place(-1, -1).file, name_list(unused)));
}

std::vector<double> positive(const Table& table, int column, std::vector<Fault>& faults) {
  std::vector<double> values = table.numbers(column, false, faults);
  for (std::size_t row = 0; row < values.size(); ++row)
    if (values[row] <= 0) {
      faults.push_back(
          {table.place(Index(row), column),
           fmt::format("{} = {} must be positive", table.names()[std::size_t(column)], values[row]),
           "correct the row or leave the particle out"});
      break;
    }
  return values;
}

/// Rows of another code's file; nothing, and faults, where they are unsound.
std::optional<ParticleRows> rows_of(ForeignModel model, const std::string& path, std::vector<Fault>& faults) {
  const auto any = [&](auto&& has) {
    return std::any_of(model.particles.begin(), model.particles.end(), has);
  };
  ParticleRows rows;
  rows.has_id = any([](const Particle& particle) { return particle.id >= 0; });
  rows.has_radius = any([](const Particle& particle) { return !std::isnan(particle.radius); });
  rows.has_density = any([](const Particle& particle) { return !std::isnan(particle.density); });
  rows.places = RowPlaces(path, model.particle_line, model.particles.size());
  std::vector<ReadFile> files(1);
  files.front() = {path, std::move(model)};
  auto joined = join_models(std::move(files), faults);
  if (!joined) return std::nullopt;
  ForeignModel& sound = joined->model;
  rows.particles = std::move(sound.particles);
  for (const int group : sound.group) rows.groups.push_back(sound.group_names[std::size_t(group)]);
  rows.cell = sound.cell;
  return rows;
}

}  // namespace

std::optional<ParticleRows> read_particle_file(TableReader& block) {
  std::vector<Fault>& faults = block.reading().faults;
  const std::size_t before = faults.size();
  const auto path = block.path("file");
  if (!path) return std::nullopt;
  accept_foreign_keys(block, WantedOf::particles);
  if (is_foreign_file(*path)) {
    auto model = read_foreign_file(block, *path, WantedOf::particles);
    return model ? rows_of(std::move(*model), *path, faults) : std::nullopt;
  }
  const auto table = read_table(*path, block.place_of("file"), faults, block.reading().threads);
  // A table without this project's columns may be another code's.
  const auto other_code = [&]() -> std::optional<ParticleRows> {
    auto model = try_foreign_table(block, *path, WantedOf::particles, aliases(x));
    if (!model) return std::nullopt;
    faults.resize(before);
    return rows_of(std::move(*model), *path, faults);
  };
  if (!table) return other_code();

  std::vector<int> column(count);
  for (int what = 0; what < count; ++what) column[std::size_t(what)] = table->find(aliases(what), faults);
  if (column[x] < 0 && column[y] < 0 && column[z] < 0)
    if (auto rows = other_code()) return rows;
  for (const int what : {x, y, z})
    if (column[std::size_t(what)] < 0)
      faults.push_back(
          {table->place(-1, -1),
           fmt::format("no column {}; found: {}", aliases(what).front(), name_list(table->names())),
           fmt::format("name it one of: {}", name_list(aliases(what)))});
  if (column[radius] >= 0 && column[diameter] >= 0)
    faults.push_back({table->place(-1, column[diameter]), "radius and diameter exclude each other",
                      "remove or rename one of them"});
  if (faults.size() != before) return std::nullopt;
  warn_unused(block, *table, column);

  ParticleRows rows;
  rows.particles.resize(std::size_t(table->rows()));
  for (Particle& particle : rows.particles) {
    particle.id = -1;
    particle.radius = not_given;
  }
  rows.places = RowPlaces(*table, std::max(column[id], 0));
  for (const int axis : {x, y, z}) {
    const std::vector<double> values = table->numbers(column[std::size_t(axis)], false, faults);
    for (std::size_t i = 0; i < values.size(); ++i) rows.particles[i].position[axis] = values[i];
  }
  if ((rows.has_id = column[id] >= 0)) {
    const std::vector<Index> ids = table->whole_numbers(column[id], faults);
    for (std::size_t i = 0; i < ids.size(); ++i) rows.particles[i].id = ids[i];
  }
  if ((rows.has_radius = column[radius] >= 0 || column[diameter] >= 0)) {
    const bool halve = column[radius] < 0;
    const std::vector<double> values = positive(*table, halve ? column[diameter] : column[radius], faults);
    for (std::size_t i = 0; i < values.size(); ++i)
      rows.particles[i].radius = halve ? values[i] / 2 : values[i];
  }
  if ((rows.has_density = column[density] >= 0)) {
    const std::vector<double> values = positive(*table, column[density], faults);
    for (std::size_t i = 0; i < values.size(); ++i) rows.particles[i].density = values[i];
  }
  if (column[group] >= 0) rows.groups = table->texts(column[group]);
  if (faults.size() != before) return std::nullopt;
  return rows;
}

}  // namespace bondstatic
