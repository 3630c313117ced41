#include "system/link_sweeps.hpp"

#include <omp.h>

#include <algorithm>

#include "system/extended_lanes.hpp"

namespace bondstatic {

namespace {

/// Numbers of four links; where the list ends, the last one fills the lanes.
struct FourLinks {
  std::size_t a[links_at_once], b[links_at_once];
  FourBranches branch;
  FourDoubles fraction, kn, ks, kt, kb, coupling;
  bool coupled = false;
};

ALWAYS_INLINE FourLinks four_links(const Link* links, Index count) {
  FourLinks four;
  for (int i = 0; i < links_at_once; ++i) {
    const Link& link = links[std::min<Index>(i, count - 1)];
    four.a[i] = std::size_t(link.a), four.b[i] = std::size_t(link.b);
    four.branch.x[i] = link.branch[0], four.branch.y[i] = link.branch[1], four.branch.z[i] = link.branch[2];
    four.fraction[i] = link.fraction;
    four.kn[i] = link.stiffness.kn, four.ks[i] = link.stiffness.ks;
    four.kt[i] = link.stiffness.kt, four.kb[i] = link.stiffness.kb;
    four.coupling[i] = link.stiffness.coupling;
    four.coupled = four.coupled || link.stiffness.coupling != 0;
  }
  return four;
}

ALWAYS_INLINE FourExtended four_of(const double* values, Index count) {
  FourExtended four{};
  for (int i = 0; i < links_at_once; ++i) four.high[i] = values[std::min<Index>(i, count - 1)];
  return four;
}
ALWAYS_INLINE FourExtended four_of(const Vector6* vectors, Index count, int entry) {
  FourExtended four{};
  for (int i = 0; i < links_at_once; ++i) four.high[i] = vectors[std::min<Index>(i, count - 1)][entry];
  return four;
}

ALWAYS_INLINE FourExtended number(const Vector6T<Extended>* vectors, const std::size_t (&at)[links_at_once],
                                  int i) {
  FourExtended four;
  for (int k = 0; k < links_at_once; ++k) {
    const Extended& value = vectors[at[k]][i];
    four.high[k] = value.x[0], four.low[k] = value.x[1];
  }
  return four;
}

ALWAYS_INLINE FourVectors numbers(const Vector6T<Extended>* vectors, const std::size_t (&at)[links_at_once],
                                  int first) {
  return {number(vectors, at, first), number(vectors, at, first + 1), number(vectors, at, first + 2)};
}

/// Relative displacement at the contact point and relative rotation.
struct FourMotions {
  FourVectors d, r;
};

ALWAYS_INLINE FourMotions relative_motions(const FourLinks& links, const Vector6T<Extended>* motion) {
  const FourVectors theta = numbers(motion, links.b, 3), r = theta - numbers(motion, links.a, 3);
  const FourVectors lever = theta - r * links.fraction;
  return {numbers(motion, links.b, 0) - numbers(motion, links.a, 0) - cross(lever, links.branch), r};
}

ALWAYS_INLINE FourVectors apart(const FourLinks& links, const double* strain) {
  FourExtended sum[3];
  for (int i = 0; i < 3; ++i)
    sum[i] = exact_product(strain[i] + 0 * links.branch.x, links.branch.x) +
             exact_product(strain[i + 3] + 0 * links.branch.x, links.branch.y) +
             exact_product(strain[i + 6] + 0 * links.branch.x, links.branch.z);
  return {sum[0], sum[1], sum[2]};
}

ALWAYS_INLINE FourExtended squared_length(const FourBranches& b) {
  return exact_product(b.x, b.x) + exact_product(b.y, b.y) + exact_product(b.z, b.z);
}

ALWAYS_INLINE FourMotions link_motions(const FourLinks& links, const Vector6T<Extended>* motion,
                                       const double* strain) {
  FourMotions delta = relative_motions(links, motion);
  if (strain) delta.d = delta.d + apart(links, strain);
  return delta;
}

/// Force and moment at the contact point.
struct FourResultants {
  FourVectors force, moment;
};

ALWAYS_INLINE FourResultants resultants(const FourLinks& links, const FourMotions& delta) {
  const FourExtended square = squared_length(links.branch), per_square = inverse(square);
  const FourVectors along_d = dot(delta.d, links.branch) * per_square * links.branch;
  const FourVectors along_r = dot(delta.r, links.branch) * per_square * links.branch;
  FourResultants q{along_d * links.kn + (delta.d - along_d) * links.ks,
                   along_r * links.kt + (delta.r - along_r) * links.kb};
  if (links.coupled) {
    const FourExtended c = inverse_root(square) * links.coupling;
    q.force = q.force + cross(delta.r, links.branch) * c;
    q.moment = q.moment - cross(delta.d, links.branch) * c;
  }
  return q;
}

ALWAYS_INLINE void store(const FourVectors& from, Index lane, Extended* to) {
  to[0] = from.x[int(lane)];
  to[1] = from.y[int(lane)];
  to[2] = from.z[int(lane)];
}

/// What a link does to its bodies: the force on a, its opposite on b, and moments about the centres of both.
struct EndForces {
  Extended force[3], moment_a[3], moment_b[3];
};

/// `strain` by columns, or null.
WIDE_AS_THE_MACHINE void end_forces(const Link* first, Index links, const Vector6T<Extended>* motion,
                                    const double* strain, EndForces* ends) {
  for (Index k = 0; k < links; k += links_at_once) {
    const Index count = std::min<Index>(links_at_once, links - k);
    const FourLinks four = four_links(first + k, count);
    const FourResultants q = resultants(four, link_motions(four, motion, strain));
    const FourVectors turning = cross(q.force, four.branch);  // opposite to branch x force
    const FourVectors of_a = turning * four.fraction;
    const FourVectors moment_a = q.moment - of_a, moment_b = of_a - turning - q.moment;
    for (Index i = 0; i < count; ++i) {
      store(q.force, i, ends[k + i].force);
      store(moment_a, i, ends[k + i].moment_a);
      store(moment_b, i, ends[k + i].moment_b);
    }
  }
}

WIDE_AS_THE_MACHINE void states(const Link* first, Index links, const Vector6T<Extended>* motion,
                                const double* strain, LinkState* found) {
  for (Index k = 0; k < links; k += links_at_once) {
    const Index count = std::min<Index>(links_at_once, links - k);
    const FourLinks four = four_links(first + k, count);
    const FourMotions delta = link_motions(four, motion, strain);
    const FourResultants q = resultants(four, delta);
    for (Index i = 0; i < count; ++i) {
      store(delta.d, i, found[k + i].delta.data());
      store(delta.r, i, found[k + i].delta.data() + 3);
      store(q.force, i, found[k + i].q.data());
      store(q.moment, i, found[k + i].q.data() + 3);
    }
  }
}

WIDE_AS_THE_MACHINE void products(const Link* first, Index links, const Vector6T<Extended>* motion,
                                  const double* strain, const Vector6T<Extended>* epsilon,
                                  const double* of_motion, const Vector6* own, const double* kept,
                                  SectionStiffness* found) {
  for (Index k = 0; k < links; k += links_at_once) {
    const Index count = std::min<Index>(links_at_once, links - k);
    const FourLinks four = four_links(first + k, count);
    const FourMotions delta = link_motions(four, motion, strain);
    FourMotions felt = relative_motions(four, epsilon);
    const FourDoubles part = four_of(of_motion + k, count).high, with_moments = four_of(kept + k, count).high;
    const FourVectors own_d{four_of(own + k, count, 0), four_of(own + k, count, 1),
                            four_of(own + k, count, 2)};
    const FourVectors own_r{four_of(own + k, count, 3), four_of(own + k, count, 4),
                            four_of(own + k, count, 5)};
    felt = {felt.d + delta.d * part + own_d, felt.r + delta.r * part};
    const FourVectors felt_moments = felt.r * with_moments + own_r, felt_r = felt.r + own_r;

    const FourExtended square = squared_length(four.branch), per_square = inverse(square);
    const FourExtended kn = dot(felt.d, four.branch) * dot(delta.d, four.branch) * per_square;
    const FourExtended ks = dot(felt.d, delta.d) - kn;
    const FourExtended kt = dot(felt_moments, four.branch) * dot(delta.r, four.branch) * per_square;
    const FourExtended kb = dot(felt_moments, delta.r) - kt;
    const FourExtended coupling =
        (dot(cross(delta.r, four.branch), felt.d) - dot(cross(delta.d, four.branch), felt_r)) *
        inverse_root(square);
    for (Index i = 0; i < count; ++i) {
      const auto lane = int(i);
      found[k + i] = {to_double(kn[lane]), to_double(ks[lane]), to_double(kt[lane]), to_double(kb[lane]),
                      to_double(coupling[lane])};
    }
  }
}

// A thread takes whole blocks of links. A link takes 0.1 us, waking the other threads as long as a thousand
// of them.
constexpr Index block = 256, links_worth_threads = 16384;

// What so many links do to their ends stays in the cache until it is added up.
constexpr Index stretch = 1 << 15;

// Which bodies a thread adds up: all links at a body in their order, so that sums do not depend on threads.
class Turns {
 public:
  bool own(Index body) const { return body / beside % threads_ == thread_; }

