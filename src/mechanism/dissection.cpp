#include "mechanism/dissection.hpp"

#include <algorithm>
#include <numeric>

namespace bondstatic {
namespace {

constexpr std::size_t leaf_size = 12;

class Dissection {
 public:
  Dissection(const std::vector<Vector3>& places, const std::vector<std::vector<Index>>& neighbours)
      : places_(places), neighbours_(neighbours), part_(places.size(), nowhere) {}

  /// Number of the front on top of `vertices`.
  Index run(std::vector<Index> vertices) {
    if (vertices.size() <= leaf_size) return add({std::move(vertices), {}});
    const std::size_t middle = vertices.size() / 2;
    const int axis = longest_axis(vertices);
    std::nth_element(vertices.begin(), vertices.begin() + std::ptrdiff_t(middle), vertices.end(),
                     [&](Index i, Index j) {
                       const double x = places_[std::size_t(i)][axis], y = places_[std::size_t(j)][axis];
                       return x < y || (x == y && i < j);
                     });
    for (std::size_t k = 0; k < vertices.size(); ++k)
      part_[std::size_t(vertices[k])] = k < middle ? left : right;
    FrontShape top{separator(vertices), {}};
    std::vector<Index> halves[2];
    for (const Index v : vertices) {
      const int part = part_[std::size_t(v)];
      if (part != between) halves[part].push_back(v);
      part_[std::size_t(v)] = nowhere;
    }
    for (auto& half : halves)
      if (!half.empty()) top.children.push_back(run(std::move(half)));
    return add(std::move(top));
  }

  std::vector<FrontShape> take() { return std::move(fronts_); }

 private:
  enum Part { left = 0, right = 1, between, nowhere };

  Index add(FrontShape front) {
    fronts_.push_back(std::move(front));
    return Index(fronts_.size()) - 1;
  }

  int longest_axis(const std::vector<Index>& vertices) const {
    Vector3 low = places_[std::size_t(vertices.front())], high = low;
    for (const Index v : vertices) {
      low = low.cwiseMin(places_[std::size_t(v)]);
      high = high.cwiseMax(places_[std::size_t(v)]);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    return axis;
  }

  bool is_across(Index v, Index w) const { return part_[std::size_t(w)] == 1 - part_[std::size_t(v)]; }

  Index cut_edges(Index v) const {
    const auto& all = neighbours_[std::size_t(v)];
    return std::count_if(all.begin(), all.end(), [&](Index w) { return is_across(v, w); });
  }

  // Vertices that cover all edges between the halves, those with the most edges first: a large body that many
  // small ones touch goes in before them.
  std::vector<Index> separator(const std::vector<Index>& vertices) {
    std::vector<std::pair<Index, Index>> candidates;
    for (const Index v : vertices)
      if (const Index cut = cut_edges(v)) candidates.emplace_back(-cut, v);
    std::sort(candidates.begin(), candidates.end(), [&](const auto& p, const auto& q) {
      if (p.first != q.first) return p.first < q.first;
      const int s = part_[std::size_t(p.second)], t = part_[std::size_t(q.second)];
      return s != t ? s < t : p.second < q.second;
    });
    std::vector<Index> taken;
    for (const auto& [cut, v] : candidates) {
      if (cut_edges(v) == 0) continue;
      part_[std::size_t(v)] = between;
      taken.push_back(v);
    }
    return taken;
  }

  const std::vector<Vector3>& places_;
  const std::vector<std::vector<Index>>& neighbours_;
  std::vector<int> part_;
  std::vector<FrontShape> fronts_;
};

}  // namespace

std::vector<FrontShape> dissect(const std::vector<Vector3>& places,
                                const std::vector<std::vector<Index>>& neighbours) {
  std::vector<Index> all(places.size());
  std::iota(all.begin(), all.end(), Index(0));
  Dissection dissection(places, neighbours);
  dissection.run(std::move(all));
  return dissection.take();
}

}  // namespace bondstatic
