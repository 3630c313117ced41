#include "multigrid/coarsen.hpp"

#include <algorithm>

namespace bondstatic::multigrid {

namespace {

// Branches between the same two centres differ by rounding, those to two images of a centre by an edge of
// the cell.
bool same_branch(const Vector3& one, const Vector3& other) {
  return (one - other).squaredNorm() <= 1e-4 * (one.squaredNorm() + other.squaredNorm());
}

// The links between two clumps while they are added up, felt at the centre of the first one. Round a periodic
// cell a clump may have another one on two sides: these are two bundles.
struct Bundle {
  Index other = 0;
  Vector3 branch = Vector3::Zero();  // from centre to centre
  Index links = 0;
  Vector3 arms = Vector3::Zero(), arms_there = Vector3::Zero();
  Matrix6 stiffness = Matrix6::Zero();
};

// Referred to the mean contact point.
template <class Scalar>
RigidLink<Scalar> link_of(Index here, const Bundle& bundle) {
  const Vector3 arm = bundle.arms / double(bundle.links), there = bundle.arms_there / double(bundle.links);
  const Matrix6 c = seen_from_centre(bundle.stiffness, -arm);
  return {here, bundle.other, arm.cast<Scalar>(), there.cast<Scalar>(), c.cast<Scalar>()};
}

// What a clump has around it.
struct Surroundings {
  std::vector<Bundle> bundles;  // to clumps of larger number
  Matrix6 spring = Matrix6::Zero();
  bool tied = false;  // to the ground

