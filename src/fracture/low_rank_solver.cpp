#include "fracture/low_rank_solver.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace bondstatic {

namespace {

/// Columns g with C = sum g g^T, in global axes; see SectionStiffness.
std::vector<Vector6> factor_of(const SectionStiffness& c, const Vector3& axis) {
  const Vector3 across = axis.unitOrthogonal(), third = axis.cross(across);
  std::vector<Vector6> columns;
  const auto add = [&](double force, const Vector3& along, double moment, const Vector3& about) {
    if (force == 0 && moment == 0) return;
    columns.emplace_back();
    columns.back() << force * along, moment * about;
  };
  add(std::sqrt(c.kn), axis, 0, axis);
  add(0, axis, std::sqrt(c.kt), axis);
  const double shear = std::sqrt(c.ks), coupled = c.ks > 0 ? c.coupling / shear : 0;
  const double bending = std::sqrt(std::max(0.0, c.kb - coupled * coupled));
  add(shear, across, coupled, third);
  add(shear, third, -coupled, across);
  add(0, across, bending, across);
  add(0, third, bending, third);
  return columns;
}

}  // namespace

AnalysisReport LowRankSolver::analyse(const BondNetwork& network, const FreeDofs& dofs) {
  return whole_->analyse(network, dofs);
}

FactorReport LowRankSolver::factorise(const BondNetwork& network, const FreeDofs& dofs) {
  factored_ = dofs_ = dofs;
  length_ = network.rotation_length;
  blocks_.clear();
  sign_.resize(0);
  return whole_->factorise(network, dofs);
}

LowRankSolver::Columns LowRankSolver::columns_of(const std::vector<Link>& links) const {
  Columns columns;
  for (std::size_t k = 0; k < links.size(); ++k)
    for (const Vector6& g : factor_of(links[k].stiffness, bond_axis<double>(links[k]))) {
      Column column;
      const auto add = [&](Index body, const Vector6& force) {
        Index unknown = factored_.first[std::size_t(body)];
        for (int i = 0; i < 6; ++i)
          if (factored_.is_free(body, i)) column.push_back({unknown++, -force[i] / (i < 3 ? 1 : length_)});
      };
      add(links[k].a, force_on_a<double>(links[k], g));
      add(links[k].b, force_on_b<double>(links[k], g));
      if (column.empty()) continue;
      columns.of_w.push_back(std::move(column));
      columns.parts.emplace_back(k, g);
    }
  return columns;
}

Eigen::MatrixXd LowRankSolver::against_blocks(const Eigen::MatrixXd& y) const {
  Eigen::MatrixXd product(rank(), y.cols());
  for (const Block& block : blocks_)
    product.middleRows(block.first, block.values.cols()).noalias() =
        block.values.transpose() * y(block.rows, Eigen::all);
  return product;
}

double LowRankSolver::append(const std::vector<Column>& columns, double sign, double least) {
  const Index old = rank(), added = Index(columns.size());
  if (added == 0) return 1;
  Eigen::MatrixXd y = Eigen::MatrixXd::Zero(factored_.unknowns(), added);
  for (Index j = 0; j < added; ++j)
    for (const auto& [unknown, value] : columns[std::size_t(j)]) y(unknown, j) += value;
  y = whole_->forward(y);

  Block block{{}, {}, old};
  for (Index row = 0; row < y.rows(); ++row)
    if (!y.row(row).isZero(0)) block.rows.push_back(row);
  block.values = y(block.rows, Eigen::all);

  // One more block row of S + Y^T Y = T S T^T.
  Eigen::MatrixXd across = against_blocks(y);
  if (old > 0) lower_.topLeftCorner(old, old).triangularView<Eigen::Lower>().solveInPlace(across);
  Eigen::MatrixXd corner = block.values.transpose() * block.values;
  corner.diagonal().array() += sign;
  corner -= across.transpose() * sign_.asDiagonal() * across;
  const Eigen::LLT<Eigen::MatrixXd> factor(sign * corner);
  if (factor.info() != Eigen::Success) return 0;
  const Eigen::MatrixXd root = factor.matrixL();
  const double left = root.diagonal().array().square().minCoeff();
  if (!(left >= least)) return left;

  if (lower_.rows() < old + added) lower_.conservativeResize(2 * (old + added), 2 * (old + added));
  lower_.block(old, 0, added, old) = across.transpose() * sign_.asDiagonal();
  lower_.block(old, old, added, added) = root;
  sign_.conservativeResize(old + added);
  sign_.tail(added).setConstant(sign);
  blocks_.push_back(std::move(block));
  return left;
}

