#include "mechanism/free_motions.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>

#include "mechanism/null_space.hpp"

namespace bondstatic {

Eigen::MatrixXd free_motions(Eigen::MatrixXd rows) {
  const Index given = rows.rows();
  if (given < 6) {
    rows.conservativeResize(6, 6);
    rows.bottomRows(6 - given).setZero();
  }
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(rows);
  const Eigen::MatrixXd triangle = qr.matrixQR().topRows(6).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(triangle, Eigen::ComputeFullV);
  const double tolerance = free_strain * std::max(1.0, svd.singularValues()[0]);
  Index rank = 0;
  while (rank < 6 && svd.singularValues()[rank] > tolerance) ++rank;
  return svd.matrixV().rightCols(6 - rank);
}

void hold(std::vector<Constraint>& constraints, Index number, const RigidBody& body,
          const Eigen::MatrixXd& motions) {
  const Eigen::MatrixXd basis = Eigen::HouseholderQR<Eigen::MatrixXd>(motions).householderQ() *
                                Eigen::MatrixXd::Identity(6, motions.cols());
  for (Index k = 0; k < basis.cols(); ++k) {
    Constraint row{.a = ground, .b = number, .at_a = body.centre, .at_b = body.centre};
    row.force = basis.col(k).head<3>();
    row.moment = body.size * basis.col(k).tail<3>();
    constraints.push_back(row);
  }
}

}  // namespace bondstatic