  Bundle& to(Index other, const Vector3& branch) {
    const auto is_it = [&](const Bundle& b) { return b.other == other && same_branch(b.branch, branch); };
    auto bundle = std::find_if(bundles.begin(), bundles.end(), is_it);
    if (bundle == bundles.end()) {
      bundle = bundles.insert(bundles.end(), Bundle{});
      bundle->other = other;
      bundle->branch = branch;
    }
    return *bundle;
  }
  void tie(const Matrix6& stiffness) {
    spring += stiffness;
    tied = true;
  }
};

// A link between a body and its own image feels delta = G(arm_b) U - G(arm_a) U = Theta x (arm_b - arm_a).
Matrix6 turning_against_image(const Matrix6& c, const Vector3& between_arms) {
  Matrix6 g = Matrix6::Zero();
  g.topRightCorner<3, 3>() = -cross_matrix(between_arms);
  return g.transpose() * c * g;
}

template <class LinkType>
void look_around(const Packing<LinkType>& packing, const Clumps& clumps, const std::vector<Vector3>& offset,
                 Index clump, Index member, Surroundings& found) {
  const Vector3& at = offset[std::size_t(member)];
  if (const Spring* spring = packing.spring_of(member)) found.tie(seen_from_centre(spring->stiffness, at));
  for (const Index k : packing.incidence->of(member)) {
    const Index q = packing.other_end(k, member), other = clumps.of[std::size_t(q)];
    if (other != no_clump && other < clump) continue;  // added up from the other side
    const auto& link = packing.link(k);
    const bool at_a = link.a == member;
    const Vector3 arm = at + (at_a ? arm_a(link) : arm_b(link));
    const Vector3 arm_there = offset[std::size_t(q)] + (at_a ? arm_b(link) : arm_a(link));
    if (other == clump) {
      // Of no effect inside the clump, but for one that goes round a periodic cell: that resists turning.
      if (at_a && !same_branch(arm, arm_there))
        found.tie(turning_against_image(stiffness_of(link), arm_there - arm));
      continue;
    }
    const Matrix6 felt = seen_from_centre(stiffness_of(link), arm);
    if (other == no_clump) {
      found.tie(felt);
      continue;
    }
    Bundle& bundle = found.to(other, arm - arm_there);
    ++bundle.links;
    bundle.arms += arm;
    bundle.arms_there += arm_there;
    bundle.stiffness += felt;
  }
}

template <class LinkType>
void take_offsets_of_copies(const Packing<LinkType>& packing, std::vector<Vector3>& offset) {
  if (!packing.halo->ranks) return;
  std::vector<std::array<double, 3>> plain;
  for (const Vector3& at : offset) plain.push_back({at.x(), at.y(), at.z()});
  refresh(*packing.halo, plain);
  for (std::size_t p = std::size_t(packing.own); p < plain.size(); ++p)
    offset[p] = Vector3(plain[p][0], plain[p][1], plain[p][2]);
}

}  // namespace

template <class LinkType>
std::vector<Vector3> offsets_in_clumps(const Packing<LinkType>& packing, const Clumps& clumps, int threads) {
  const Incidence members = members_of(clumps);
  std::vector<Vector3> offset(std::size_t(packing.bodies), Vector3::Zero());
#pragma omp parallel num_threads(threads)
  {
    std::vector<Index> walked;
#pragma omp for schedule(static)
    for (Index c = 0; c < clumps.count; ++c) {
      const auto all = members.of(c);
      walked.assign(1, all.front());
      Vector3 sum = Vector3::Zero();
      for (std::size_t next = 0; next < walked.size(); ++next) {
        const Index p = walked[next];
        for (const Index k : packing.incidence->of(p)) {
          const Index q = packing.other_end(k, p);
          if (clumps.of[std::size_t(q)] != c || std::find(walked.begin(), walked.end(), q) != walked.end())
            continue;
          const auto& link = packing.link(k);
          const Vector3 branch = arm_a(link) - arm_b(link);
          offset[std::size_t(q)] = offset[std::size_t(p)] + (link.a == p ? 1 : -1) * branch;
          sum += offset[std::size_t(q)];
          walked.push_back(q);
        }
      }
      for (const Index p : all) offset[std::size_t(p)] -= sum / double(all.size());
    }
  }
  take_offsets_of_copies(packing, offset);
  return offset;
}

template <class Scalar, class LinkType>
CoarsePacking<Scalar> coarsen(const Packing<LinkType>& packing, const Clumps& clumps,
                              const std::vector<Vector3>& offsets, int threads) {
  // Parts of a fixed size, put together in order, so that links are numbered alike on any number of threads.
  constexpr Index part_size = 256;
  struct Part {
    std::vector<RigidLink<Scalar>> links;
    std::vector<Spring> springs;
  };
  const Incidence members = members_of(clumps);
  std::vector<Part> parts(std::size_t((clumps.count + part_size - 1) / part_size));
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (Index n = 0; n < Index(parts.size()); ++n) {
    Part& part = parts[std::size_t(n)];
    for (Index c = n * part_size; c < std::min(clumps.count, (n + 1) * part_size); ++c) {
      Surroundings found;
      for (const Index p : members.of(c)) look_around(packing, clumps, offsets, c, p, found);
      for (const Bundle& bundle : found.bundles) part.links.push_back(link_of<Scalar>(c, bundle));
      if (found.tied) part.springs.push_back({c, found.spring});
    }
  }
  CoarsePacking<Scalar> coarse;
  coarse.own = clumps.count;
  coarse.bodies = clumps.count + clumps.copies;
  coarse.halo = {packing.halo->ranks, clumps.neighbours};
  std::size_t links = 0;
  for (const Part& part : parts) links += part.links.size();
  coarse.links.reserve(links);
  for (Part& part : parts) {
    coarse.links.insert(coarse.links.end(), part.links.begin(), part.links.end());
    coarse.springs.insert(coarse.springs.end(), part.springs.begin(), part.springs.end());
    part = {};
  }
  coarse.incidence = incidence_of(coarse.links, coarse.bodies);
  return coarse;
}

template std::vector<Vector3> offsets_in_clumps(const Packing<Link>&, const Clumps&, int);
template std::vector<Vector3> offsets_in_clumps(const Packing<RigidLink<float>>&, const Clumps&, int);
template std::vector<Vector3> offsets_in_clumps(const Packing<RigidLink<double>>&, const Clumps&, int);
template CoarsePacking<float> coarsen(const Packing<Link>&, const Clumps&, const std::vector<Vector3>&, int);
template CoarsePacking<double> coarsen(const Packing<Link>&, const Clumps&, const std::vector<Vector3>&, int);
template CoarsePacking<float> coarsen(const Packing<RigidLink<float>>&, const Clumps&,
                                      const std::vector<Vector3>&, int);
template CoarsePacking<double> coarsen(const Packing<RigidLink<double>>&, const Clumps&,
                                       const std::vector<Vector3>&, int);

}  // namespace bondstatic::multigrid
