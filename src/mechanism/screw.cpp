#include "mechanism/screw.hpp"

#include <Eigen/QR>
#include <cmath>

namespace bondstatic {
namespace {

constexpr double rounding = 1e-7;  // of null vectors, whose constraints hold to 1e-9

}  // namespace

FreeMotion screw(const Vector6& scaled_motion, const Vector3& centre, double size) {
  Vector3 v = scaled_motion.head<3>(), w = scaled_motion.tail<3>();
  FreeMotion motion;
  motion.translates = w.norm() <= rounding * v.norm();
  Vector3& axis = motion.axis;
  axis = (motion.translates ? v : w).normalized();
  for (int i = 0; i < 3; ++i)
    if (std::abs(axis[i]) < rounding) axis[i] = 0;
  axis.normalize();
  // An axis has no sense; let its first component count be positive.
  const int first = axis[0] != 0 ? 0 : axis[1] != 0 ? 1 : 2;
  if (axis[first] < 0) axis = -axis, v = -v, w = -w;
  if (motion.translates) {
    motion.point = centre;
    return motion;
  }
  w /= size;
  motion.point = centre + w.cross(v) / w.squaredNorm();
  motion.pitch = w.dot(v) / w.squaredNorm();
  if (std::abs(motion.pitch) < rounding * size) motion.pitch = 0;
  return motion;
}

std::vector<Vector6> legible_basis(const std::vector<Vector6>& scaled_motions) {
  const Index count = Index(scaled_motions.size());
  Eigen::MatrixXd columns(6, count);
  for (Index k = 0; k < count; ++k) columns.col(k) = scaled_motions[std::size_t(k)].normalized();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  qr.setThreshold(rounding);
  const Index rank = qr.rank();
  Eigen::MatrixXd rows = Eigen::MatrixXd(qr.householderQ()).leftCols(rank).transpose();
  // Gauss-Jordan on rx, ry, rz, x, y, z. Rows are orthonormal, so what is left of a column is zero or it is
  // not.
  Index done = 0;
  for (const int column : {3, 4, 5, 0, 1, 2}) {
    if (done == rank) break;
    Index pivot = 0;
    if (rows.col(column).tail(rank - done).cwiseAbs().maxCoeff(&pivot) < 100 * rounding) continue;
    rows.row(done).swap(rows.row(done + pivot));
    rows.row(done) /= double(rows(done, column));
    for (Index r = 0; r < rank; ++r)
      if (r != done) rows.row(r) -= double(rows(r, column)) * rows.row(done);
    ++done;
  }
  std::vector<Vector6> basis;
  for (Index r = 0; r < rank; ++r) basis.push_back(rows.row(r).transpose());
  return basis;
}

}  // namespace bondstatic
