#include "dynamics/body_lanes.hpp"

#include "io/wide.hpp"

namespace bondstatic {

namespace {

/// Four doubles anywhere in an array of them.
using Four = double __attribute__((vector_size(32), aligned(8), may_alias));
using Two = double __attribute__((vector_size(16), aligned(8), may_alias));

ALWAYS_INLINE const Four& four(const double* at) {
  return *reinterpret_cast<const Four*>(at);
}
ALWAYS_INLINE Four& four(double* at) {
  return *reinterpret_cast<Four*>(at);
}

ALWAYS_INLINE void transpose(Four& a, Four& b, Four& c, Four& d) {
  const Four ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6),
             ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6),
             cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

/// Components first ... first + 3 of four bodies, each into four lanes of its own.
struct Components {
  Four part[4];
};
ALWAYS_INLINE Components components(const double* values, const Index* body, int first) {
  Components c;
  for (int k = 0; k < 4; ++k) c.part[k] = four(values + 6 * body[k] + first);
  transpose(c.part[0], c.part[1], c.part[2], c.part[3]);
  return c;
}

ALWAYS_INLINE void read_velocities(const double* velocity, const Index* body, int lane, Lanes (&v)[3],
                                   Lanes (&w)[3]) {
  const Components low = components(velocity, body, 0), high = components(velocity, body, 2);
  for (int i = 0; i < 3; ++i) four(v[i].at + lane) = low.part[i];
  for (int i = 0; i < 3; ++i) four(w[i].at + lane) = high.part[i + 1];
}

ALWAYS_INLINE void read_displacements(const double* motion, const Index* body, int lane, Lanes (&u)[3]) {
  const Components low = components(motion, body, 0);
  for (int i = 0; i < 3; ++i) four(u[i].at + lane) = low.part[i];
}

/// Six numbers of each of four lanes, ready to be added to a body.
struct Wrenches {
  Four low[4];  ///< force and the first moment
  Two high[4];  ///< the other two moments
};
ALWAYS_INLINE Wrenches wrenches(const Lanes (&force)[3], double sign, const Lanes (&moment)[3], int lane) {
  Wrenches w;
  for (int i = 0; i < 3; ++i) w.low[i] = sign * four(force[i].at + lane);
  w.low[3] = four(moment[0].at + lane);
  transpose(w.low[0], w.low[1], w.low[2], w.low[3]);
  for (int k = 0; k < 4; ++k) w.high[k] = Two{moment[1].at[lane + k], moment[2].at[lane + k]};
  return w;
}

ALWAYS_INLINE void add(double* force, Index body, const Wrenches& w, int k) {
  four(force + 6 * body) += w.low[k];
  *reinterpret_cast<Two*>(force + 6 * body + 4) += w.high[k];
}

}  // namespace

WIDE_AS_THE_MACHINE void read_motions(const BondPack& pack, const Bodies& bodies, bool displaced,
                                      EndMotions& motions) {
  const double* velocity = bodies.velocity.data();
  const double* motion = bodies.motion.data();
  for (int lane = 0; lane < pack_size; lane += 4) {
    read_velocities(velocity, pack.a + lane, lane, motions.velocity_a, motions.spin_a);
    read_velocities(velocity, pack.b + lane, lane, motions.velocity_b, motions.spin_b);
    if (!displaced) continue;
    read_displacements(motion, pack.a + lane, lane, motions.displacement_a);
    read_displacements(motion, pack.b + lane, lane, motions.displacement_b);
  }
}

WIDE_AS_THE_MACHINE void add_forces(const BondPack& pack, const EndForces& ends, Bodies& bodies) {
  double* force = bodies.force.data();
  for (int lane = 0; lane < pack_size; lane += 4) {
    const Wrenches a = wrenches(ends.force, -1, ends.moment_a, lane);
    const Wrenches b = wrenches(ends.force, 1, ends.moment_b, lane);
    for (int k = 0; k < 4; ++k) {
      add(force, pack.a[lane + k], a, k);
      add(force, pack.b[lane + k], b, k);
    }
  }
}

}  // namespace bondstatic
