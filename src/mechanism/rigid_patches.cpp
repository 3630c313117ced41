#include "mechanism/rigid_patches.hpp"

#include <algorithm>
#include <unordered_map>

#include "mechanism/constraint_rows.hpp"

namespace bondstatic {
namespace {

using Incidence = std::vector<std::vector<std::size_t>>;  // body -> its rows

// The bodies nearest to `root`, counted in bonds; paths do not lead through bodies that touch very many.
std::vector<Index> neighbourhood(const std::vector<ConstraintRow>& rows, const Incidence& rows_of,
                                 Index root) {
  constexpr std::size_t very_many = 300;
  std::vector<Index> patch{root};
  std::unordered_map<Index, bool> met{{root, true}};
  for (std::size_t next = 0; next < patch.size(); ++next) {
    const auto& around = rows_of[std::size_t(patch[next])];
    if (next > 0 && around.size() > very_many) continue;
    for (const std::size_t k : around)
      for (const Index other : {rows[k].a, rows[k].b})
        if (other != ground && Index(patch.size()) < patch_size && met.emplace(other, true).second)
          patch.push_back(other);
  }
  return patch;
}

// Unites what cannot move in the patch taken by itself, with the ground where that touches the patch and with
// the root elsewhere.
void unite_still(const std::vector<RigidBody>& bodies, const std::vector<ConstraintRow>& rows,
                 const Incidence& rows_of, const std::vector<Index>& patch, Partition& sets) {
  std::unordered_map<Index, Index> number{{ground, ground}};
  std::vector<Vector3> centres;
  for (const Index body : patch) {
    number.emplace(body, Index(centres.size()));
    centres.push_back(bodies[std::size_t(body)].centre);
  }
  std::vector<ConstraintRow> inside;
  bool grounded = false;
  for (const Index body : patch)
    for (const std::size_t k : rows_of[std::size_t(body)]) {
      if (rows[k].b != body || !number.contains(rows[k].a)) continue;
      ConstraintRow row = rows[k];
      row.a = number[row.a], row.b = number[row.b];
      grounded = grounded || row.a == ground;
      inside.push_back(row);
    }
  for (int i = 0; i < 6 && !grounded; ++i)
    inside.push_back({.a = ground, .b = 0, .at_a = Vector6::Zero(), .at_b = Vector6::Unit(i)});
  std::vector<bool> moves(patch.size(), false);
  for (const NullVector& vector : null_space(centres, inside))
    for (const auto& [body, motion] : vector) moves[std::size_t(body)] = true;
  const Index base = grounded ? Index(bodies.size()) : patch.front();
  for (std::size_t i = 0; i < patch.size(); ++i)
    if (!moves[i]) sets.unite(base, patch[i]);
}

}  // namespace

Partition rigid_patches(const std::vector<RigidBody>& bodies, const std::vector<Constraint>& constraints,
                        Index patches) {
  const std::vector<ConstraintRow> rows = constraint_rows(bodies, constraints);
  const Index count = Index(bodies.size());
  Incidence rows_of(bodies.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rows[k].a != ground) rows_of[std::size_t(rows[k].a)].push_back(k);
    rows_of[std::size_t(rows[k].b)].push_back(k);
  }
  Partition sets(count + 1);
  for (Index i = 0; i < patches; ++i) {
    const Index root = (2 * i + 1) * count / (2 * patches);
    unite_still(bodies, rows, rows_of, neighbourhood(rows, rows_of, root), sets);
  }
  return sets;
}

}  // namespace bondstatic
