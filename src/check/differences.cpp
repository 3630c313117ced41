#include "check/differences.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace bondstatic {

namespace {

/// A field that is a part of this of what its kind could be counts as vanishing.
constexpr double vanishing = 1e-3;

/// Where a field stands in a state: three numbers a particle or a bond.
struct Field {
  const char* name;
  bool of_bond;
  bool angular;  ///< rotation or moment
  bool force;    ///< force or moment, not motion
  Vector3 (*at)(const State&, std::size_t);
};

const Field fields[] = {
    {"displacement", false, false, false,
     [](const State& s, std::size_t i) -> Vector3 { return s.displacement[i].head<3>(); }},
    {"rotation", false, true, false,
     [](const State& s, std::size_t i) -> Vector3 { return s.displacement[i].tail<3>(); }},
    {"reaction force", false, false, true,
     [](const State& s, std::size_t i) -> Vector3 { return s.reaction[i].head<3>(); }},
    {"reaction moment", false, true, true,
     [](const State& s, std::size_t i) -> Vector3 { return s.reaction[i].tail<3>(); }},
    {"bond force", true, false, true,
     [](const State& s, std::size_t i) -> Vector3 { return s.bonds[i].force.head<3>(); }},
    {"bond moment", true, true, true,
     [](const State& s, std::size_t i) -> Vector3 { return s.bonds[i].force.tail<3>(); }},
};

std::size_t size_of(const Field& field, const State& state) {
  return field.of_bond ? state.bonds.size() : state.displacement.size();
}

double largest_of(const Field& field, const State& state) {
  double largest = 0;
  for (std::size_t i = 0; i < size_of(field, state); ++i) {
    const double size = field.at(state, i).norm();
    if (size > largest) largest = size;  // nor where it is NaN
  }
  return largest;
}

/// What a field is measured by: its own largest magnitude, but not less than a part of its kind's.
double scale_of(const Field& field, const State& statics, double length) {
  double motion = 0, force = 0;
  for (const Field& other : fields) {
    const double size = largest_of(other, statics);
    if (other.force)
      force = std::max(force, other.angular ? size / length : size);
    else
      motion = std::max(motion, other.angular ? size * length : size);
  }
  const double kind =
      field.force ? (field.angular ? force * length : force) : (field.angular ? motion / length : motion);
  return std::max(largest_of(field, statics), vanishing * kind);
}

/// Weights w(k, j) such that part j of sum_k s_k^(j + first) d_j is sum_k w(k, j) difference_k.
Eigen::MatrixXd order_weights(const std::vector<ScaledState>& runs, int first) {
  const auto n = Eigen::Index(runs.size());
  Eigen::MatrixXd powers(n, n);
  for (Eigen::Index k = 0; k < n; ++k)
    for (Eigen::Index j = 0; j < n; ++j)
      powers(k, j) = std::pow(runs[std::size_t(k)].load_factor, double(first + j));
  return powers.inverse().transpose();
}

/// Nothing is larger than NaN: what a run lacks must not look like agreement.
bool larger(double value, double than) {
  return !std::isnan(than) && !(value <= than);
}

/// Beyond the third an order is only there to be taken off.
void put_order(FieldDifference& difference, Eigen::Index order, double value) {
  if (order == 0) difference.first_order = value;
  if (order == 1) difference.second_order = value;
  if (order == 2) difference.third_order = value;
}

FieldDifference difference_of(const Field& field, const State& statics, const std::vector<ScaledState>& runs,
                              double length) {
  const Eigen::MatrixXd weights = order_weights(runs, 1);
  const double scale = scale_of(field, statics, length);
  FieldDifference result;
  result.field = field.name;
  result.worst.of_bond = field.of_bond;
  double squares = 0, of_statics = 0;
  Eigen::VectorXd orders = Eigen::VectorXd::Zero(weights.cols());
  for (std::size_t i = 0; i < size_of(field, statics); ++i) {
    const Vector3 exact = field.at(statics, i);
    if (exact.hasNaN()) continue;  // left out
    Eigen::Matrix3Xd apart(3, runs.size());
    for (std::size_t k = 0; k < runs.size(); ++k)
      apart.col(Eigen::Index(k)) = field.at(*runs[k].state, i) - runs[k].load_factor * exact;
    squares += apart.col(0).squaredNorm();
    of_statics += exact.squaredNorm();
    const double size = scale > 0 ? apart.col(0).norm() / scale : 0;
    if (result.worst.at < 0 || larger(size, result.largest)) {
      result.largest = size;
      result.worst.at = Index(i);
    }
    for (Eigen::Index order = 0; order < weights.cols(); ++order) {
      const double part = scale > 0 ? (apart * weights.col(order)).norm() / scale : 0;
      if (larger(part, orders[order])) orders[order] = part;
    }
  }
  for (Eigen::Index order = 0; order < orders.size(); ++order) put_order(result, order, orders[order]);
  const double against = std::max(std::sqrt(of_statics), scale);
  if (against > 0) result.norm = std::sqrt(squares) / against;
  return result;
}

/// Quadratic in the load to begin with.
FieldDifference energy_difference(const State& statics, const std::vector<ScaledState>& runs) {
  FieldDifference result;
  result.field = "energy";
  Eigen::RowVectorXd apart(runs.size());
  for (std::size_t k = 0; k < runs.size(); ++k)
    apart[Eigen::Index(k)] =
        runs[k].state->energy - runs[k].load_factor * runs[k].load_factor * statics.energy;
  if (!(statics.energy > 0)) return result;
  result.largest = result.norm = std::abs(apart[0]) / statics.energy;
  const Eigen::RowVectorXd parts = apart * order_weights(runs, 2);
  for (Eigen::Index order = 0; order < parts.size(); ++order)
    put_order(result, order, std::abs(parts[order]) / statics.energy);
  return result;
}

}  // namespace

std::vector<FieldDifference> differences(const State& statics, const std::vector<ScaledState>& runs,
                                         double length) {
  std::vector<FieldDifference> all;
  for (const Field& field : fields) all.push_back(difference_of(field, statics, runs, length));
  all.push_back(energy_difference(statics, runs));
  return all;
}

}  // namespace bondstatic
