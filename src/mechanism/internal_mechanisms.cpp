#include "mechanism/internal_mechanisms.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mechanism/constraint_rows.hpp"
#include "mechanism/free_motions.hpp"
#include "mechanism/rigid_growth.hpp"
#include "mechanism/rigid_patches.hpp"
#include "mechanism/screw.hpp"

namespace bondstatic {
namespace {

// Puts the larger bodies that have grown in the place of the bodies; what has grown on to the ground
// disappears.
void unite_bodies(Partition& sets, std::vector<std::vector<Index>>& members,
                  std::vector<Constraint>& constraints) {
  const Index bodies = Index(members.size()), on_ground = sets.find(bodies);
  const auto unions = sets.members([&](Index b) { return sets.find(b) != on_ground; });
  std::vector<Index> heir(members.size(), ground);
  std::vector<std::vector<Index>> particles(unions.size());
  for (std::size_t u = 0; u < unions.size(); ++u) {
    for (const Index b : unions[u]) {
      heir[std::size_t(b)] = Index(u);
      const auto& joins = members[std::size_t(b)];
      particles[u].insert(particles[u].end(), joins.begin(), joins.end());
    }
    std::sort(particles[u].begin(), particles[u].end());
  }
  members = std::move(particles);
  for (Constraint& c : constraints) {
    if (c.a != ground) c.a = heir[std::size_t(c.a)];
    c.b = heir[std::size_t(c.b)];
    if (c.b == ground) std::swap(c.a, c.b), std::swap(c.at_a, c.at_b);
  }
  std::erase_if(constraints, [](const Constraint& c) { return c.b == ground || (c.a == c.b && !c.shifted); });
}

void grow(std::vector<std::vector<Index>>& members, std::vector<Constraint>& constraints) {
  Partition sets = grow_rigid(Index(members.size()), constraints);
  unite_bodies(sets, members, constraints);
}

// Fewer, larger bodies of the same free motions. Growth needs rigid seeds; patches of a large network that
// growth leaves are searched for them, more and more of them as long as that helps or until they cover it
// all.
void reduce(const Model& model, std::vector<std::vector<Index>>& members,
            std::vector<Constraint>& constraints) {
  grow(members, constraints);
  for (Index patches = 1; members.size() > 2 * std::size_t(patch_size);) {
    const std::size_t before = members.size();
    Partition sets = rigid_patches(make_bodies(model, members, constraints), constraints, patches);
    unite_bodies(sets, members, constraints);
    grow(members, constraints);
    if (members.size() > before - before / 20) {
      if (std::size_t(patches * patch_size) > 2 * members.size()) return;
      patches *= 4;
    }
  }
}

// Motions of one body with all others still: particles that spin, bodies on a hinge. They are held from then
// on, so that without friction, where every particle spins, the rest can still grow.
std::vector<Mechanism> lone_motions(const Model& model, const std::vector<std::vector<Index>>& members,
                                    std::vector<Constraint>& constraints) {
  const std::vector<RigidBody> bodies = make_bodies(model, members, constraints);
  std::vector<std::vector<Vector6>> forms(bodies.size());
  for (const ConstraintRow& row : constraint_rows(bodies, constraints)) {
    if (row.a != ground) forms[std::size_t(row.a)].push_back(row.at_a);
    forms[std::size_t(row.b)].push_back(row.at_b);
  }
  std::vector<Mechanism> mechanisms;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    Eigen::MatrixXd rows(Index(forms[b].size()), 6);
    for (std::size_t k = 0; k < forms[b].size(); ++k) rows.row(Index(k)) = forms[b][k].transpose();
    const Eigen::MatrixXd free = free_motions(std::move(rows));
    if (free.cols() == 0) continue;
    hold(constraints, Index(b), bodies[b], free);
    Mechanism mechanism{Mechanism::Kind::internal, bodies[b].particles, {}};
    const std::vector<Vector6> motions(free.colwise().begin(), free.colwise().end());
    for (const Vector6& motion : legible_basis(motions))
      mechanism.motions.push_back(screw(motion, bodies[b].centre, bodies[b].size));
    mechanisms.push_back(std::move(mechanism));
  }
  return mechanisms;
}

// The body that moves most, and its screw for each motion.
std::vector<FreeMotion> screws(const std::vector<RigidBody>& bodies,
                               const std::vector<const NullVector*>& group) {
  const auto greatest = [&](const std::map<Index, double>& how_much) {
    const auto more = [&](const auto& p, const auto& q) {
      if (std::abs(p.second - q.second) > 1e-6 * q.second) return p.second < q.second;
      return bodies[std::size_t(p.first)].particles.size() < bodies[std::size_t(q.first)].particles.size();
    };
    return std::max_element(how_much.begin(), how_much.end(), more)->first;
  };
  const auto as_screw = [&](const Vector6& motion, Index body) {
    return screw(motion, bodies[std::size_t(body)].centre, bodies[std::size_t(body)].size);
  };
  std::map<Index, double> in_all;
  for (const NullVector* vector : group)
    for (const auto& [body, motion] : *vector) in_all[body] += motion.squaredNorm();
  const Index main = greatest(in_all);
  std::vector<Vector6> of_main;
  for (const NullVector* vector : group)
    for (const auto& [body, motion] : *vector)
      if (body == main) of_main.push_back(motion);

  std::vector<FreeMotion> motions;
  const auto basis = of_main.size() == group.size() ? legible_basis(of_main) : std::vector<Vector6>{};
  if (basis.size() == group.size()) {
    for (const Vector6& motion : basis) motions.push_back(as_screw(motion, main));
    return motions;
  }
  for (const NullVector* vector : group) {
    std::map<Index, double> in_one;
    for (const auto& [body, motion] : *vector) in_one[body] = motion.squaredNorm();
    const Index body = greatest(in_one);
    for (const auto& [moved, motion] : *vector)
      if (moved == body) motions.push_back(as_screw(motion, body));
  }
  return motions;
}

}  // namespace