 private:
  static constexpr Index beside = 64;  // bodies; near ones are needed at the same time
  Index threads_ = omp_get_num_threads(), thread_ = omp_get_thread_num();
};

const double* columns_of(const Matrix3& strain) {
  return strain.isZero(0) ? nullptr : strain.data();
}

}  // namespace

void subtract_carried_forces(const BondNetwork& network, const BodyVectors<Extended>& motion,
                             const Matrix3& strain, int threads, BodyVectors<Extended>& forces) {
  const Index count = Index(network.links.size());
  std::vector<EndForces> ends(std::size_t(std::min(stretch, count)));
#pragma omp parallel num_threads(threads) if (threads > 1 && count > links_worth_threads)
  for (Index first = 0; first < count; first += stretch) {
    const Index last = std::min(count, first + stretch);
    const Link* const links = network.links.data() + first;
#pragma omp for schedule(static)
    for (Index k = first; k < last; k += block)
      end_forces(links + (k - first), std::min(block, last - k), motion.data(), columns_of(strain),
                 ends.data() + (k - first));
    const Turns turns;
    for (Index k = 0; k < last - first; ++k) {
      const EndForces& end = ends[std::size_t(k)];
      if (turns.own(links[k].a)) {
        auto& left = forces[std::size_t(links[k].a)];
        for (int i = 0; i < 3; ++i) left[i] += end.force[i], left[i + 3] += end.moment_a[i];
      }
      if (turns.own(links[k].b)) {
        auto& left = forces[std::size_t(links[k].b)];
        for (int i = 0; i < 3; ++i) left[i] -= end.force[i], left[i + 3] += end.moment_b[i];
      }
    }
#pragma omp barrier
  }
}

void link_states(const BondNetwork& network, const BodyVectors<Extended>& motion, const Matrix3& strain,
                 Index first, Index last, LinkState* found) {
  states(network.links.data() + first, last - first, motion.data(), columns_of(strain), found);
}

std::vector<SectionStiffness> stiffness_products(const BondNetwork& network,
                                                 const BodyVectors<Extended>& motion, const Matrix3& strain,
                                                 const LinkEpsilon& epsilon, int threads) {
  const Index count = Index(network.links.size());
  std::vector<SectionStiffness> found(network.links.size());
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1 && count > links_worth_threads)
  for (Index k = 0; k < count; k += block)
    products(network.links.data() + k, std::min(block, count - k), motion.data(), columns_of(strain),
             epsilon.motion.data(), epsilon.of_motion.data() + k, epsilon.own.data() + k,
             epsilon.kept.data() + k, found.data() + k);
  return found;
}

}  // namespace bondstatic
