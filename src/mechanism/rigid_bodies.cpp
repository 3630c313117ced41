#include "mechanism/rigid_bodies.hpp"

#include <algorithm>

namespace bondstatic {

std::vector<RigidBody> make_bodies(const Model& model, std::vector<std::vector<Index>> members,
                                   const std::vector<Constraint>& constraints) {
  std::vector<RigidBody> bodies;
  bodies.reserve(members.size());
  const auto position = [&](Index p) -> const Vector3& { return model.particles[std::size_t(p)].position; };
  for (auto& particles : members) {
    RigidBody body{std::move(particles)};
    // Relative to the first one: positions far from the origin keep their digits.
    const Vector3 first = position(body.particles.front());
    for (const Index p : body.particles) body.centre += position(p) - first;
    body.centre = first + body.centre / double(body.particles.size());
    for (const Index p : body.particles) body.size = std::max(body.size, (position(p) - body.centre).norm());
    bodies.push_back(std::move(body));
  }
  const auto reach = [&](Index b, const Vector3& point) {
    if (b == ground) return;
    RigidBody& body = bodies[std::size_t(b)];
    body.size = std::max(body.size, (point - body.centre).norm());
  };
  for (const Constraint& c : constraints) {
    reach(c.a, c.at_a);
    reach(c.b, c.at_b);
  }
  for (RigidBody& body : bodies) {
    if (body.size == 0) body.size = model.particles[std::size_t(body.particles.front())].radius;
    if (!(body.size > 0)) body.size = 1;
  }
  return bodies;
}

Matrix6 restrict_motion(const RigidBody& body, const Vector3& centre, double size) {
  const Vector3 arm = (body.centre - centre) / size;
  Matrix6 columns = Matrix6::Identity();
  // v + (omega size) x arm
  for (int i = 0; i < 3; ++i) columns.block<3, 1>(0, 3 + i) = Vector3::Unit(i).cross(arm);
  columns.bottomRightCorner<3, 3>() *= body.size / size;
  return columns;
}

}  // namespace bondstatic
