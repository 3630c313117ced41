#include "compare/match.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/turning.hpp"
#include "io/id_table.hpp"
#include "model/cell.hpp"

namespace bondstatic {

namespace {

constexpr std::size_t most_faults = 20;

/// A run that has not even this part of the case's particles is one of another packing.
constexpr double fewest = 0.5;
/// Relative, on radii, where files have six digits.
constexpr double same_radius = 1e-4;

/// Places of two clouds of the same particles, and what brings one nearest to the other.
struct Clouds {
  Vector3 shift = Vector3::Zero();  ///< mean displacement beyond the static one
  double spread = 0;                ///< root mean square of the case's places about their mean
  double moved = 0;                 ///< of the displacements, static ones taken off
  double scattered = 0;             ///< of what the shift leaves of them
  double scale = 1;                 ///< of the run's places about their mean over the case's, best fit
  double misfit = 0;                ///< of the scaled ones, over the spread of the run's
};

Clouds clouds_of(const std::vector<Vector3>& at, const std::vector<Vector3>& before,
                 const std::vector<Vector3>& expected) {
  const double count = double(at.size());
  Vector3 mean = Vector3::Zero(), mean_before = mean, mean_expected = mean;
  for (std::size_t i = 0; i < at.size(); ++i)
    mean += at[i] / count, mean_before += before[i] / count, mean_expected += expected[i] / count;
  Clouds c;
  c.shift = mean - mean_before - mean_expected;
  double product = 0, run_spread = 0, left = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Vector3 x = at[i] - mean, b = before[i] - mean_before, d = at[i] - before[i] - expected[i];
    c.spread += b.squaredNorm();
    run_spread += x.squaredNorm();
    product += x.dot(b);
    c.moved += d.squaredNorm();
    c.scattered += (d - c.shift).squaredNorm();
  }
  if (c.spread > 0) c.scale = product / c.spread;
  for (std::size_t i = 0; i < at.size(); ++i)
    left += (at[i] - mean - c.scale * (before[i] - mean_before)).squaredNorm();
  c.misfit = run_spread > 0 ? std::sqrt(left / run_spread) : 0;
  for (double* sum : {&c.spread, &c.moved, &c.scattered}) *sum = std::sqrt(*sum / count);
  return c;
}

/// What makes these places none of this case, as a fault. Displacements are small parts of a packing, so a
/// tenth of its size, or as much moved all together, is something else.
std::optional<Fault> other_places(const Clouds& c, double static_size, const Place& at) {
  const double much = std::max(0.1 * c.spread, 3 * static_size);
  if (c.spread > 0 && std::abs(c.scale - 1) > 0.1 && c.misfit < 0.05)
    return Fault{at, fmt::format("positions are {:.6g} times the case's", c.scale),
                 "the run is in other units: write it, or the case, in the same ones"};
  const double shift = c.shift.norm();
  if (shift > 0.01 * c.spread && shift > 3 * static_size && c.scattered < 0.05 * shift)
    return Fault{
        at,
        fmt::format("all particles are shifted by ({:.6g}, {:.6g}, {:.6g}) from the case's positions",
                    c.shift.x(), c.shift.y(), c.shift.z()),
        "the run has another origin: take the shift off the dump, or give the case the positions that "
        "the run starts from"};
  if (c.moved > much)
    return Fault{
        at,
        fmt::format("particles are {:.3g} from the case's positions (root mean square), in a packing of "
                    "the size {:.3g}",
                    c.moved, c.spread),
        "this is another packing, or one with other ids: give the case that the run starts from"};
  return {};
}

void check_ids(const Model& model, const RunState& run, const Place& at, std::vector<Fault>& faults) {
  const double all = double(model.particles.size());
  if (all - double(run.missing.size()) < fewest * all)
    faults.push_back(
        {at,
         fmt::format("only {} of the case's {} particles are in the run",
                     model.particles.size() - run.missing.size(), model.particles.size()),
         "this is the run of another packing, or ids were given anew: give the case that the run "
         "starts from"});
}

void note_radii(const Model& model, const ParticleState& state, const IdTable& row_of, RunState& run) {
  if (state.radius.empty()) return;
  double worst = 0;
  Index at = -1;
  for (const Particle& particle : model.particles) {
    const Index* row = row_of.position_of(particle.id);
    if (!row) continue;
    const double apart = std::abs(state.radius[std::size_t(*row)] / particle.radius - 1);
    if (apart > worst) worst = apart, at = particle.id;
  }
  if (worst > same_radius)
    run.notes.push_back(fmt::format(
        "Radii differ from the case's, most at particle {}, by {:.2g} of its radius.", at, worst));
}

std::vector<Vector6> pairs_of(const Model& model, const IdTable& row_of, const std::vector<Vector3>& first,
                              const std::vector<Vector3>& second) {
  if (first.empty() && second.empty()) return {};
  std::vector<Vector6> values(model.particles.size(), Vector6::Constant(not_given));
  for (std::size_t p = 0; p < values.size(); ++p) {
    const Index* row = row_of.position_of(model.particles[p].id);
    if (!row) continue;
    if (!first.empty()) values[p].head<3>() = first[std::size_t(*row)];
    if (!second.empty()) values[p].tail<3>() = second[std::size_t(*row)];
  }
  return values;
}

/// The particle that alone says where a periodic cell lies; -1 where several do, or none.
Index holder_of_cell(const Model& model) {
  Index holder = -1;
  for (const Support& support : model.supports) {
    if (!support.fixed[0] && !support.fixed[1] && !support.fixed[2]) continue;
    if (holder >= 0 && holder != support.particle) return -1;
    holder = support.particle;
  }
  return model.cell ? holder : -1;
}

/// What brings the particle that alone holds a cell to where the static answer has it: strain moves a run
/// about its own fixed point.
Vector3 shift_of_run(const Model& model, const State& statics, const ParticleState& state,
                     const IdTable& row_of, const Cell& cell, RunState& run) {
  const Index holder = holder_of_cell(model);
  if (holder < 0) return Vector3::Zero();
  const Particle& particle = model.particles[std::size_t(holder)];
  const Index* row = row_of.position_of(particle.id);
  if (!row) return Vector3::Zero();
  Vector3 shift = particle.position + statics.displacement[std::size_t(holder)].head<3>() -
                  state.position[std::size_t(*row)];
  if (!shift.allFinite()) return Vector3::Zero();
  shift -= shift_of(cell, nearest_image(cell, -shift).image);
  if (!shift.isZero(0))
    run.notes.push_back(fmt::format(
        "The run is shifted by ({:.6g}, {:.6g}, {:.6g}), so that particle {} lies where the static "
        "answer has it: nothing else says where the periodic cell is.",
        shift.x(), shift.y(), shift.z(), particle.id));
  return shift;
}

}  // namespace

