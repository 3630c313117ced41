#include "mechanism/null_space.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mechanism/dissection.hpp"
#include "mechanism/rank_revealing.hpp"

namespace bondstatic {
namespace {

constexpr double negligible_motion = 1e-8;  // of the largest: rounding

struct Front {
  FrontShape shape;
  std::vector<Index> boundary;  // bodies of ancestors that the rest binds
  FrontFactor factor;
};

// Motions of the bodies touched so far; one column a null vector.
using Motions = std::map<Index, Eigen::MatrixXd>;

class NullSpace {
 public:
  NullSpace(const std::vector<Vector3>& centres, const std::vector<ConstraintRow>& rows)
      : rows_(rows), scale_(centres.size(), Vector6::Zero()), place_(centres.size(), -1) {
    scale_columns();
    std::vector<std::vector<Index>> neighbours(centres.size());
    for (const ConstraintRow& row : rows) {
      if (row.a < 0 || row.a == row.b) continue;
      neighbours[std::size_t(row.a)].push_back(row.b);
      neighbours[std::size_t(row.b)].push_back(row.a);
    }
    for (auto& all : neighbours) {
      std::sort(all.begin(), all.end());
      all.erase(std::unique(all.begin(), all.end()), all.end());
    }
    for (FrontShape& shape : dissect(centres, neighbours)) fronts_.push_back({std::move(shape), {}, {}});
    distribute_rows();
  }

  std::vector<NullVector> find() {
    std::vector<NullVector> vectors;
    for (std::size_t f = 0; f < fronts_.size(); ++f) {
      factorise(f);
      append_vectors(f, vectors);
    }
    return vectors;
  }

 private:
  // Columns longer than one, as those of a body with many neighbours, are brought down to it so that one
  // tolerance suits all. Short columns stay: a lever arm of 1e-12 is a rounded zero.
  void scale_columns() {
    for (const ConstraintRow& row : rows_) {
      if (row.a >= 0) scale_[std::size_t(row.a)] += row.at_a.cwiseAbs2();
      scale_[std::size_t(row.b)] += row.at_b.cwiseAbs2();
    }
    for (Vector6& scale : scale_) scale = scale.cwiseSqrt().cwiseMax(1).cwiseInverse();
  }

  void distribute_rows() {
    std::vector<std::size_t> front_of(place_.size());
    for (std::size_t f = 0; f < fronts_.size(); ++f)
      for (const Index body : fronts_[f].shape.eliminated) front_of[std::size_t(body)] = f;
    rows_of_.resize(fronts_.size());
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      std::size_t f = front_of[std::size_t(rows_[k].b)];
      if (rows_[k].a >= 0) f = std::min(f, front_of[std::size_t(rows_[k].a)]);  // the descendant
      rows_of_[f].push_back(k);
    }
  }

  // Bodies of the front in the order of its columns, numbered in place_; returns how many.
  Index number_bodies(Front& front, const std::vector<std::size_t>& rows) {
    Index count = 0;
    for (const Index body : front.shape.eliminated) place_[std::size_t(body)] = count++;
    const auto meet = [&](Index body) {
      if (place_[std::size_t(body)] >= 0) return;
      place_[std::size_t(body)] = count++;
      front.boundary.push_back(body);
    };
    for (const std::size_t k : rows) {
      if (rows_[k].a >= 0) meet(rows_[k].a);
      meet(rows_[k].b);
    }
    for (const Index child : front.shape.children)
      for (const Index body : fronts_[std::size_t(child)].boundary) meet(body);
    return count;
  }

