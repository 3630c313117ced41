#include "statics/recover.hpp"

#include <algorithm>

#include "statics/outside_forces.hpp"
#include "system/together.hpp"

namespace bondstatic {

namespace {

using Extended3 = Vector3T<Extended>;
using Extended6 = Vector6T<Extended>;

// A value beside the sum of the magnitudes it was formed from.
double settled(const Extended& value, double magnitude) {
  const double rounded = to_double(value);
  return std::abs(rounded) <= negligible * magnitude ? 0.0 : rounded;
}

// What a bond carries, and how large it would be without cancellation.
struct Carried {
  Extended6 q;
  double force = 0;
  double moment = 0;
};

BondResult bond_result(const Carried& carried, const Extended3& axis, double radius) {
  const Extended3 force = carried.q.head<3>(), moment = carried.q.tail<3>();
  const Extended normal = axis.dot(force), twisting = axis.dot(moment);
  BondResult result;
  for (int i = 0; i < 6; ++i)
    result.force[i] = settled(-carried.q[i], i < 3 ? carried.force : carried.moment);
  result.normal_force = settled(normal, carried.force);
  result.shear_force = settled((force - normal * axis).norm(), carried.force);
  result.twisting_moment = settled(-twisting, carried.moment);
  result.bending_moment = settled((moment - twisting * axis).norm(), carried.moment);
  const SectionStress stress = section_stress(
      {result.normal_force, result.shear_force, result.twisting_moment, result.bending_moment}, radius);
  result.sigma = stress.sigma;
  result.tau = stress.tau;
  return result;
}

/// What one bond carries; adds nothing up, so that many can be formed at once. Returns its energy.
Extended carry(const Link& link, const BondProperties& bond, const BodyVectors<Extended>& motion,
               const std::vector<Vector6>& displacement, BondResult& found) {
  const auto a = std::size_t(link.a), b = std::size_t(link.b);
  const Extended3 axis = bond_axis<Extended>(link);
  const Extended6 delta = relative_motion<Extended>(link, motion[a], motion[b]);
  const Extended6 q = resultants<Extended>(link.stiffness, axis, delta);
  const Vector6 moved = motion_magnitude(link, displacement[a], displacement[b]);
  const Vector6 magnitude = resultant_magnitude(bond.stiffness, axis.cast<double>(), moved);
  // With torque feedback off the bond still carries moments that equilibrium does not see.
  const Carried carried{bond.moments_fed_back ? q : resultants<Extended>(bond.stiffness, axis, delta),
                        magnitude.head<3>().norm(), magnitude.tail<3>().norm()};
  found = bond_result(carried, axis, bond.radius);
  const Extended energy = 0.5 * delta.dot(q);
  // Quadratic in the motion, so that its rounding is that of the motion squared.
  found.energy = settled(energy, negligible * magnitude.dot(moved));
  return energy;
}

}  // namespace

LoadCaseResult recover(const Model& model, const BondNetwork& network, const Incidence& incidence,
                       const std::vector<BondProperties>& properties, const Boundary& boundary,
                       const std::vector<bool>& left_out, const Refined& refined, int threads, Ranks* ranks) {
  const std::size_t particles = model.particles.size();
  const Index bonds = Index(network.links.size());
  const auto& motion = refined.motion;
  LoadCaseResult result;
  result.accuracy = refined.accuracy;
  result.displacement.resize(particles);
  result.reaction.assign(particles, Vector6::Zero());
  result.bonds.resize(std::size_t(bonds));
  for (std::size_t p = 0; p < particles; ++p)
    result.displacement[p] =
        left_out[p] ? Vector6(Vector6::Constant(not_given)) : Vector6(motion[p].cast<double>());

  // The energy is summed in the order of the bonds whatever the threads, a block at a time.
  constexpr Index block = 1 << 14;
  std::vector<Extended> energies(std::size_t(std::min(block, bonds)));
  Extended energy = 0.0;
  for (Index first = 0; first < bonds; first += block) {
    const Index last = std::min(bonds, first + block);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1 && bonds > worth_threads)
    for (Index k = first; k < last; ++k) {
      const Link& link = network.links[std::size_t(k)];
      BondResult& found = result.bonds[std::size_t(k)];
      Extended& own = energies[std::size_t(k - first)];
      if (left_out[std::size_t(link.a)])
        found = left_out_bond(), own = 0.0;
      else
        own = carry(link, properties[std::size_t(k)], motion, result.displacement, found);
    }
    for (Index k = first; k < last; ++k)
      if (network.owns(network.links[std::size_t(k)])) energy += energies[std::size_t(k - first)];
  }

  constexpr std::uint8_t all_free = 0x3f;
  const auto own = std::size_t(network.own());
  OutsideForces all(model, network.own(), ranks);
  for (std::size_t p = 0; p < particles; ++p) {
    if (left_out[p]) {
      result.reaction[p] = Vector6::Constant(not_given);
      continue;
    }
    if (p >= own) continue;  // another rank has all that acts on it
    // Where nothing is prescribed the outside force is the load; B^T q equals it only to the residual.
    Extended6 outside = boundary.load[p].cast<Extended>();
    if ((boundary.free[p] & all_free) != all_free) {
      const Extended6 internal = force_on_body<Extended>(network, incidence, motion, Index(p));
      const Vector6 magnitude = force_magnitude(network, incidence, result.displacement, Index(p));
      for (int i = 0; i < 6; ++i) {
        if ((boundary.free[p] >> i) & 1) continue;
        const double load = boundary.load[p][i];
        result.reaction[p][i] = settled(internal[i] - load, magnitude[i] + std::abs(load));
        outside[i] = internal[i];
      }
    } else if (boundary.load[p].isZero(0)) {
      continue;
    }
    all.add(p, outside, motion[p]);
  }
  all.add_up(ranks);
  add_up(ranks, {&energy, 1});
  result.energy = to_double(energy);
  result.work = to_double(all.work());
  result.accuracy.energy_balance = ratio(abs(2.0 * energy - all.work()), 2.0 * energy);
  result.accuracy.force_balance = all.force_balance();
  result.accuracy.moment_balance = all.moment_balance();
  return result;
}

}  // namespace bondstatic
