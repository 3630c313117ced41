#include "bondstatic/mechanism.hpp"

#include <algorithm>

#include "mechanism/bonded_components.hpp"
#include "mechanism/free_motions.hpp"
#include "mechanism/internal_mechanisms.hpp"
#include "mechanism/partition.hpp"
#include "mechanism/screw.hpp"

namespace bondstatic {
namespace {

const Vector3& position(const Model& model, Index p) {
  return model.particles[std::size_t(p)].position;
}

Mechanism unheld(const Model& model, std::vector<Index> particles) {
  Mechanism mechanism;
  mechanism.kind = particles.size() == 1 ? Mechanism::Kind::isolated : Mechanism::Kind::floating;
  const RigidBody whole = make_bodies(model, {particles}, {}).front();
  for (int i = 0; i < 6; ++i) mechanism.motions.push_back(screw(Vector6::Unit(i), whole.centre, whole.size));
  mechanism.particles = std::move(particles);
  return mechanism;
}

// One bonded component that something holds, contracted to rigid bodies.
struct HeldComponent {
  std::vector<Index> particles;
  std::vector<std::vector<Index>> members;  // of its bodies
  std::vector<Constraint> constraints;
};

std::vector<HeldComponent> contract(const Model& model, const BondNetwork& network, const FreeDofs& dofs,
                                    std::vector<std::vector<Index>> components) {
  std::vector<Index> component_of(std::size_t(network.bodies), -1), body_of = component_of;
  std::vector<HeldComponent> held(components.size());
  for (std::size_t c = 0; c < components.size(); ++c) {
    for (const Index p : components[c]) component_of[std::size_t(p)] = Index(c);
    held[c].particles = std::move(components[c]);
  }
  const auto unites = [&](const Link& link) {
    return is_rigid(link, position(model, link.a), position(model, link.b));
  };
  const auto is_held_here = [&](Index p) { return component_of[std::size_t(p)] >= 0; };
  Partition sets(network.bodies);
  for (const Link& link : network.links)
    if (is_held_here(link.a) && is_held_here(link.b) && unites(link)) sets.unite(link.a, link.b);
  for (auto& particles : sets.members(is_held_here)) {
    HeldComponent& in = held[std::size_t(component_of[std::size_t(particles.front())])];
    for (const Index p : particles) body_of[std::size_t(p)] = Index(in.members.size());
    in.members.push_back(std::move(particles));
  }
  for (const Link& link : network.links) {
    if (!is_held_here(link.a) || !is_held_here(link.b) || unites(link)) continue;
    const Index a = body_of[std::size_t(link.a)], b = body_of[std::size_t(link.b)];
    const Vector3 &at_a = position(model, link.a), &at_b = position(model, link.b);
    if (a == b && !is_shifted(link, at_a, at_b)) continue;
    append_constraints(held[std::size_t(component_of[std::size_t(link.a)])].constraints, link, a, b, at_a,
                       at_b);
  }
  for (Index p = 0; p < network.bodies; ++p)
    if (is_held_here(p))
      append_support(held[std::size_t(component_of[std::size_t(p)])].constraints, body_of[std::size_t(p)],
                     position(model, p), dofs.free[std::size_t(p)]);
  return held;
}

// Rigid motions of the whole that its supports, and bonds round a periodic cell, leave free.
Eigen::MatrixXd free_rigid_motions(const RigidBody& whole, const std::vector<Constraint>& constraints) {
  Eigen::MatrixXd rows(Index(constraints.size()), 6);
  Index count = 0;
  for (const Constraint& c : constraints) {
    if (c.a != ground && !c.shifted) continue;
    Vector6 row = wrench_on(c, c.at_b, whole.centre, whole.size);
    if (c.a == ground)
      row.normalize();
    else
      row -= wrench_on(c, c.at_a, whole.centre, whole.size);
    rows.row(count++) = row.transpose();
  }
  return free_motions(rows.topRows(count));
}

void append(std::vector<Mechanism>& all, std::vector<Mechanism> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::vector<Mechanism> mechanisms_of(const Model& model, HeldComponent held) {
  std::vector<Mechanism> found;
  const RigidBody whole = make_bodies(model, {held.particles}, {}).front();
  const Eigen::MatrixXd free = free_rigid_motions(whole, held.constraints);
  if (free.cols() > 0) {
    Mechanism mechanism{Mechanism::Kind::underconstrained, held.particles, {}};
    std::vector<Vector6> motions;
    for (Index k = 0; k < free.cols(); ++k) motions.push_back(free.col(k));
    for (const Vector6& motion : legible_basis(motions))
      mechanism.motions.push_back(screw(motion, whole.centre, whole.size));
    found.push_back(std::move(mechanism));
  }
  if (held.members.size() == 1) return found;
  if (free.cols() > 0) {
    const auto largest = std::max_element(held.members.begin(), held.members.end(),
                                          [](const auto& p, const auto& q) { return p.size() < q.size(); });
    const RigidBody body = make_bodies(model, {*largest}, {}).front();
    hold(held.constraints, largest - held.members.begin(), body,
         restrict_motion(body, whole.centre, whole.size) * free);
  }
  append(found, internal_mechanisms(model, std::move(held.members), std::move(held.constraints)));
  return found;
}

}  // namespace

std::vector<Mechanism> find_mechanisms(const Model& model, const BondNetwork& network, const FreeDofs& dofs,
                                       const std::vector<bool>& left_out) {
  std::vector<bool> present(std::size_t(network.bodies), true);
  for (std::size_t p = 0; p < left_out.size(); ++p) present[p] = !left_out[p];
  std::vector<Mechanism> found;
  std::vector<std::vector<Index>> held;
  for (auto& component : bonded_components(network, present)) {
    if (is_held(component, dofs))
      held.push_back(std::move(component));
    else
      found.push_back(unheld(model, std::move(component)));
  }
  for (HeldComponent& component : contract(model, network, dofs, std::move(held)))
    append(found, mechanisms_of(model, std::move(component)));
  return found;
}

}  // namespace bondstatic