  void factorise(std::size_t f) {
    Front& front = fronts_[f];
    const auto& own = rows_of_[f];
    const Index bodies = number_bodies(front, own);
    Index height = Index(own.size());
    for (const Index child : front.shape.children) height += fronts_[std::size_t(child)].factor.rest.rows();

    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(height, 6 * bodies);
    Index r = 0;
    const auto put = [&](Index body, const Vector6& form) {
      matrix.row(r).segment<6>(6 * place_[std::size_t(body)]) +=
          form.cwiseProduct(scale_[std::size_t(body)]).transpose();
    };
    for (const std::size_t k : own) {
      if (rows_[k].a >= 0) put(rows_[k].a, rows_[k].at_a);
      put(rows_[k].b, rows_[k].at_b);
      ++r;
    }
    for (const Index child : front.shape.children) {
      Front& below = fronts_[std::size_t(child)];
      Eigen::MatrixXd& rest = below.factor.rest;
      for (std::size_t j = 0; j < below.boundary.size(); ++j)
        matrix.block(r, 6 * place_[std::size_t(below.boundary[j])], rest.rows(), 6) =
            rest.middleCols(6 * Index(j), 6);
      r += rest.rows();
      rest.resize(0, 0);
    }
    for (const Index body : front.shape.eliminated) place_[std::size_t(body)] = -1;
    for (const Index body : front.boundary) place_[std::size_t(body)] = -1;
    front.factor = factorise_front(std::move(matrix), 6 * Index(front.shape.eliminated.size()), free_strain);
  }

  // What stays free in a front moves its bodies and those eliminated below it, while all above stand still.
  void append_vectors(std::size_t f, std::vector<NullVector>& vectors) const {
    const FrontFactor& factor = fronts_[f].factor;
    const Index free = Index(factor.order.size()) - factor.rank;
    if (free == 0) return;
    Eigen::MatrixXd values(Index(factor.order.size()), free);
    values.topRows(factor.rank) = factor.free;
    values.bottomRows(free).setIdentity();
    Motions motions;
    place(fronts_[f], values, motions);
    for (const Index child : fronts_[f].shape.children) descend(std::size_t(child), free, motions);

    for (Index k = 0; k < free; ++k) {
      double largest = 0;
      for (auto& [body, motion] : motions) {
        const Vector6 unscaled = motion.col(k).cwiseProduct(scale_[std::size_t(body)]);
        motion.col(k) = unscaled;
        largest = std::max(largest, unscaled.lpNorm<Eigen::Infinity>());
      }
      NullVector vector;
      for (const auto& [body, motion] : motions) {
        const Vector6 moves = motion.col(k) / largest;
        if (moves.lpNorm<Eigen::Infinity>() > negligible_motion) vector.emplace_back(body, moves);
      }
      vectors.push_back(std::move(vector));
    }
  }

  // `values` in the pivoted order of the front's columns.
  static void place(const Front& front, const Eigen::MatrixXd& values, Motions& motions) {
    for (const Index body : front.shape.eliminated) motions[body].resize(6, values.cols());
    for (std::size_t k = 0; k < front.factor.order.size(); ++k) {
      const Index column = front.factor.order[k];
      motions[front.shape.eliminated[std::size_t(column / 6)]].row(column % 6) = values.row(Index(k));
    }
  }

  void descend(std::size_t f, Index count, Motions& motions) const {
    const Front& front = fronts_[f];
    const FrontFactor& factor = front.factor;
    Eigen::MatrixXd boundary = Eigen::MatrixXd::Zero(6 * Index(front.boundary.size()), count);
    bool moves = false;
    for (std::size_t j = 0; j < front.boundary.size(); ++j) {
      const auto found = motions.find(front.boundary[j]);
      if (found == motions.end()) continue;
      boundary.middleRows(6 * Index(j), 6) = found->second;
      moves = true;
    }
    if (!moves) return;
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(Index(factor.order.size()), count);
    if (factor.rank > 0)
      values.topRows(factor.rank) =
          -factor.solved.triangularView<Eigen::Upper>().solve(factor.boundary * boundary);
    place(front, values, motions);
    for (const Index child : front.shape.children) descend(std::size_t(child), count, motions);
  }

  const std::vector<ConstraintRow>& rows_;
  std::vector<Vector6> scale_;
  std::vector<Index> place_;  // column block of a body in the front at hand, -1 elsewhere
  std::vector<Front> fronts_;
  std::vector<std::vector<std::size_t>> rows_of_;
};

}  // namespace

std::vector<NullVector> null_space(const std::vector<Vector3>& centres,
                                   const std::vector<ConstraintRow>& rows) {
  if (centres.empty()) return {};
  return NullSpace(centres, rows).find();
}

}  // namespace bondstatic
