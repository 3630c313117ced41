// What a run shows at a whole step: energies, distance from rest, state.
#include <algorithm>
#include <cmath>

#include "dynamics/run_data.hpp"

namespace bondstatic {

namespace {

/// One degree of freedom at the whole step.
struct Moment {
  double force;    ///< of bonds and loads
  double load;     ///< its applied part
  double damping;  ///< Eq. 11-12
  double before;   ///< velocity half a step before
  double after;    ///< and after

  double velocity() const { return 0.5 * (before + after); }
};

Moment moment_of(const Bodies& bodies, const DynamicOptions& options, double ramp, bool begun,
                 std::size_t dof) {
  Moment m;
  m.load = ramp * bodies.load[dof];
  m.force = bodies.force[dof] + m.load;
  const double v = bodies.velocity[dof], w = bodies.inverse[dof], half = 0.5 * options.time_step * w;
  const double gamma = options.particle_damping;
  m.damping = begun ? particle_damping(gamma, m.force, v, w, options.time_step)
                    : first_particle_damping(gamma, m.force, v, w);
  m.before = begun ? v : v - half * (m.force + m.damping);
  m.after = m.before + 2 * half * (m.force + m.damping);
  return m;
}

double square(double x) {
  return x * x;
}

/// q^2 / 2k; a spring that is not there holds nothing.
double spring_energy(double q, double k) {
  return k > 0 ? 0.5 * q * q / k : 0;
}

/// Of shear q and bending m with ks, kb and the coupling c between them: the inverse of their 2x2 C.
double coupled_energy(double q, double m, double ks, double kb, double c) {
  if (c == 0) return spring_energy(q, ks) + spring_energy(m, kb);
  return 0.5 * (kb * q * q - 2 * c * q * m + ks * m * m) / (ks * kb - c * c);
}

double bond_energy(const BondPack& p, int l) {
  const double f = p.feedback[l], c = f * p.coupling[l];
  return spring_energy(p.force[0][l], p.kn[l]) + spring_energy(f * p.moment[0][l], p.kt[l]) +
         coupled_energy(p.force[1][l], f * p.moment[2][l], p.ks[l], p.kb[l], c) +
         coupled_energy(p.force[2][l], f * p.moment[1][l], p.ks[l], p.kb[l], -c);
}

Vector3 vector_of(const Lanes (&lanes)[3], int lane) {
  return {lanes[0][lane], lanes[1][lane], lanes[2][lane]};
}

BondResult bond_result(const BondPack& p, int l, double radius) {
  const Vector3 x = vector_of(p.axis, l), y = vector_of(p.side, l), z = x.cross(y);
  const Vector3 q = vector_of(p.force, l), m = vector_of(p.moment, l);
  BondResult result;
  result.force << q[0] * x + q[1] * y + q[2] * z, m[0] * x + m[1] * y + m[2] * z;
  result.normal_force = -q[0];
  result.shear_force = std::hypot(q[1], q[2]);
  result.twisting_moment = m[0];
  result.bending_moment = std::hypot(m[1], m[2]);
  const SectionStress stress = section_stress(
      {result.normal_force, result.shear_force, result.twisting_moment, result.bending_moment}, radius);
  result.sigma = stress.sigma;
  result.tau = stress.tau;
  result.energy = bond_energy(p, l);
  return result;
}

BondResult no_result() {
  const double nan = not_given;
  return {Vector6::Constant(nan), nan, nan, nan, nan, nan, nan, nan};
}

}  // namespace

double Energies::balance() const {
  const double left = kinetic - held_back + strain + dissipated - work - initial;
  const double largest = std::max({std::abs(work), std::abs(initial), strain, kinetic, dissipated});
  return largest > 0 ? std::abs(left) / largest : 0;
}

Energies ExplicitRun::energies() const {
  const Data& d = *data_;
  const double dt = d.options.time_step, ramp = d.factor_at(d.step);
  const bool begun = d.step > 0;
  Energies e;
  e.work = d.work.value();
  e.dissipated = d.dissipated.value();
  for (std::size_t dof = 0; dof < 6 * std::size_t(d.bodies.count); ++dof) {
    const Moment m = moment_of(d.bodies, d.options, ramp, begun, dof);
    if (d.bodies.inverse[dof] > 0) {
      e.kinetic += 0.5 * square(m.velocity()) / d.bodies.inverse[dof];
      e.held_back += 0.125 * square(m.after - m.before) / d.bodies.inverse[dof];
    }
    if (!begun) continue;
    // The half of this step's work that lies before it.
    e.work += 0.5 * dt * m.load * m.before;
    e.dissipated -= 0.5 * dt * m.damping * m.before;
  }
  if (begun)
    for (const Index dof : d.bodies.moved) {
      const Moment m = moment_of(d.bodies, d.options, ramp, begun, std::size_t(dof));
      e.work -= 0.5 * dt * m.force * m.before;
    }
  for (std::size_t slot = 0; slot < d.bond_of_lane.size(); ++slot)
    e.strain += bond_energy(d.packs[slot / pack_size], int(slot % pack_size));
  e.initial = begun ? d.initial_energy : e.kinetic - e.held_back;
  return e;
}

Unrest ExplicitRun::unrest() const {
  const Data& d = *data_;
  const double ramp = d.factor_at(d.step);
  const bool begun = d.step > 0;
  Unrest unrest;
  double unbalanced = 0, carried = 0;
  for (Index p = 0; p < d.bodies.count; ++p) {
    if (!d.bodies.present[std::size_t(p)]) continue;
    const double radius = d.bodies.radius[std::size_t(p)];
    double speed[2] = {};
    for (std::size_t i = 0; i < 6; ++i) {
      const std::size_t dof = 6 * std::size_t(p) + i;
      const Moment m = moment_of(d.bodies, d.options, ramp, begun, dof);
      const double lever = i < 3 ? 1 : 1 / radius;
      if (d.bodies.inverse[dof] > 0) {
        speed[i / 3] += square(m.velocity());
        unbalanced += square(lever * m.force);
        carried += square(lever * m.load);
      } else {
        carried += square(lever * m.force);
      }
    }
    const double fastest = std::sqrt(std::max(speed[0], square(radius) * speed[1]));
    if (fastest > unrest.fastest || unrest.particle < 0 || std::isnan(fastest)) {
      unrest.fastest = fastest;
      unrest.particle = d.particle_of(p);
    }
    if (std::isnan(fastest)) break;
  }
  if (unbalanced > 0) unrest.unbalanced = std::sqrt(unbalanced / carried);
  return unrest;
}

Vector6 ExplicitRun::velocity(Index particle) const {
  Vector6 v;
  for (std::size_t i = 0; i < 6; ++i)
    v[Eigen::Index(i)] = moment_of(data_->bodies, data_->options, data_->factor_at(data_->step),
                                   data_->step > 0, 6 * std::size_t(data_->body_of(particle)) + i)
                             .velocity();
  return v;
}

Vector6 ExplicitRun::bond_force(Index particle) const {
  return Eigen::Map<const Vector6>(&data_->bodies.force[6 * std::size_t(data_->body_of(particle))]);
}

Eigen::Quaterniond ExplicitRun::orientation(Index particle) const {
  const auto& turn = data_->bodies.turn;
  const auto p = std::size_t(data_->body_of(particle));
  if (turn[0].empty()) {
    const Vector3 r(&data_->bodies.motion[6 * p + 3]);
    return Eigen::Quaterniond(Eigen::AngleAxisd(r.norm(), r.stableNormalized()));
  }
  return Eigen::Quaterniond(turn[0][p], turn[1][p], turn[2][p], turn[3][p]).normalized();
}

State ExplicitRun::state() const {
  const Data& d = *data_;
  const double ramp = d.factor_at(d.step);
  State state;
  state.name = d.name;
  const auto count = std::size_t(d.bodies.count);
  state.displacement.assign(count, Vector6::Constant(not_given));
  state.reaction.assign(count, Vector6::Constant(not_given));
  state.bonds.assign(d.properties.size(), no_result());
  for (std::size_t p = 0; p < count; ++p) {
    if (!d.bodies.present[p]) continue;
    state.displacement[p] = Eigen::Map<const Vector6>(&d.bodies.motion[6 * p]);
    if (d.options.kinematics == Kinematics::finite) {
      const Eigen::AngleAxisd turned(orientation(d.particle_of(Index(p))));
      state.displacement[p].tail<3>() = turned.angle() * turned.axis();
    }
    for (std::size_t i = 0; i < 6; ++i) {
      const bool free = (d.boundary.free[p] >> i) & 1;
      const double f = d.bodies.force[6 * p + i] + ramp * d.bodies.load[6 * p + i];
      state.reaction[p][Eigen::Index(i)] = free ? 0.0 : 0.0 - f;
    }
  }
  for (std::size_t slot = 0; slot < d.bond_of_lane.size(); ++slot) {
    const auto k = std::size_t(d.bond_of_lane[slot]);
    state.bonds[k] = bond_result(d.packs[slot / pack_size], int(slot % pack_size), d.properties[k].radius);
  }
  if (!d.order.particle.empty()) {
    restore_order(state.displacement, d.order.particle, d.options.threads);
    restore_order(state.reaction, d.order.particle, d.options.threads);
    restore_order(state.bonds, d.order.bond, d.options.threads);
  }
  const Energies e = energies();
  state.energy = e.strain;
  state.work = e.work;
  return state;
}

}  // namespace bondstatic
