#include "model/hold_cell.hpp"

#include <algorithm>
#include <numeric>

#include "model/cell.hpp"

namespace bondstatic {
namespace {

/// Connected bodies, each known by its first particle, and where the image of a particle lies that bonds lead
/// to from there.
class Bodies {
 public:
  explicit Bodies(const Model& model)
      : parent_(model.particles.size()),
        shift_(model.particles.size(), Vector3::Zero()),
        goes_round_(model.particles.size()) {
    std::iota(parent_.begin(), parent_.end(), Index(0));
    for (const Bond& bond : model.bonds) join(bond.a, bond.b, shift_of_end(model, bond), bond.branch.norm());
  }

  Index root(Index particle) {
    Index root = particle;
    Vector3 total = Vector3::Zero();
    for (; at(parent_, root) != root; root = at(parent_, root)) total += at(shift_, root);
    while (at(parent_, particle) != root && particle != root) {
      const Index next = at(parent_, particle);
      const Vector3 step = at(shift_, particle);
      at(parent_, particle) = root;
      at(shift_, particle) = total;
      total -= step;
      particle = next;
    }
    return root;
  }

  bool goes_round(Index root) { return at(goes_round_, root); }

 private:
  /// `shift`: of b's image that a is bonded to.
  void join(Index a, Index b, const Vector3& shift, double length) {
    const Index from = root(a), to = root(b);
    const Vector3 between = shift_to_root(a) - shift - shift_to_root(b);  // of the roots' images
    if (from == to) {
      at(goes_round_, from) |= between.norm() > 1e-6 * length;
      return;
    }
    const Index first = std::min(from, to), other = std::max(from, to);
    at(parent_, other) = first;
    at(shift_, other) = other == to ? between : Vector3(-between);
    at(goes_round_, first) |= at(goes_round_, other);
  }

  /// Of the root's image that bonds lead to from the particle; after root().
  Vector3 shift_to_root(Index particle) {
    return at(parent_, particle) == particle ? Vector3(Vector3::Zero()) : at(shift_, particle);
  }

  template <class T>
  static T& at(std::vector<T>& values, Index i) {
    return values[std::size_t(i)];
  }

  std::vector<Index> parent_;
  std::vector<Vector3> shift_;  ///< of the parent's image, against the particle's
  std::vector<char> goes_round_;
};

}  // namespace

void hold_translation(Model& model) {
  if (model.particles.empty()) return;
  Bodies bodies(model);
  std::vector<Index> size(model.particles.size(), 0);
  for (Index p = 0; p < Index(size.size()); ++p) ++size[std::size_t(bodies.root(p))];
  const Index largest = std::max_element(size.begin(), size.end()) - size.begin();
  for (Index p = 0; p < Index(size.size()); ++p) {
    if (p != largest && !(bodies.root(p) == p && bodies.goes_round(p))) continue;
    Support support;
    support.particle = p;
    support.fixed = {true, true, true, false, false, false};
    model.supports.push_back(support);
  }
}

}  // namespace bondstatic
