#include "bench/naive_dynamics.hpp"

#include <cmath>

namespace bondstatic::bench {

namespace {

struct NaiveParticle {
  Vector3 x, moved = Vector3::Zero(), v = Vector3::Zero(), w = Vector3::Zero(), f = Vector3::Zero(),
             m = Vector3::Zero(), load = Vector3::Zero();
  double mass, inertia;
  bool held = false;
};

struct NaiveBond {
  std::size_t a, b;
  const BondProperties* of;
  Matrix3 frame;  ///< rows e_x, e_y, e_z
  Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
};

Matrix3 frame_along(const Vector3& branch, const Vector3& side) {
  Matrix3 frame;
  frame.row(0) = branch.normalized();
  frame.row(2) = frame.row(0).transpose().cross(side).normalized();
  frame.row(1) = frame.row(2).transpose().cross(frame.row(0).transpose());
  return frame;
}

void advance(NaiveBond& bond, NaiveParticle& a, NaiveParticle& b, double dt) {
  const SectionStiffness& c = bond.of->stiffness;
  const Vector3 branch = b.x - a.x;
  const Vector3 spin = 0.5 * dt * (a.w + b.w);
  const Vector3 side = bond.frame.row(1).transpose();
  bond.frame = frame_along(branch, side + spin.cross(side));
  const Vector3 arm_a = bond.of->fraction * branch, arm_b = arm_a - branch;
  const Vector3 v = bond.frame * (a.v + a.w.cross(arm_a) - b.v - b.w.cross(arm_b));
  const Vector3 w = bond.frame * (a.w - b.w);
  bond.force += dt * Vector3(c.kn, c.ks, c.ks).cwiseProduct(v);
  bond.moment += dt * Vector3(c.kt, c.kb, c.kb).cwiseProduct(w);
  const Vector3 f = bond.frame.transpose() * bond.force, m = bond.frame.transpose() * bond.moment;
  a.f -= f;
  b.f += f;
  a.m -= m + arm_a.cross(f);
  b.m += m + arm_b.cross(f);
}

Vector3 damped(const Vector3& force, const Vector3& before, double half_step_over_mass) {
  const Vector3 velocity = before + half_step_over_mass * force;
  Vector3 result = force;
  for (int i = 0; i < 3; ++i)
    result[i] -= 0.7 * std::abs(force[i]) * (velocity[i] > 0 ? 1 : velocity[i] < 0 ? -1 : 0);
  return result;
}

}  // namespace

std::vector<Vector3> run_naively(const Model& model, const std::vector<BondProperties>& properties,
                                 double time_step, int steps) {
  std::vector<NaiveParticle> particles;
  for (const Particle& p : model.particles) {
    NaiveParticle one;
    one.x = p.position;
    one.mass = mass(p);
    one.inertia = moment_of_inertia(p);
    particles.push_back(one);
  }
  for (const Support& support : model.supports) particles[std::size_t(support.particle)].held = true;
  for (const Load& load : model.loads)
    if (load.load_case <= 0) particles[std::size_t(load.particle)].load += load.force.head<3>();
  std::vector<NaiveBond> bonds;
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    const Bond& bond = model.bonds[k];
    NaiveBond one{std::size_t(bond.a), std::size_t(bond.b), &properties[k], {}};
    one.frame = frame_along(bond.branch, bond.branch.unitOrthogonal());
    bonds.push_back(one);
  }
  for (int n = 0; n < steps; ++n) {
    const double kick = n == 0 ? 0.5 * time_step : time_step;  // from rest to the first half step
    for (NaiveParticle& p : particles) {
      if (!p.held) {
        p.v += kick / p.mass * damped(p.f + p.load, p.v, 0.5 * time_step / p.mass);
        p.w += kick / p.inertia * damped(p.m, p.w, 0.5 * time_step / p.inertia);
        p.x += time_step * p.v;
        p.moved += time_step * p.v;
      }
      p.f = p.m = Vector3::Zero();
    }
    for (NaiveBond& bond : bonds) advance(bond, particles[bond.a], particles[bond.b], time_step);
  }
  std::vector<Vector3> moved;
  for (const NaiveParticle& p : particles) moved.push_back(p.moved);
  return moved;
}

}  // namespace bondstatic::bench
