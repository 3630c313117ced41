#include "statics/internal_mechanisms.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "statics/null_space.hpp"
#include "statics/rigid_growth.hpp"
#include "statics/screw.hpp"

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

std::vector<ConstraintRow> constraint_rows(const std::vector<RigidBody>& bodies,
                                           const std::vector<Constraint>& constraints) {
  constexpr double cancelled = 1e-12;  // of the parts of a row on one body round a periodic cell
  std::vector<ConstraintRow> rows;
  rows.reserve(constraints.size());
  for (const Constraint& c : constraints) {
    const RigidBody& b = bodies[std::size_t(c.b)];
    ConstraintRow row{.a = c.a, .b = c.b};
    row.at_b = wrench_on(c, c.at_b, b.centre, b.size);
    const double natural = row.at_b.norm();
    if (c.a != ground) {
      const RigidBody& a = bodies[std::size_t(c.a)];
      row.at_a = -wrench_on(c, c.at_a, a.centre, a.size);
    }
    if (c.a == c.b) row = {.a = ground, .b = c.b, .at_b = row.at_a + row.at_b};
    const double length = std::hypot(row.at_a.norm(), row.at_b.norm());
    if (!(length > cancelled * natural)) continue;
    row.at_a /= length;
    row.at_b /= length;
    rows.push_back(row);
  }
  return rows;
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
  Partition sets = grow_rigid(Index(members.size()), constraints);
  unite_bodies(sets, members, constraints);
  const std::vector<RigidBody> bodies = make_bodies(model, std::move(members), constraints);
  std::vector<Vector3> centres;
  for (const RigidBody& body : bodies) centres.push_back(body.centre);
  const std::vector<NullVector> vectors = null_space(centres, constraint_rows(bodies, constraints));

  Partition moving_together{Index(vectors.size())};
  std::map<Index, Index> first_mover;  // body -> a vector that moves it
  for (Index k = 0; k < Index(vectors.size()); ++k)
    for (const auto& [body, motion] : vectors[std::size_t(k)])
      moving_together.unite(k, first_mover.try_emplace(body, k).first->second);

  std::vector<Mechanism> mechanisms;
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
