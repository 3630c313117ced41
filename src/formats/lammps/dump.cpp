#include "formats/lammps/dump.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "formats/lammps/columns.hpp"
#include "formats/lammps/dump_steps.hpp"
#include "formats/lammps/type_groups.hpp"
#include "formats/particle_ids.hpp"
#include "io/nearest_name.hpp"
#include "io/table_rows.hpp"

namespace bondstatic {
namespace {

constexpr Index lowest_image = std::numeric_limits<std::int32_t>::min();

/// One step's particles: which columns mean what, and their values.
struct Step {
  DumpRows rows;
  ParticleColumns columns;
  std::vector<int> slot;  ///< of a column in rows.values; -1: not read

  std::size_t count() const { return rows.line.size(); }
  double value(int column, std::size_t row) const {
    return rows.values[std::size_t(slot[std::size_t(column)])][row];
  }
  Vector3 vector(const std::array<int, 3>& of, std::size_t row) const {
    return {value(of[0], row), value(of[1], row), value(of[2], row)};
  }
};

std::optional<Step> read_step(const std::string& path, const ReadOptions& options, bool all_columns,
                              const Place& named_at, std::vector<Fault>& faults) {
  Step step;
  const auto choose = [&](const DumpHeader& header, std::vector<Fault>& wrong) {
    std::vector<WantedColumn> wanted;
    auto columns = particle_columns(header, path, wrong);
    if (!columns) return wanted;
    step.columns = std::move(*columns);
    step.slot.assign(header.columns.size(), -1);
    const auto want = [&](int column, std::optional<Index> whole_from = std::nullopt) {
      if (column < 0) return;
      step.slot[std::size_t(column)] = int(wanted.size());
      wanted.push_back({column, whole_from});
    };
    const auto want_three = [&](const ThreeColumns& three, std::optional<Index> whole_from = std::nullopt) {
      for (std::size_t i = 0; three && i < 3; ++i) want((*three)[i], whole_from);
    };
    const ParticleColumns& c = step.columns;
    want(c.id, 0);
    want(c.type, 1);
    want(c.radius);
    want(c.diameter);
    want_three(c.position);
    want_three(c.image, lowest_image);
    if (all_columns) {
      for (const ThreeColumns& three : {c.velocity, c.force, c.angular_velocity, c.torque}) want_three(three);
      for (const int column : c.quaternion) want(column);
    } else {
      want(c.mass);
      want(c.density);
    }
    return wanted;
  };
  auto rows = read_dump_rows(path, options, choose, named_at, faults);
  if (!rows) return std::nullopt;
  step.rows = std::move(*rows);
  if (step.count() > 0) return step;
  faults.push_back({{path, step.rows.header.columns_line, 1},
                    fmt::format("step {} has no particles", step.rows.header.step),
                    "ask for another step, or see which group was dumped"});
  return std::nullopt;
}

Vector3 position(const Step& step, std::size_t row) {
  Vector3 x = step.vector(step.columns.position, row);
  const auto& box = step.rows.header.box;
  if (step.columns.scaled) x = box->origin + box->edges * x;
  if (step.columns.image) x += box->edges * step.vector(*step.columns.image, row);
  return x;
}

/// Radii, faults where one is not positive; empty where the dump has none.
std::vector<double> radii(const Step& step, const std::string& path, std::vector<Fault>& faults) {
  const bool is_radius = step.columns.radius >= 0;
  const int column = is_radius ? step.columns.radius : step.columns.diameter;
  std::vector<double> radius;
  if (column < 0) return radius;
  LimitedFaults limited(faults);
  for (std::size_t i = 0; i < step.count(); ++i) {
    radius.push_back(step.value(column, i) / (is_radius ? 1 : 2));
    if (!(radius.back() > 0) &&
        !limited.add(
            {path, step.rows.line[i], 1},
            fmt::format("{} = {} must be positive", is_radius ? "radius" : "diameter", step.value(column, i)),
            "leave point particles out of the dump"))
      break;
  }
  return radius;
}

/// Nothing where the squares of some row do not add up to one: then the columns are something else.
std::vector<Eigen::Quaterniond> orientations(const Step& step) {
  constexpr double rounding = 1e-4;  // six digits, as dumps have unless a format is set
  const auto& q = step.columns.quaternion;
  std::vector<Eigen::Quaterniond> orientation;
  if (q[0] < 0) return orientation;
  orientation.reserve(step.count());
  for (std::size_t i = 0; i < step.count(); ++i) {
    const Eigen::Quaterniond found(step.value(q[0], i), step.value(q[1], i), step.value(q[2], i),
                                   step.value(q[3], i));
    if (!(std::abs(found.squaredNorm() - 1) <= rounding)) return {};
    orientation.push_back(found.normalized());
  }
  return orientation;
}

std::vector<Vector3> vectors(const Step& step, const ThreeColumns& columns) {
  std::vector<Vector3> values;
  if (!columns) return values;
  values.reserve(step.count());
  for (std::size_t i = 0; i < step.count(); ++i) values.push_back(step.vector(*columns, i));
  return values;
}

std::vector<Index> whole_numbers(const Step& step, int column) {
  std::vector<Index> values;
  if (column < 0) return values;
  values.reserve(step.count());
  for (std::size_t i = 0; i < step.count(); ++i) values.push_back(Index(step.value(column, i)));
  return values;
}

bool any_periodic(const std::optional<Cell>& box) {
  return box && (box->periodic[0] || box->periodic[1] || box->periodic[2]);
}

std::string about_positions(const Step& step) {
  const auto& names = step.rows.header.columns;
  std::string text = "Positions are from the columns";
  for (const int column : step.columns.position) text += " " + names[std::size_t(column)];
  if (step.columns.image) text += ", unwrapped by ix iy iz";
  return text + ".";
}

std::string about_quaternions(const Step& step) {
  const auto& names = step.rows.header.columns;
  return fmt::format(
      "{} ... {} are taken as quaternions (w, i, j, k): their squares add up to one everywhere.",
      names[std::size_t(step.columns.quaternion[0])], names[std::size_t(step.columns.quaternion[3])]);
}

}  // namespace

std::optional<ParticleState> read_lammps_dump_state(const std::string& path, const ReadOptions& options,
                                                    const Place& named_at, std::vector<Fault>& faults) {
  const auto step = read_step(path, options, true, named_at, faults);
  if (!step) return std::nullopt;
  const std::size_t before = faults.size();
  const DumpHeader& header = step->rows.header;
  const ParticleColumns& columns = step->columns;
  if (columns.id < 0) {
    faults.push_back({{path, header.columns_line, 1},
                      "the dump has no column id; its columns are " + name_list(header.columns),
                      "dump the column id, too: rows are in no certain order"});
    return std::nullopt;
  }
  ParticleState state;
  state.step = header.step;
  state.time = header.time;
  state.id = whole_numbers(*step, columns.id);
  table_of_ids("particle", state.id, step->rows.line, path, faults);
  state.type = whole_numbers(*step, columns.type);
  state.radius = radii(*step, path, faults);
  state.position.reserve(step->count());
  for (std::size_t i = 0; i < step->count(); ++i) state.position.push_back(position(*step, i));
  state.unwrapped =
      columns.unwrapped || columns.image || (header.boundary_known && !any_periodic(header.box));
  state.orientation = orientations(*step);
  state.velocity = vectors(*step, columns.velocity);
  state.angular_velocity = vectors(*step, columns.angular_velocity);
  state.force = vectors(*step, columns.force);
  state.torque = vectors(*step, columns.torque);
  if (any_periodic(header.box)) state.cell = header.box;
  state.notes = {about_step(step->rows) + ".", about_positions(*step)};
  if (columns.quaternion_guessed && !state.orientation.empty())
    state.notes.push_back(about_quaternions(*step));
  if (!columns.quaternion_guessed && columns.quaternion[0] >= 0 && state.orientation.empty())
    faults.push_back({{path, header.columns_line, header.column_at[std::size_t(columns.quaternion[0])]},
                      "quaternions whose squares do not add up to one within 1e-4",
                      "dump them with more digits, or leave them out"});
  if (faults.size() != before) return std::nullopt;
  return state;
}

std::optional<ForeignModel> read_lammps_dump(const std::string& path, const ReadOptions& options,
                                             const Place& named_at, std::vector<Fault>& faults) {
  auto step = read_step(path, options, false, named_at, faults);
  if (!step) return std::nullopt;
  const std::size_t before = faults.size();
  const DumpHeader& header = step->rows.header;
  const ParticleColumns& columns = step->columns;
  const std::vector<Index> ids = whole_numbers(*step, columns.id);
  table_of_ids("particle", ids, step->rows.line, path, faults);
  const std::vector<double> radius = radii(*step, path, faults);
  if (faults.size() != before) return std::nullopt;

  ForeignModel model;
  model.format = format_name(FileFormat::lammps_dump);
  model.particles.resize(step->count());
  for (std::size_t i = 0; i < step->count(); ++i) {
    Particle& particle = model.particles[i];
    particle.id = ids.empty() ? -1 : ids[i];
    particle.position = position(*step, i);
    particle.radius = radius.empty() ? not_given : radius[i];
    if (columns.density >= 0)
      particle.density = step->value(columns.density, i);
    else if (columns.mass >= 0 && !radius.empty())
      particle.density = step->value(columns.mass, i) / (4.0 / 3 * std::numbers::pi * std::pow(radius[i], 3));
    if (particle.density <= 0 || std::isinf(particle.density)) {
      faults.push_back({{path, step->rows.line[i], 1},
                        fmt::format("density or mass of particle {} must be positive", particle.id),
                        "correct it, or leave the column out of the dump"});
      return std::nullopt;
    }
  }
  group_by_type(whole_numbers(*step, columns.type), model);
  if (any_periodic(header.box))
    model.cell = header.box;
  else if (!header.boundary_known)
    model.box = header.box;
  model.si = header.units == "si";
  model.particle_line = std::move(step->rows.line);

  ImportNotes& notes = model.notes;
  notes.taken = {about_step(step->rows) + ".", about_positions(*step)};
  if (radius.empty())
    notes.left_out.push_back("The dump has no column radius or diameter: radii must be given.");
  if (columns.density < 0 && columns.mass >= 0 && !radius.empty())
    notes.assumed.push_back("Densities are those of solid spheres with the masses of the dump.");
  if (ids.empty()) notes.assumed.push_back("The dump has no column id: particles are numbered in its order.");
  if (header.units.empty())
    notes.assumed.push_back("The dump does not say its units: numbers are taken as they are.");
  std::vector<std::string> unused = columns.unused;
  for (const ThreeColumns& three :
       {columns.velocity, columns.force, columns.angular_velocity, columns.torque})
    for (std::size_t i = 0; three && i < 3; ++i) unused.push_back(header.columns[std::size_t((*three)[i])]);
  for (const int column : columns.quaternion)
    if (column >= 0) unused.push_back(header.columns[std::size_t(column)]);
  if (!unused.empty())
    notes.left_out.push_back("Columns that a model has no use for: " + name_list(unused) + ".");
  return model;
}

}  // namespace bondstatic
