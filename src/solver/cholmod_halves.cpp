#include "solver/cholmod_halves.hpp"

#include <algorithm>

#include "bondstatic/types.hpp"

namespace bondstatic {

namespace {

using Panel = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using Rows = Eigen::Map<const Eigen::Matrix<Index, Eigen::Dynamic, 1>>;

/// Some columns of L: the triangle of their own rows, and what is below it, in rows of its own.
struct Supernode {
  Index first;
  Panel triangle;
  Panel below;
  Rows rows;  ///< of `below`
};

Supernode supernode(const cholmod_factor& factor, Index s) {
  const auto at = [s](const void* list) { return static_cast<const Index*>(list) + s; };
  const Index first = at(factor.super)[0], columns = at(factor.super)[1] - first;
  const Index start = at(factor.pi)[0], rows = at(factor.pi)[1] - start;
  const double* values = static_cast<const double*>(factor.x) + at(factor.px)[0];
  return {first, Panel(values, columns, columns, Eigen::OuterStride<>(rows)),
          Panel(values + columns, rows - columns, columns, Eigen::OuterStride<>(rows)),
          Rows(static_cast<const Index*>(factor.s) + start + columns, rows - columns)};
}

// Eigen's products and triangular solves of matrices pack L first, which of a few right-hand sides takes
// longer than the rest. So one right-hand side after another, on tiles of L that stay in the cache for all.
constexpr Index tile_rows = 1024, tile_columns = 32;

template <class Visit>
void for_each_tile(Index rows, Index columns, Visit visit) {
  for (Index j = 0; j < columns; j += tile_columns)
    for (Index i = 0; i < rows; i += tile_rows)
      visit(i, j, std::min(tile_rows, rows - i), std::min(tile_columns, columns - j));
}

/// y -= l x, a column of L after another, as they lie in memory.
template <class L, class X, class Y>
void subtract(const L& l, const X& x, Y&& y) {
  for_each_tile(l.rows(), l.cols(), [&](Index i, Index j, Index rows, Index columns) {
    for (Index c = 0; c < x.cols(); ++c) {
      double* to = &y(i, c);
      Index k = j;
      for (; k + 4 <= j + columns; k += 4) {
        const double *l0 = l.data() + i + k * l.outerStride(), *l1 = l0 + l.outerStride(),
                     *l2 = l1 + l.outerStride(), *l3 = l2 + l.outerStride();
        const double x0 = x(k, c), x1 = x(k + 1, c), x2 = x(k + 2, c), x3 = x(k + 3, c);
#pragma omp simd
        for (Index r = 0; r < rows; ++r) to[r] -= (l0[r] * x0 + l1[r] * x1) + (l2[r] * x2 + l3[r] * x3);
      }
      for (; k < j + columns; ++k) y.col(c).segment(i, rows) -= x(k, c) * l.col(k).segment(i, rows);
    }
  });
}

/// y -= l^T x
template <class L, class X, class Y>
void subtract_transposed(const L& l, const X& x, Y&& y) {
  for_each_tile(l.rows(), l.cols(), [&](Index i, Index j, Index rows, Index columns) {
    for (Index c = 0; c < x.cols(); ++c)
      y.col(c).segment(j, columns).noalias() -=
          l.block(i, j, rows, columns).transpose() * x.col(c).segment(i, rows);
  });
}

}  // namespace

void solve_lower(const cholmod_factor& factor, Eigen::MatrixXd& x) {
  Eigen::MatrixXd update;
  for (Index s = 0; s < Index(factor.nsuper); ++s) {
    const Supernode node = supernode(factor, s);
    const Index size = node.triangle.cols();
    auto own = x.middleRows(node.first, size);
    if (own.isZero(0)) continue;
    for (Index j = 0; j < size; j += tile_columns) {
      const Index columns = std::min(tile_columns, size - j), rest = size - j - columns;
      for (Index c = 0; c < x.cols(); ++c) {
        auto part = own.col(c).segment(j, columns);
        node.triangle.block(j, j, columns, columns).triangularView<Eigen::Lower>().solveInPlace(part);
      }
      subtract(node.triangle.block(j + columns, j, rest, columns), own.middleRows(j, columns),
               own.bottomRows(rest));
    }
    if (node.rows.size() == 0) continue;
    update.setZero(node.rows.size(), x.cols());
    subtract(node.below, own, update);
    for (Index c = 0; c < x.cols(); ++c)
      for (Index r = 0; r < update.rows(); ++r) x(node.rows[r], c) += update(r, c);
  }
}

void solve_upper(const cholmod_factor& factor, Eigen::MatrixXd& x) {
  Eigen::MatrixXd above;
  for (Index s = Index(factor.nsuper) - 1; s >= 0; --s) {
    const Supernode node = supernode(factor, s);
    const Index size = node.triangle.cols();
    auto own = x.middleRows(node.first, size);
    if (node.rows.size() > 0) {
      above = x(node.rows, Eigen::all);
      subtract_transposed(node.below, above, own);
    }
    for (Index j = (size - 1) / tile_columns * tile_columns; j >= 0; j -= tile_columns) {
      const Index columns = std::min(tile_columns, size - j), rest = size - j - columns;
      subtract_transposed(node.triangle.block(j + columns, j, rest, columns), own.bottomRows(rest),
                          own.middleRows(j, columns));
      for (Index c = 0; c < x.cols(); ++c) {
        auto part = own.col(c).segment(j, columns);
        node.triangle.block(j, j, columns, columns)
            .transpose()
            .triangularView<Eigen::Upper>()
            .solveInPlace(part);
      }
    }
  }
}

}  // namespace bondstatic