void LowRankSolver::pin(Index body, double stiffness) {
  const double root = std::sqrt(stiffness);
  std::vector<Column> columns;
  for (Index unknown = factored_.first[std::size_t(body)]; unknown < factored_.first[std::size_t(body) + 1];
       ++unknown)
    columns.push_back({{unknown, root}});
  append(columns, 1, 0);
}

double LowRankSolver::take_out(const std::vector<Link>& links, double least) {
  Columns columns = columns_of(links);
  last_parts_ = std::move(columns.parts);
  return append(columns.of_w, -1, least);
}

// L^-T (I - Y (S + Y^T Y)^-1 Y^T) y
Eigen::MatrixXd LowRankSolver::corrected(Eigen::MatrixXd y) {
  if (rank() > 0) {
    const auto lower = lower_.topLeftCorner(rank(), rank()).triangularView<Eigen::Lower>();
    Eigen::MatrixXd weights = against_blocks(y);
    lower.solveInPlace(weights);
    weights = sign_.asDiagonal() * weights;
    lower.transpose().solveInPlace(weights);
    for (const Block& block : blocks_)
      y(block.rows, Eigen::all) -= block.values * weights.middleRows(block.first, block.values.cols());
  }
  return whole_->backward(std::move(y));
}

// A body's unknowns are all there or none.
Eigen::MatrixXd LowRankSolver::expanded(const Eigen::MatrixXd& kept) const {
  if (dofs_.unknowns() == factored_.unknowns()) return kept;
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(factored_.unknowns(), kept.cols());
  for (std::size_t p = 0; p < dofs_.free.size(); ++p)
    if (const Index count = dofs_.first[p + 1] - dofs_.first[p]; count > 0)
      all.middleRows(factored_.first[p], count) = kept.middleRows(dofs_.first[p], count);
  return all;
}

Eigen::MatrixXd LowRankSolver::kept_rows(Eigen::MatrixXd all) const {
  if (dofs_.unknowns() == factored_.unknowns()) return all;
  Eigen::MatrixXd kept(dofs_.unknowns(), all.cols());
  for (std::size_t p = 0; p < dofs_.free.size(); ++p)
    if (const Index count = dofs_.first[p + 1] - dofs_.first[p]; count > 0)
      kept.middleRows(dofs_.first[p], count) = all.middleRows(factored_.first[p], count);
  return kept;
}

Eigen::MatrixXd LowRankSolver::solve(const Eigen::MatrixXd& right_hand_sides) {
  return kept_rows(corrected(whole_->forward(expanded(right_hand_sides))));
}

Eigen::MatrixXd LowRankSolver::let_go(const std::vector<std::vector<Vector6>>& deltas) {
  Eigen::MatrixXd y = Eigen::MatrixXd::Zero(factored_.unknowns(), Index(deltas.size()));
  if (last_parts_.empty()) return kept_rows(std::move(y));
  Eigen::MatrixXd strain(Index(last_parts_.size()), y.cols());
  for (Index part = 0; part < strain.rows(); ++part)
    for (Index i = 0; i < strain.cols(); ++i) {
      const auto& [link, g] = last_parts_[std::size_t(part)];
      strain(part, i) = g.dot(deltas[std::size_t(i)][link]);
    }
  const Block& last = blocks_.back();
  y(last.rows, Eigen::all) = last.values * strain;
  return kept_rows(corrected(std::move(y)));
}

}  // namespace bondstatic
