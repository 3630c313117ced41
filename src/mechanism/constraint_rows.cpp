#include "mechanism/constraint_rows.hpp"

#include <cmath>

namespace bondstatic {

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

}  // namespace bondstatic
