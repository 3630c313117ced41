#include "formats/join_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/id_table.hpp"
#include "io/pair_set.hpp"

namespace bondstatic {
namespace {

constexpr std::size_t most_faults = 20;

/// Appends the faults of one kind, at most twenty and the number of the others.
class Kind {
 public:
  Kind(std::vector<Fault>& faults, std::string cure) : faults_(faults), cure_(std::move(cure)) {}
  ~Kind() {
    if (unsaid_ > 0) faults_.push_back({last_, fmt::format("and {} more of this kind", unsaid_), "as above"});
  }
  Kind(const Kind&) = delete;
  Kind& operator=(const Kind&) = delete;

  void add(const Place& place, const std::string& message) {
    last_ = {place.file, 0, 0};
    if (said_++ < most_faults)
      faults_.push_back({place, message, cure_});
    else
      ++unsaid_;
  }

 private:
  std::vector<Fault>& faults_;
  std::string cure_;
  Place last_;
  std::size_t said_ = 0, unsaid_ = 0;
};

Place line_of(const std::string& file, const std::vector<int>& lines, std::size_t row) {
  return row < lines.size() ? Place{file, lines[row], 1} : Place{file, 0, 0};
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// Columns of `count` rows that join columns of `before` rows; NaN where one side has none.
void append_columns(std::map<std::string, std::vector<double>>& to,
                    const std::map<std::string, std::vector<double>>& from, std::size_t before,
                    std::size_t count) {
  for (const auto& [name, values] : from) {
    std::vector<double>& column = to.try_emplace(name, before, not_given).first->second;
    append(column, values);
  }
  for (auto& [name, column] : to) column.resize(before + count, not_given);
}

void append_groups(ForeignModel& to, const ForeignModel& from, std::size_t before) {
  if (to.group.empty() && from.group.empty()) return;
  const auto number_of = [&](const std::string& name) {
    const auto found = std::find(to.group_names.begin(), to.group_names.end(), name);
    if (found != to.group_names.end()) return int(found - to.group_names.begin());
    to.group_names.push_back(name);
    return int(to.group_names.size()) - 1;
  };
  // A particle has one group or none: what has none gets the nameless one.
  if (to.group.empty() && before > 0) to.group.assign(before, number_of(""));
  if (from.group.empty() && !from.particles.empty()) {
    to.group.resize(before + from.particles.size(), number_of(""));
    return;
  }
  std::vector<int> number;
  for (const std::string& name : from.group_names) number.push_back(number_of(name));
  for (const int group : from.group) to.group.push_back(number[std::size_t(group)]);
}

void join_cell(ForeignModel& to, const ReadFile& from, std::vector<Fault>& faults) {
  for (const auto member : {&ForeignModel::cell, &ForeignModel::box}) {
    const std::optional<Cell>& other = from.model.*member;
    if (!other) continue;
    std::optional<Cell>& own = to.*member;
    if (own && (own->edges != other->edges || own->periodic != other->periodic))
      faults.push_back({{from.path, 0, 0},
                        "the box is not that of the files before",
                        "give files of one model at one step"});
    own = other;
  }
}

void number_particles(std::vector<ReadFile>& files) {
  Index largest = 0;
  for (const ReadFile& file : files)
    for (const Particle& particle : file.model.particles) largest = std::max(largest, particle.id);
  for (ReadFile& file : files)
    for (Particle& particle : file.model.particles)
      if (particle.id < 0) particle.id = ++largest;
}

void check_particles(const std::vector<ReadFile>& files, IdTable& position, std::vector<Fault>& faults) {
  Kind twice(faults, "give every particle once, with an id of its own");
  Kind not_finite(faults, "write finite numbers");
  Kind not_positive(faults, "correct the row or leave the particle out");
  Kind without(faults, "give all particles a radius, or none: the case then asks for one");
  Index next = 0;
  std::size_t with_radius = 0, all = 0;
  for (const ReadFile& file : files)
    for (const Particle& particle : file.model.particles) {
      ++all;
      with_radius += !std::isnan(particle.radius);
    }
  for (const ReadFile& file : files) {
    position.expect(Index(file.model.particles.size()));
    for (std::size_t i = 0; i < file.model.particles.size(); ++i, ++next) {
      const Particle& particle = file.model.particles[i];
      const auto place = [&] { return line_of(file.path, file.model.particle_line, i); };
      if (!position.add(particle.id, next))
        twice.add(place(), fmt::format("particle id {} is there twice", particle.id));
      if (!particle.position.allFinite())
        not_finite.add(place(), fmt::format("position ({}, {}, {}) must be finite", particle.position.x(),
                                            particle.position.y(), particle.position.z()));
      if (particle.radius <= 0 || std::isinf(particle.radius))
        not_positive.add(place(), fmt::format("radius = {} must be positive", particle.radius));
      if (particle.density <= 0 || std::isinf(particle.density))
        not_positive.add(place(), fmt::format("density = {} must be positive", particle.density));
      if (std::isnan(particle.radius) && with_radius > 0 && all > with_radius)
        without.add(place(), fmt::format("particle {} has no radius, others have", particle.id));
    }
  }
}

/// Returns how many bonds join a pair that another one joins already.
Index check_bonds(const std::vector<ReadFile>& files, const IdTable& position, std::vector<Fault>& faults) {
  Kind unknown(faults, "bonds join particles by their ids; give the file that has them, too");
  Kind self(faults, "give two different ids");
  Kind twice(faults, "give every bond an id of its own, or none");
  Index count = 0, again = 0;
  for (const ReadFile& file : files) count += Index(file.model.bonds.size());
  PairSet pairs(position.size(), count);
  IdTable ids;
  for (const ReadFile& file : files) {
    ids.expect(Index(file.model.bonds.size()));
    for (std::size_t k = 0; k < file.model.bonds.size(); ++k) {
      const ForeignBond& bond = file.model.bonds[k];
      const auto place = [&] { return line_of(file.path, file.model.bond_line, k); };
      const Index *a = position.position_of(bond.a), *b = position.position_of(bond.b);
      for (const auto& [found, id] : {std::pair(a, bond.a), std::pair(b, bond.b)})
        if (!found) unknown.add(place(), fmt::format("there is no particle {}", id));
      if (bond.a == bond.b) self.add(place(), fmt::format("the bond joins particle {} to itself", bond.a));
      if (bond.id >= 0 && !ids.add(bond.id, Index(k)))
        twice.add(place(), fmt::format("bond id {} is there twice", bond.id));
      if (a && b) again += !pairs.add(*a, *b);
    }
  }
  return again;
}

void number_bonds(ForeignModel& model) {
  Index largest = 0;
  for (const ForeignBond& bond : model.bonds) largest = std::max(largest, bond.id);
  for (ForeignBond& bond : model.bonds)
    if (bond.id < 0) bond.id = ++largest;
}

/// `to` and behind it `from`.
void join(ForeignModel& to, ReadFile& file, std::vector<Fault>& faults) {
  ForeignModel& from = file.model;
  join_cell(to, file, faults);
  append_groups(to, from, to.particles.size());
  append_columns(to.bond_columns, from.bond_columns, to.bonds.size(), from.bonds.size());
  append_columns(to.kept_columns, from.kept_columns, to.bonds.size(), from.bonds.size());
  append(to.particles, from.particles);
  append(to.bonds, from.bonds);
  if (to.title.empty()) to.title = from.title;
  if (to.si != from.si)
    to.notes.assumed.push_back(fmt::format(
        "Some of the files are in SI units, others ({}) do not say theirs: their numbers are taken as SI.",
        from.si ? to.format : from.format));
  to.format += ", " + from.format;
  to.si = to.si || from.si;
  append(to.notes.taken, from.notes.taken);
  append(to.notes.assumed, from.notes.assumed);
  append(to.notes.left_out, from.notes.left_out);
  from = {};
}

}  // namespace

std::optional<JoinedModel> join_models(std::vector<ReadFile> files, std::vector<Fault>& faults) {
  const std::size_t before = faults.size();
  number_particles(files);
  JoinedModel joined;
  {
    IdTable position;
    check_particles(files, position, faults);
    if (faults.size() == before) joined.parallel_bonds = check_bonds(files, position, faults);
  }
  if (faults.size() != before || files.empty()) return std::nullopt;
  ForeignModel& model = joined.model;
  model = std::move(files.front().model);
  model.particle_line = model.bond_line = {};
  for (std::size_t i = 1; i < files.size(); ++i) join(model, files[i], faults);
  if (faults.size() != before) return std::nullopt;
  number_bonds(model);
  if (joined.parallel_bonds > 0)
    model.notes.assumed.push_back(fmt::format(
        "{} bonds join pairs that are bonded already: all are kept, side by side.", joined.parallel_bonds));
  return joined;
}

}  // namespace bondstatic