std::vector<Mechanism> internal_mechanisms(const Model& model, std::vector<std::vector<Index>> members,
                                           std::vector<Constraint> constraints) {
  grow(members, constraints);
  std::vector<Mechanism> mechanisms = lone_motions(model, members, constraints);
  reduce(model, members, constraints);
  const std::vector<RigidBody> bodies = make_bodies(model, std::move(members), constraints);
  std::vector<Vector3> centres;
  for (const RigidBody& body : bodies) centres.push_back(body.centre);
  const std::vector<NullVector> vectors = null_space(centres, constraint_rows(bodies, constraints));

  Partition moving_together{Index(vectors.size())};
  std::map<Index, Index> first_mover;  // body -> a vector that moves it
  for (Index k = 0; k < Index(vectors.size()); ++k)
    for (const auto& [body, motion] : vectors[std::size_t(k)])
      moving_together.unite(k, first_mover.try_emplace(body, k).first->second);

  for (const auto& group : moving_together.members([](Index) { return true; })) {
    Mechanism mechanism{Mechanism::Kind::internal, {}, {}};
    std::vector<const NullVector*> of_group;
    std::map<Index, bool> moves;
    for (const Index k : group) {
      of_group.push_back(&vectors[std::size_t(k)]);
      for (const auto& [body, motion] : vectors[std::size_t(k)]) moves[body] = true;
    }
    for (const auto& [body, yes] : moves) {
      const auto& particles = bodies[std::size_t(body)].particles;
      mechanism.particles.insert(mechanism.particles.end(), particles.begin(), particles.end());
    }
    std::sort(mechanism.particles.begin(), mechanism.particles.end());
    mechanism.motions = screws(bodies, of_group);
    mechanisms.push_back(std::move(mechanism));
  }
  return mechanisms;
}

}  // namespace bondstatic
