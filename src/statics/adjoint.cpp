#include "statics/adjoint.hpp"

#include "model/cell.hpp"
#include "system/link_sweeps.hpp"

namespace bondstatic {
namespace {

using Extended3 = Vector3T<Extended>;
using Extended6 = Vector6T<Extended>;

}  // namespace

LinkWeights link_weights(const Model& model, const BondNetwork& network, const Functional& functional,
                         const SolvedState& state) {
  const std::size_t links = network.links.size();
  LinkWeights weights{BodyVectors<double>(links, Vector6::Zero()),
                      std::vector<double>(links, functional.energy)};
  for (const BondWeight& bond : functional.bonds) {
    weights.resultants[std::size_t(bond.bond)] -= bond.force;  // BondResult::force is -q
    weights.energy[std::size_t(bond.bond)] += bond.energy;
  }
  if (!functional.stress.isZero(0)) {
    // The mean stress is the symmetric part of the sum of force times branch over the volume.
    const Matrix3 per_force = (functional.stress + functional.stress.transpose()) / (2 * volume(*model.cell));
    for (std::size_t k = 0; k < links; ++k)
      weights.resultants[k].head<3>() += per_force * network.links[k].branch;
  }
  for (std::size_t k = 0; k < links; ++k)
    if (state.left_out[std::size_t(network.links[k].a)]) {
      weights.resultants[k].setZero();
      weights.energy[k] = 0;
    }
  return weights;
}

Boundary adjoint_boundary(const BondNetwork& network, const std::vector<BondProperties>& properties,
                          const Functional& functional, const LinkWeights& weights,
                          const SolvedState& state) {
  const auto bodies = std::size_t(network.bodies);
  Boundary boundary{state.free, std::vector<Vector6>(bodies, Vector6::Zero()),
                    std::vector<Vector6>(bodies, Vector6::Zero())};
  for (const auto& [particle, weight] : functional.reaction)
    for (int i = 0; i < 6; ++i)
      if (!((state.free[std::size_t(particle)] >> i) & 1))
        boundary.prescribed[std::size_t(particle)][i] += weight[i];

  // Pairs of forces that balance: rounded to double they would leave a resultant that slender models amplify.
  BodyVectors<Extended> load(bodies, Extended6::Zero());
  for (const auto& [particle, weight] : functional.displacement)
    load[std::size_t(particle)] -= weight.cast<Extended>();
  for (std::size_t k = 0; k < network.links.size(); ++k) {
    if (weights.resultants[k].isZero(0) && weights.energy[k] == 0) continue;
    const Link& link = network.links[k];
    const Extended3 axis = bond_axis<Extended>(link);
    Extended6 q =
        resultants<Extended>(properties[k].stiffness, axis, weights.resultants[k].cast<Extended>().eval());
    if (weights.energy[k] != 0)
      q +=
          Extended(weights.energy[k]) *
          resultants<Extended>(link.stiffness, axis, link_motion<Extended>(link, state.motion, state.strain));
    load[std::size_t(link.a)] += force_on_a<Extended>(link, q);
    load[std::size_t(link.b)] += force_on_b<Extended>(link, q);
  }
  boundary.load_tail.resize(bodies);
  for (std::size_t p = 0; p < bodies; ++p) {
    boundary.load[p] = load[p].cast<double>();
    boundary.load_tail[p] = (load[p] - boundary.load[p].cast<Extended>()).cast<double>();
  }
  return boundary;
}

std::optional<Extended> multiple_of(const Boundary& state, const Boundary& adjoint) {
  if (!state.strain.isZero(0) || !state.load_tail.empty()) return {};
  const auto is_free = [&](std::size_t p, int i) { return ((state.free[p] >> i) & 1) != 0; };
  Vector6 translation = Vector6::Zero();
  for (std::size_t p = 0; p < state.free.size(); ++p)
    for (int i = 0; i < 3; ++i)
      if (!is_free(p, i) && state.prescribed[p][i] == 0) translation[i] = adjoint.prescribed[p][i];

  double over = 0, under = 0;  // their ratio is the factor
  const auto follows = [&](double of_state, const Extended& of_adjoint) {
    if (of_state == 0 || of_adjoint.is_zero()) return of_state == 0 && of_adjoint.is_zero();
    if (under == 0) over = to_double(of_adjoint), under = of_state;
    return Extended(of_state) * over == of_adjoint * under;
  };
  for (std::size_t p = 0; p < state.free.size(); ++p) {
    if (!adjoint.load_tail.empty() && !adjoint.load_tail[p].isZero(0)) return {};
    for (int i = 0; i < 6; ++i)
      if (!(is_free(p, i)
                ? follows(state.load[p][i], adjoint.load[p][i])
                : follows(state.prescribed[p][i], Extended(adjoint.prescribed[p][i]) - translation[i])))
        return {};
  }
  if (under == 0) return {};
  return Extended(over) / under;
}

BodyVectors<Extended> times(const Extended& factor, const BodyVectors<Extended>& motion) {
  BodyVectors<Extended> product(motion);
  for (Extended6& of_body : product) of_body *= factor;
  return product;
}

void add_gradient(const BondNetwork& network, const std::vector<BondProperties>& properties,
                  const Functional& functional, const LinkWeights& weights, const SolvedState& state,
                  const BodyVectors<Extended>& adjoint, int threads, BondGradients& gradient) {
  // A bond's energy is delta . q / 2: half of its change by C is delta's alone. Equilibrium does not see
  // moments that stay in the bond, those who ask for them do.
  std::vector<double> half_energy, fed_back;
  for (std::size_t k = 0; k < network.links.size(); ++k) {
    half_energy.push_back(0.5 * weights.energy[k]);
    fed_back.push_back(properties[k].moments_fed_back ? 1 : 0);
  }
  const auto products = stiffness_products(network, state.motion, state.strain,
                                           {adjoint, half_energy, weights.resultants, fed_back}, threads);
  for (std::size_t k = 0; k < network.links.size(); ++k) {
    if (state.left_out[std::size_t(network.links[k].a)]) continue;
    SectionStiffness& of = gradient[k].stiffness;
    of.kn += products[k].kn;
    of.ks += products[k].ks;
    of.kt += products[k].kt;
    of.kb += products[k].kb;
    of.coupling += products[k].coupling;
  }
  for (const BondWeight& bond : functional.bonds)
    if (!state.left_out[std::size_t(network.links[std::size_t(bond.bond)].a)])
      gradient[std::size_t(bond.bond)].radius += bond.radius;
}

}  // namespace bondstatic
