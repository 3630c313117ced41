#include "statics/recover.hpp"

#include <algorithm>

#include "model/cell.hpp"
#include "statics/outside_forces.hpp"
#include "system/link_sweeps.hpp"
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

/// What is added up over the bonds: strain energy, and in a periodic cell magnitude of force, and force times
/// branch.
struct Sums {
  Extended energy = 0.0;
  Extended forces = 0.0;
  Eigen::Matrix<Extended, 3, 3> force_branch = Eigen::Matrix<Extended, 3, 3>::Zero();
};

/// What one bond carries; adds nothing up, so that many can be formed at once. `motion` is that beyond the
/// strain of a periodic cell.
Sums carry(const Link& link, const BondProperties& bond, const LinkState& state,
           const BodyVectors<Extended>& motion, const Matrix3& strain, bool periodic, BondResult& found) {
  const auto a = std::size_t(link.a), b = std::size_t(link.b);
  const Extended3 axis = bond_axis<Extended>(link);
  const auto& [delta, q] = state;
  const Vector6 moved = motion_magnitude(link, motion[a].cast<double>(), motion[b].cast<double>(), strain);
  const Vector6 magnitude = resultant_magnitude(bond.stiffness, axis.cast<double>(), moved);
  // With torque feedback off the bond still carries moments that equilibrium does not see.
  const Carried carried{bond.moments_fed_back ? q : resultants<Extended>(bond.stiffness, axis, delta),
                        magnitude.head<3>().norm(), magnitude.tail<3>().norm()};
  found = bond_result(carried, axis, bond.radius);
  const Extended energy = 0.5 * delta.dot(q);
  // Quadratic in the motion, so that its rounding is that of the motion squared.
  found.energy = settled(energy, negligible * magnitude.dot(moved));
  Sums sums{energy};
  if (!periodic) return sums;
  sums.forces = Vector3(q.head<3>().cast<double>()).norm();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) sums.force_branch(i, j) = q[i] * link.branch[j];
  return sums;
}

/// With what the strain of a periodic cell adds.
Vector6 whole_motion(const Model& model, const Matrix3& strain, std::size_t p, const Extended6& beyond) {
  if (strain.isZero(0)) return beyond.cast<double>();
  const Vector3 from_origin = model.particles[p].position - model.cell->origin;
  Extended6 whole = beyond;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) whole[i] += Extended(strain(i, j)) * from_origin[j];
  return whole.cast<double>();
}

Extended strain_work(const Eigen::Matrix<Extended, 3, 3>& force_branch, const Matrix3& strain) {
  Extended work = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) work += force_branch(i, j) * strain(i, j);
  return work;
}

/// Round a cell there are no lever arms to take moments by: what acts on the particles from outside, about
/// their own centres, balances the moments of all bonds, branch x force.
double moment_balance_of_cell(const OutsideForces& outside,
                              const Eigen::Matrix<Extended, 3, 3>& force_branch) {
  Vector3T<Extended> sum = outside.moment();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum[i] += force_branch(k, j) - force_branch(j, k);
  }
  return ratio(sum.norm(), outside.moments() + force_branch.norm());
}

/// Symmetric where every particle's moments balance, but for rounding.
Matrix3 mean_stress(const Eigen::Matrix<Extended, 3, 3>& force_branch, const Cell& cell) {
  const Extended twice = 2.0 * volume(cell);
  Matrix3 stress;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) stress(i, j) = to_double((force_branch(i, j) + force_branch(j, i)) / twice);
  return stress;
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
  result.displacement = vector_of<Vector6>(particles, threads);
  result.reaction = vector_of<Vector6>(particles, threads);
  result.bonds = vector_of<BondResult>(std::size_t(bonds), threads);
  const Matrix3& strain = result.strain = boundary.strain;
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1 && bonds > worth_threads)
  for (Index i = 0; i < Index(particles); ++i) {
    const auto p = std::size_t(i);
    result.displacement[p] =
        left_out[p] ? Vector6(Vector6::Constant(not_given)) : whole_motion(model, strain, p, motion[p]);
    result.reaction[p].setZero();
  }

  // Sums in the order of the bonds whatever the threads, a block at a time.
  constexpr Index block = 1 << 14, piece = 1 << 8;
  std::vector<Sums> of_bond(std::size_t(std::min(block, bonds)));
  std::vector<LinkState> state(of_bond.size());
  Sums sums;
  for (Index first = 0; first < bonds; first += block) {
    const Index last = std::min(bonds, first + block);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1 && bonds > worth_threads)
    for (Index begin = first; begin < last; begin += piece) {
      const Index end = std::min(last, begin + piece);
      link_states(network, motion, strain, begin, end, state.data() + (begin - first));
      for (Index k = begin; k < end; ++k) {
        const Link& link = network.links[std::size_t(k)];
        BondResult& found = result.bonds[std::size_t(k)];
        Sums& own = of_bond[std::size_t(k - first)];
        if (left_out[std::size_t(link.a)])
          found = left_out_bond(), own = {};
        else
          own = carry(link, properties[std::size_t(k)], state[std::size_t(k - first)], motion, strain,
                      model.cell.has_value(), found);
      }
    }
    for (Index k = first; k < last; ++k) {
      if (!network.owns(network.links[std::size_t(k)])) continue;
      sums.energy += of_bond[std::size_t(k - first)].energy;
      if (!model.cell) continue;
      sums.forces += of_bond[std::size_t(k - first)].forces;
      sums.force_branch += of_bond[std::size_t(k - first)].force_branch;
    }
  }

  constexpr std::uint8_t all_free = 0x3f;
  const BodyVectors<double> beyond_strain =
      strain.isZero(0) ? BodyVectors<double>{} : converted<double>(motion);
  const BodyVectors<double>& rounded = strain.isZero(0) ? result.displacement : beyond_strain;
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
      const Extended6 internal = force_on_body<Extended>(network, incidence, motion, Index(p), strain);
      const Vector6 magnitude = force_magnitude(network, incidence, rounded, Index(p), strain);
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
  add_up(ranks, {&sums.energy, 1});
  Extended work = all.work();
  if (model.cell) {
    add_up(ranks, {&sums.forces, 1});
    add_up(ranks, {sums.force_branch.data(), 9});
    work += strain_work(sums.force_branch, strain);
    result.stress = mean_stress(sums.force_branch, *model.cell);
  }
  result.energy = to_double(sums.energy);
  result.work = to_double(work);
  result.accuracy.energy_balance = ratio(abs(2.0 * sums.energy - work), 2.0 * sums.energy);
  // Strains act without any force from outside, but for the rounding of what holds the translation.
  result.accuracy.force_balance =
      model.cell ? ratio(all.force().norm(), all.forces() + sums.forces) : all.force_balance();
  result.accuracy.moment_balance =
      model.cell ? moment_balance_of_cell(all, sums.force_branch) : all.moment_balance();
  return result;
}

}  // namespace bondstatic
