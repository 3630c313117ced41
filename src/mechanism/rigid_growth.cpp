#include "mechanism/rigid_growth.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <deque>
#include <unordered_map>

namespace bondstatic {
namespace {

constexpr double clearly_rigid = 1e-3;

using Joint = std::vector<Index>;  // constraints between two bodies

bool is_rigid(const std::vector<Constraint>& constraints, const Joint& joint) {
  if (joint.size() < 6) return false;
  Vector3 centre = Vector3::Zero();
  for (const Index k : joint) centre += constraints[std::size_t(k)].at_b / double(joint.size());
  double size = 0;
  for (const Index k : joint) size = std::max(size, (constraints[std::size_t(k)].at_b - centre).norm());
  if (size == 0) size = 1;
  // The square of 1e-3 is far above rounding, so that here the Gram matrix may be trusted.
  Matrix6 gram = Matrix6::Zero();
  for (const Index k : joint) {
    const Constraint& c = constraints[std::size_t(k)];
    const Vector6 row = wrench_on(c, c.at_b, centre, size).normalized();
    gram += row * row.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(gram, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[0] > clearly_rigid * clearly_rigid;
}

}  // namespace

Partition grow_rigid(Index bodies, const std::vector<Constraint>& constraints) {
  Partition sets(bodies + 1);
  std::vector<std::unordered_map<Index, Joint>> joints(std::size_t(bodies) + 1);
  for (std::size_t k = 0; k < constraints.size(); ++k) {
    const Constraint& c = constraints[k];
    if (c.shifted) continue;  // no form of the relative motion alone
    const Index a = c.a == ground ? bodies : c.a;
    joints[std::size_t(a)][c.b].push_back(Index(k));
    joints[std::size_t(c.b)][a].push_back(Index(k));
  }
  std::deque<std::pair<Index, Index>> doubtful;
  for (Index a = 0; a <= bodies; ++a)
    for (const auto& [b, joint] : joints[std::size_t(a)])
      if (a < b) doubtful.emplace_back(a, b);
  while (!doubtful.empty()) {
    auto [a, b] = doubtful.front();
    doubtful.pop_front();
    if (sets.find(a) != a || sets.find(b) != b) continue;  // stands for itself no longer, its heir is queued
    const auto found = joints[std::size_t(a)].find(b);
    if (found == joints[std::size_t(a)].end() || !is_rigid(constraints, found->second)) continue;
    sets.unite(a, b);
    const Index heir = sets.find(a), gone = heir == a ? b : a;
    auto& taken = joints[std::size_t(heir)];
    taken.erase(gone);
    for (auto& [other, joint] : joints[std::size_t(gone)]) {
      if (other == heir) continue;
      Joint& ours = taken[other];
      ours.insert(ours.end(), joint.begin(), joint.end());
      joints[std::size_t(other)].erase(gone);
      joints[std::size_t(other)][heir] = ours;
      doubtful.emplace_back(heir, other);
    }
    joints[std::size_t(gone)].clear();
  }
  return sets;
}

}  // namespace bondstatic