std::optional<RunState> match_particles(const Model& model, const State& statics, const ParticleState& state,
                                        const std::string& file, std::vector<Fault>& faults) {
  const Place place{file, 0, 0};
  const std::size_t before = faults.size();
  IdTable row_of;
  row_of.expect(Index(state.id.size()));
  std::size_t doubled = 0;
  for (std::size_t row = 0; row < state.id.size(); ++row)
    if (!row_of.add(state.id[row], Index(row)) && ++doubled <= most_faults)
      faults.push_back({place, fmt::format("particle {} comes twice in step {}", state.id[row], state.step),
                        "each particle may stand once in a step"});
  if (doubled > most_faults)
    faults.push_back({place, fmt::format("and {} more that come twice", doubled - most_faults), "as above"});

  RunState run;
  run.name = file;
  run.step = state.step;
  run.notes = state.notes;
  run.has_rotations = !state.orientation.empty();
  run.displacement.assign(model.particles.size(), Vector6::Constant(not_given));
  const std::optional<Cell>& cell = state.cell ? state.cell : model.cell;
  const Vector3 shift =
      cell ? shift_of_run(model, statics, state, row_of, *cell, run) : Vector3(Vector3::Zero());
  std::vector<Vector3> at, was, expected;
  double static_size = 0;
  Index known = 0;
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    const Particle& particle = model.particles[p];
    const Index* row = row_of.position_of(particle.id);
    if (!row) {
      run.missing.push_back(particle.id);
      continue;
    }
    ++known;
    Vector3 moved = state.position[std::size_t(*row)] + shift - particle.position;
    if (cell) moved += shift_of(*cell, nearest_image(*cell, moved).image);
    run.displacement[p].head<3>() = moved;
    if (run.has_rotations)
      run.displacement[p].tail<3>() = rotation_vector(state.orientation[std::size_t(*row)].normalized());
    const Vector3 answer = statics.displacement[p].head<3>();
    if (!answer.allFinite()) continue;
    at.push_back(particle.position + moved);
    was.push_back(particle.position);
    expected.push_back(answer);
    static_size += answer.squaredNorm();
  }
  if (known < row_of.size()) {
    IdTable ours;
    ours.expect(Index(model.particles.size()));
    for (const Particle& particle : model.particles) ours.add(particle.id, 0);
    for (const Index id : state.id)
      if (!ours.position_of(id)) run.unknown.push_back(id);
  }
  check_ids(model, run, place, faults);
  if (faults.size() > before) return {};
  if (!at.empty())
    if (const auto fault =
            other_places(clouds_of(at, was, expected), std::sqrt(static_size / double(at.size())), place)) {
      faults.push_back(*fault);
      return {};
    }
  note_radii(model, state, row_of, run);
  run.velocity = pairs_of(model, row_of, state.velocity, state.angular_velocity);
  run.net_force = pairs_of(model, row_of, state.force, state.torque);
  if (state.velocity.empty()) run.velocity.clear();
  if (state.force.empty()) run.net_force.clear();
  return run;
}

}  // namespace bondstatic
