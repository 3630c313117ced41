#include "system/assemble.hpp"

#include <algorithm>
#include <array>

#include "system/natural_form.hpp"

namespace bondstatic {

namespace {

// B of one end of the link, with rotations scaled by 1 / length: delta = B_a (u_a, length theta_a) + B_b
// (...).
Matrix6 end_motion(const Link& link, bool at_a, double length) {
  const double sign = at_a ? -1 : 1, share = at_a ? link.fraction : 1 - link.fraction;
  const Vector3 arm = (share / length) * link.branch;
  Matrix6 b = Matrix6::Zero();
  b.topLeftCorner<3, 3>().diagonal().setConstant(sign);
  b.bottomRightCorner<3, 3>().diagonal().setConstant(sign / length);
  // - theta x arm = arm x theta
  b.topRightCorner<3, 3>() << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
  return b;
}

// Degrees of freedom of a body that are unknowns, in order.
struct FreeList {
  std::array<int, 6> dof;
  int count = 0;
  FreeList(const FreeDofs& dofs, Index body) {
    for (int i = 0; i < 6; ++i)
      if (dofs.is_free(body, i)) dof[std::size_t(count++)] = i;
  }
};

}  // namespace

BodyGraph body_graph(const BondNetwork& network, const Incidence& incidence) {
  BodyGraph graph;
  graph.offset.reserve(std::size_t(network.bodies) + 1);
  graph.offset.push_back(0);
  graph.neighbour.reserve(2 * network.links.size());
  for (Index p = 0; p < network.bodies; ++p) {
    const auto begin = std::ptrdiff_t(graph.neighbour.size());
    for (const Index k : incidence.of(p)) {
      const Link& link = network.links[std::size_t(k)];
      graph.neighbour.push_back(link.a == p ? link.b : link.a);
    }
    std::sort(graph.neighbour.begin() + begin, graph.neighbour.end());
    graph.neighbour.erase(std::unique(graph.neighbour.begin() + begin, graph.neighbour.end()),
                          graph.neighbour.end());
    graph.offset.push_back(Index(graph.neighbour.size()));
  }
  return graph;
}

SparseMatrix stiffness_pattern(const BodyGraph& graph, const FreeDofs& dofs) {
  const Index n = dofs.unknowns(), bodies = Index(graph.offset.size()) - 1;
  const auto width = [&dofs](Index p) { return dofs.first[std::size_t(p) + 1] - dofs.first[std::size_t(p)]; };
  SparseMatrix k(n, n);
  std::vector<Index> below(std::size_t(bodies), 0);  // unknowns of the neighbours with a larger number
  Index entries = 0;
  for (Index p = 0; p < bodies; ++p) {
    for (Index s = graph.offset[std::size_t(p)]; s < graph.offset[std::size_t(p) + 1]; ++s)
      if (graph.neighbour[std::size_t(s)] > p)
        below[std::size_t(p)] += width(graph.neighbour[std::size_t(s)]);
    entries += width(p) * below[std::size_t(p)] + width(p) * (width(p) + 1) / 2;
  }
  k.resizeNonZeros(entries);
  Index at = 0;
  for (Index p = 0; p < bodies; ++p) {
    for (Index c = dofs.first[std::size_t(p)]; c < dofs.first[std::size_t(p) + 1]; ++c) {
      k.outerIndexPtr()[c] = at;
      for (Index r = c; r < dofs.first[std::size_t(p) + 1]; ++r) k.innerIndexPtr()[at++] = r;
      for (Index s = graph.offset[std::size_t(p)]; s < graph.offset[std::size_t(p) + 1]; ++s) {
        const Index q = graph.neighbour[std::size_t(s)];
        if (q < p) continue;
        for (Index r = dofs.first[std::size_t(q)]; r < dofs.first[std::size_t(q) + 1]; ++r)
          k.innerIndexPtr()[at++] = r;
      }
    }
  }
  k.outerIndexPtr()[n] = at;
  std::fill_n(k.valuePtr(), entries, 0.0);
  return k;
}

void assemble(const BondNetwork& network, const Incidence& incidence, const BodyGraph& graph,
              const FreeDofs& dofs, int threads, SparseMatrix& k) {
  const double length = network.rotation_length;
#pragma omp parallel for schedule(static) \
    num_threads(threads) if (threads > 1 && network.bodies > worth_threads)
  for (Index p = 0; p < network.bodies; ++p) {
    const FreeList columns(dofs, p);
    if (columns.count == 0) continue;
    const Index* start = k.outerIndexPtr() + dofs.first[std::size_t(p)];
    std::fill(k.valuePtr() + start[0], k.valuePtr() + start[columns.count], 0.0);
    // Where the rows of each neighbour begin, counted from the end of the diagonal block.
    const Index* first_neighbour = graph.neighbour.data() + graph.offset[std::size_t(p)];
    const Index* last_neighbour = graph.neighbour.data() + graph.offset[std::size_t(p) + 1];
    for (const Index link_index : incidence.of(p)) {
      const Link& link = network.links[std::size_t(link_index)];
      const bool at_a = link.a == p;
      const Index other = at_a ? link.b : link.a;
      const Matrix6 here = end_motion(link, at_a, length);
      const Matrix6 cb = constitutive_matrix(link.stiffness, bond_axis<double>(link)) * here;
      const Matrix6 own = here.transpose() * cb;
      for (int c = 0; c < columns.count; ++c)
        for (int r = c; r < columns.count; ++r)
          k.valuePtr()[start[c] + r - c] += own(columns.dof[std::size_t(r)], columns.dof[std::size_t(c)]);
      const FreeList rows(dofs, other);
      if (other < p || rows.count == 0) continue;
      const Matrix6 across = end_motion(link, !at_a, length).transpose() * cb;
      Index skip = 0;
      for (const Index* q = first_neighbour; q != last_neighbour && *q < other; ++q)
        if (*q > p) skip += dofs.first[std::size_t(*q) + 1] - dofs.first[std::size_t(*q)];
      for (int c = 0; c < columns.count; ++c)
        for (int r = 0; r < rows.count; ++r)
          k.valuePtr()[start[c] + columns.count - c + skip + r] +=
              across(rows.dof[std::size_t(r)], columns.dof[std::size_t(c)]);
    }
  }
}

}  // namespace bondstatic
