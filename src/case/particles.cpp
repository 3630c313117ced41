#include "case/particles.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/generator_reader.hpp"
#include "case/particle_file.hpp"
#include "model/generators.hpp"

namespace bondstatic {
namespace {

/// The block's particles from its generator or file, radius and density filled in; nothing where at fault.
std::optional<ParticleRows> read_rows(TableReader& block) {
  Reading& reading = block.reading();
  const std::size_t before = reading.faults.size();
  std::vector<std::string> sources = generator_keys();
  sources.push_back("file");
  const std::string source = block.one_of(sources);

  std::optional<ParticleRows> rows;
  if (source == "file") {
    rows = read_particle_file(block);
  } else if (!source.empty()) {
    if (const auto points = generated_points(block, source)) {
      rows.emplace();
      rows->particles.resize(points->size());
      for (std::size_t i = 0; i < points->size(); ++i) rows->particles[i].position = (*points)[i];
    }
  }
  const auto radius = block.number("radius", dimension::length, Allowed::positive);
  const auto density = block.number("density", dimension::density, Allowed::positive);
  const bool file_has_radius = rows && rows->has_radius, file_has_density = rows && rows->has_density;
  if (block.has("radius") && file_has_radius)
    reading.fault(block.place_of("radius"), "radius is given here and in the file", "remove one of them");
  if (block.has("density") && file_has_density)
    reading.fault(block.place_of("density"), "density is given here and in the file", "remove one of them");
  if (!block.has("radius") && !file_has_radius && (rows || source != "file"))
    block.require("radius", source == "file"
                                ? "add radius = R here, or a column radius or diameter to the file"
                                : "add radius = R, of each particle");
  if (reading.faults.size() != before || !rows) return std::nullopt;
  for (Particle& particle : rows->particles) {
    if (radius) particle.radius = *radius;
    if (density) particle.density = *density;
  }
  return rows;
}

/// Jitter and removal, both from the block's seed.
void disturb(TableReader& block, ParticleRows* rows) {
  const std::string key = block.at_most_one_of(std::vector<std::string>{"jitter", "jitter_length"});
  const auto part = block.number("jitter", dimension::none, Allowed::not_negative);
  const auto length = block.number("jitter_length", dimension::length, Allowed::not_negative);
  const auto removal = block.number("removal", dimension::none, Allowed::not_negative);
  if (removal && *removal >= 1)
    block.reading().fault(block.place_of("removal"), fmt::format("removal = {} must be below 1", *removal),
                          "give the part of the particles to remove, e.g. 0.05");
  const bool random = part || length || removal;
  const Index seed = random ? block.whole_or("seed", 1, 0) : block.whole("seed", 0).value_or(1);
  if (!rows || (removal && *removal >= 1)) return;

  if (part || length) {
    std::vector<Vector3> points;
    std::vector<double> most;
    for (const Particle& particle : rows->particles) {
      points.push_back(particle.position);
      most.push_back(length ? *length : *part * particle.radius);
    }
    jitter(points, most, std::uint64_t(seed));
    for (std::size_t i = 0; i < points.size(); ++i) rows->particles[i].position = points[i];
  }
  if (removal && *removal > 0) {
    ParticleRows kept;
    const auto left = survivors(Index(rows->particles.size()), *removal, std::uint64_t(seed));
    if (!rows->places.empty()) rows->places.keep(left);
    for (const Index i : left) {
      kept.particles.push_back(rows->particles[std::size_t(i)]);
      if (!rows->groups.empty()) kept.groups.push_back(rows->groups[std::size_t(i)]);
    }
    rows->particles = std::move(kept.particles);
    rows->groups = std::move(kept.groups);
    if (rows->particles.empty())
      block.reading().fault(block.place_of("removal"), "removal leaves no particle of the block", "lower it");
  }
}

/// A density that is missing keeps nobody from reading the rest of the case. Whether a file that is at fault
/// has one cannot be told.
void require_density(TableReader& block, const ParticleRows* rows) {
  if (block.reading().purpose != Purpose::dynamics || block.has("density")) return;
  const bool from_file = block.has("file");
  if (from_file && (!rows || rows->has_density)) return;
  block.reading().fault(
      block.place(), "particles without density: a run through time needs the mass of every particle",
      from_file ? "add density = 2650, say (kg/m3 in SI), to the block, or a column density to its file"
                : "add density = 2650, say (kg/m3 in SI), to the block");
}

/// Adds the rows to the model; false where ids clash.
bool add_rows(Draft& draft, const TableReader& block, const ParticleRows& rows,
              const std::vector<std::string>& groups, Index& largest_id) {
  bool sound = true;
  draft.particle_of_id.expect(Index(rows.particles.size()));
  draft.model.particles.reserve(draft.model.particles.size() + rows.particles.size());
  for (std::size_t i = 0; i < rows.particles.size(); ++i) {
    Particle particle = rows.particles[i];
    if (!rows.has_id) particle.id = largest_id + 1;
    largest_id = std::max(largest_id, particle.id);
    const Index position = Index(draft.model.particles.size());
    if (!draft.particle_of_id.add(particle.id, position) && sound) {
      draft.reading.fault(rows.has_id ? rows.places[i] : block.place(),
                          fmt::format("particle id {} is there twice", particle.id),
                          "give every particle an id of its own, or leave the id column out");
      sound = false;
    }
    draft.model.particles.push_back(particle);
    const auto join = [&](const std::string& group) {
      std::vector<Index>& members = draft.groups[group];
      if (members.empty() || members.back() != position) members.push_back(position);
    };
    for (const std::string& group : groups) join(group);
    if (!rows.groups.empty() && !rows.groups[i].empty()) join(rows.groups[i]);
  }
  return sound;
}

}  // namespace

void read_particles(Draft& draft, Node* list) {
  Reading& reading = draft.reading;
  if (!list || (list->is_array() && list->items.empty())) {
    reading.fault(list ? list->place : Place{reading.file, 1, 1}, "the case has no [[particles]]",
                  "add a block [[particles]] with a line, arc, helix, lattice or file");
    draft.particles_known = false;
    return;
  }
  Index largest_id = 0;
  for_each_table(reading, list, "particles", [&](TableReader& block) {
    const std::size_t before = reading.faults.size();
    std::optional<ParticleRows> rows = read_rows(block);
    const std::vector<std::string> groups = block.texts("group").value_or(std::vector<std::string>{});
    disturb(block, rows ? &*rows : nullptr);
    if (rows && rows->cell && !draft.model.cell)
      reading.warnings.push_back(fmt::format(
          "{}:{}: the file's box is periodic, and the case has no [cell]: nothing goes on across its "
          "faces. `bondstatic import` writes that table",
          block.place_of("file").file, block.place_of("file").line));
    if (!rows || reading.faults.size() != before || !add_rows(draft, block, *rows, groups, largest_id))
      draft.particles_known = false;
    require_density(block, rows ? &*rows : nullptr);
  });
  if (draft.model.particles.empty()) draft.particles_known = false;
}

}  // namespace bondstatic
