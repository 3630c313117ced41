// Particles from the columns of a table.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "formats/particle_ids.hpp"
#include "formats/table/column_units.hpp"
#include "formats/table/model.hpp"

namespace bondstatic {
namespace {

constexpr Dimension mass_dimension{1, 0, 0}, volume_dimension{0, 3, 0};

double ball_volume(double radius) {
  return 4.0 / 3 * std::numbers::pi * radius * radius * radius;
}

/// Radii by the best there is: radius, diameter, or volume of spheres.
void take_radii(TableColumn* radius, TableColumn* diameter, TableColumn* volume, ForeignModel& model,
                std::vector<Fault>& faults) {
  if (radius && diameter)
    faults.push_back(
        {diameter->place, "radius and diameter exclude each other", "remove or rename one of them"});
  const TableColumn* given = radius ? radius : diameter ? diameter : volume;
  if (!given) return;
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    const double number = given->numbers[i];
    model.particles[i].radius = given == radius     ? number
                                : given == diameter ? number / 2
                                                    : std::cbrt(3 * number / (4 * std::numbers::pi));
  }
  if (given == volume)
    model.notes.assumed.push_back(
        "Radii are those of spheres with the volumes of the table, which has neither radius nor diameter.");
}

void take_densities(TableColumn* density, TableColumn* mass, TableColumn* volume, ForeignModel& model) {
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    Particle& particle = model.particles[i];
    if (density)
      particle.density = density->numbers[i];
    else if (mass)
      particle.density = mass->numbers[i] / (volume ? volume->numbers[i] : ball_volume(particle.radius));
  }
}

}  // namespace

Wanted wanted_of_particles(const std::string& name) {
  for (const Aliases* axis : {&columns::x, &columns::y, &columns::z})
    if (among(name, *axis)) return Wanted::number;
  for (const Aliases* size :
       {&columns::radius, &columns::diameter, &columns::volume, &columns::mass, &columns::density})
    if (among(name, *size)) return Wanted::positive;
  if (among(name, columns::particle_id)) return Wanted::whole;
  if (among(name, columns::group) || among(name, columns::kind)) return Wanted::word;
  return Wanted::no;
}

void take_particles(TableColumns& table, ForeignModel& model, std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  TableColumn* axes[3] = {table.find(columns::x, faults), table.find(columns::y, faults),
                          table.find(columns::z, faults)};
  TableColumn* id = table.find(columns::particle_id, faults);
  TableColumn* radius = table.find(columns::radius, faults);
  TableColumn* diameter = table.find(columns::diameter, faults);
  TableColumn* volume = table.find(columns::volume, faults);
  TableColumn* mass = table.find(columns::mass, faults);
  TableColumn* density = table.find(columns::density, faults);
  TableColumn* group = table.find(columns::group, faults);
  for (TableColumn& column : table.columns)
    if (!group && among(column.heading.name, columns::kind)) group = &column;
  UnitsSeen units;
  for (TableColumn* axis : axes) bring_to_si(*axis, dimension::length, units, faults);
  for (TableColumn* size : {radius, diameter})
    if (size) bring_to_si(*size, dimension::length, units, faults);
  if (volume) bring_to_si(*volume, volume_dimension, units, faults);
  if (mass) bring_to_si(*mass, mass_dimension, units, faults);
  if (density) bring_to_si(*density, dimension::density, units, faults);
  if (faults.size() != before) return;
  if (id) table_of_ids("particle", {id->numbers.begin(), id->numbers.end()}, table.line, table.file, faults);

  model.particles.resize(table.rows());
  for (std::size_t i = 0; i < model.particles.size(); ++i) {
    Particle& particle = model.particles[i];
    for (int axis = 0; axis < 3; ++axis) particle.position[axis] = axes[axis]->numbers[i];
    particle.id = id ? Index(id->numbers[i]) : -1;
    particle.radius = not_given;
  }
  take_radii(radius, diameter, volume, model, faults);
  const bool sized = radius || diameter || volume;
  const bool of_mass = mass && sized && !density;
  take_densities(density, of_mass ? mass : nullptr, volume, model);
  if (group) {
    model.group_names = std::move(group->words);
    model.group.assign(group->numbers.begin(), group->numbers.end());
  }
  model.particle_line = std::move(table.line);

  model.si = note_units(units, table.edem, model.notes);
  std::string what = fmt::format("{} particles", model.particles.size());
  if (std::isfinite(table.time)) what += fmt::format(" at time {}", table.time);
  if (group) what += fmt::format(", groups by \"{}\"", group->heading.text);
  model.notes.taken.push_back(what + ".");
  if (!id) model.notes.assumed.push_back("The file has no ids: particles are numbered in its order.");
  if (of_mass)
    model.notes.assumed.push_back("Densities are masses over volumes, as the file has no densities.");
  note_columns_left(table,
                    {axes[0], axes[1], axes[2], id, group, radius, diameter, density,
                     of_mass || !(radius || diameter) ? volume : nullptr, of_mass ? mass : nullptr},
                    "not taken", model.notes);
}

}  // namespace bondstatic
