#include "statics/outside_forces.hpp"

#include <array>

#include "system/together.hpp"

namespace bondstatic {

double ratio(const Extended& part, const Extended& whole) {
  return whole > 0.0 ? to_double(part / whole) : 0.0;
}

OutsideForces::OutsideForces(const Model& model, Index own, Ranks* ranks) : model_(model) {
  std::array<Extended, 4> sums{0.0, 0.0, 0.0, double(own)};
  for (std::size_t p = 0; p < std::size_t(own); ++p)
    for (std::size_t i = 0; i < 3; ++i) sums[i] += model.particles[p].position[Index(i)];
  bondstatic::add_up(ranks, sums);
  const Extended count = sums[3] > 1.0 ? sums[3] : Extended(1.0);
  centre_ << sums[0] / count, sums[1] / count, sums[2] / count;
}

void OutsideForces::add(std::size_t p, const Vector6T<Extended>& outside, const Vector6T<Extended>& motion) {
  for (int i = 0; i < 6; ++i) work_ += outside[i] * motion[i];
  const Vector3T<Extended> f = outside.head<3>(), m = outside.tail<3>();
  Vector3T<Extended> arm = Vector3T<Extended>::Zero();
  if (!model_.cell) arm = model_.particles[p].position.cast<Extended>() - centre_;
  force_ += f;
  moment_ += arm.cross(f) + m;
  forces_ += f.norm();
  moments_ += arm.norm() * f.norm() + m.norm();
}

void OutsideForces::add_up(Ranks* ranks) {
  std::array<Extended, 9> sums{force_[0],  force_[1], force_[2], moment_[0], moment_[1],
                               moment_[2], forces_,   moments_,  work_};
  bondstatic::add_up(ranks, sums);
  force_ << sums[0], sums[1], sums[2];
  moment_ << sums[3], sums[4], sums[5];
  forces_ = sums[6], moments_ = sums[7], work_ = sums[8];
}

double OutsideForces::force_balance() const {
  return ratio(force_.norm(), forces_);
}

double OutsideForces::moment_balance() const {
  return ratio(moment_.norm(), moments_);
}

}  // namespace bondstatic
