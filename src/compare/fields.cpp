#include "compare/fields.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "system/natural_form.hpp"

namespace bondstatic {

namespace {

/// A field that is a part of this of what its kind could be counts as vanishing.
constexpr double vanishing = 1e-3;

constexpr std::size_t most_worst = 10;

/// Three numbers a particle or a bond, of the static answer and of the run.
struct Field {
  std::string name;
  bool of_bond;
  bool force;
  bool angular;
  std::size_t count;
  std::function<Vector3(std::size_t)> statics, run;
};

struct Size {
  double norm = 0, largest = 0;
};

bool told(const Vector3& a, const Vector3& b) {
  return a.allFinite() && b.allFinite();
}

Size size_of(const Field& field) {
  Size size;
  for (std::size_t i = 0; i < field.count; ++i) {
    const Vector3 value = field.statics(i);
    if (!told(value, field.run(i))) continue;
    size.norm = std::hypot(size.norm, value.stableNorm());
    size.largest = std::max(size.largest, value.stableNorm());
  }
  return size;
}

double ratio(double part, double whole) {
  return part == 0 ? 0 : part / whole;
}

FieldComparison comparison_of(const Field& field, const Size& scale) {
  FieldComparison out;
  out.field = field.name;
  out.of_bond = field.of_bond;
  double difference = 0, run_norm = 0;
  for (std::size_t i = 0; i < field.count; ++i) {
    const Vector3 s = field.statics(i), r = field.run(i);
    if (!told(s, r)) continue;
    const double apart = (r - s).stableNorm();
    difference = std::hypot(difference, apart);
    run_norm = std::hypot(run_norm, r.stableNorm());
    if (apart > out.largest || out.at < 0) out.largest = apart, out.at = Index(i);
  }
  const Size own = size_of(field);
  out.static_norm = own.norm;
  out.run_norm = run_norm;
  out.difference = ratio(difference, scale.norm);
  out.largest = ratio(out.largest, scale.largest);
  if (!(own.norm > 0)) return out;
  double product = 0;  // of unit vectors: no square of a small number underflows
  for (std::size_t i = 0; i < field.count; ++i) {
    const Vector3 s = field.statics(i) / own.norm, r = field.run(i) / own.norm;
    if (told(s, r)) product += s.dot(r);
  }
  out.scale = product;
  double left = 0;
  for (std::size_t i = 0; i < field.count; ++i) {
    const Vector3 apart = field.run(i) - product * field.statics(i);
    if (apart.allFinite()) left = std::hypot(left, apart.stableNorm());
  }
  out.misfit = ratio(left, scale.norm);
  return out;
}

std::vector<Field> fields_of(const Model& model, const State& statics, const RunState& run) {
  std::vector<Field> fields;
  const std::size_t particles = model.particles.size(), bonds = model.bonds.size();
  const auto motion = [&](const char* name, int first) {
    fields.push_back(
        {name, false, false, first == 3, particles,
         [&statics, first](std::size_t i) { return Vector3(statics.displacement[i].segment<3>(first)); },
         [&run, first](std::size_t i) { return Vector3(run.displacement[i].segment<3>(first)); }});
  };
  motion("displacement", 0);
  if (run.has_rotations) motion("rotation", 3);
  if (run.bond_force.empty()) return fields;

  /// Along the branch, or across it, of force or moment.
  const auto carried = [&](const char* name, int first, bool along) {
    const auto part = [&model, first, along](std::size_t k, const Vector6& value) {
      const Vector3 axis = model.bonds[k].branch.normalized(), v = value.segment<3>(first);
      const double part_along = v.dot(axis);
      return along ? Vector3(-part_along, 0, 0) : Vector3(v - part_along * axis);
    };
    fields.push_back({name, true, true, first == 3, bonds,
                      [&statics, part](std::size_t k) { return part(k, statics.bonds[k].force); },
                      [&run, part](std::size_t k) { return part(k, run.bond_force[k]); }});
  };
  carried("normal force", 0, true);
  if (run.normal_force_only) return fields;
  carried("shear force", 0, false);
  const bool moments = std::any_of(run.bond_force.begin(), run.bond_force.end(),
                                   [](const Vector6& f) { return f.tail<3>().allFinite(); });
  if (!moments) return fields;
  carried("twisting moment", 3, true);
  carried("bending moment", 3, false);
  return fields;
}

/// Strain energy of the run's motion in the case's bonds, over which it is quadratic.
FieldComparison energy_of(const BondNetwork& network, const State& statics,
                          const std::vector<Vector6>& motion, const Matrix3& strain) {
  FieldComparison out;
  out.field = "energy";
  for (const Link& link : network.links) {
    const Vector6 delta = link_motion<double>(link, motion, strain);
    const double energy = 0.5 * delta.dot(resultants<double>(link.stiffness, bond_axis<double>(link), delta));
    if (std::isfinite(energy)) out.run_norm += energy;
  }
  out.static_norm = statics.energy;
  out.difference = out.largest = ratio(std::abs(out.run_norm - out.static_norm), out.static_norm);
  return out;
}

}  // namespace

std::vector<FieldComparison> compared_fields(const Model& model, const BondNetwork& network,
                                             const State& statics, const RunState& run,
                                             const std::vector<Vector6>& motion, const Matrix3& strain) {
  const std::vector<Field> fields = fields_of(model, statics, run);
  std::vector<Size> sizes;
  for (const Field& field : fields) sizes.push_back(size_of(field));
  const auto length = [&](const Field& field) {  // of motions into displacement, of forces into force
    if (!field.angular) return 1.0;
    return field.force ? 1 / network.rotation_length : network.rotation_length;
  };
  std::vector<FieldComparison> out;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    Size scale = sizes[f];
    for (std::size_t g = 0; g < fields.size(); ++g) {
      if (fields[g].force != fields[f].force) continue;
      const double part = vanishing * length(fields[g]) / length(fields[f]);
      scale.norm = std::max(scale.norm, part * sizes[g].norm);
      scale.largest = std::max(scale.largest, part * sizes[g].largest);
    }
    out.push_back(comparison_of(fields[f], scale));
  }
  if (run.has_rotations && run.missing.empty()) out.push_back(energy_of(network, statics, motion, strain));
  return out;
}

std::vector<WorstParticle> worst_particles(const State& statics, const RunState& run) {
  std::vector<std::pair<double, Index>> apart;
  for (std::size_t p = 0; p < run.displacement.size(); ++p) {
    const double size = (run.displacement[p] - statics.displacement[p]).head<3>().stableNorm();
    if (std::isfinite(size)) apart.emplace_back(-size, Index(p));
  }
  const std::size_t count = std::min(most_worst, apart.size());
  std::partial_sort(apart.begin(), apart.begin() + std::ptrdiff_t(count), apart.end());
  std::vector<WorstParticle> worst;
  for (std::size_t i = 0; i < count; ++i) {
    const auto p = std::size_t(apart[i].second);
    worst.push_back({Index(p), statics.displacement[p], run.displacement[p]});
  }
  return worst;
}

}  // namespace bondstatic
