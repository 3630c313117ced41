// All that acts on the particles from outside, added up: what must balance.
#pragma once

#include "bondstatic/model.hpp"
#include "system/extended.hpp"
#include "system/ranks.hpp"

namespace bondstatic {

class OutsideForces {
 public:
  /// Of particles 0 ... own-1 of the model, on each rank.
  OutsideForces(const Model& model, Index own, Ranks* ranks);

  /// A force and moment on particle p, which moves by `motion`.
  void add(std::size_t p, const Vector6T<Extended>& outside, const Vector6T<Extended>& motion);

  /// To be called by all ranks once all has been added; only then the sums are whole.
  void add_up(Ranks* ranks);

  Extended work() const { return work_; }
  /// |sum| over the sum of the magnitudes; moments about the mean particle centre.
  double force_balance() const;
  double moment_balance() const;
  const Vector3T<Extended>& force() const { return force_; }
  const Extended& forces() const { return forces_; }  ///< sum of the magnitudes
  /// Their sum and that of their magnitudes; in a periodic cell each about its own particle.
  const Vector3T<Extended>& moment() const { return moment_; }
  const Extended& moments() const { return moments_; }

 private:
  const Model& model_;
  Vector3T<Extended> centre_;
  Vector3T<Extended> force_ = Vector3T<Extended>::Zero(), moment_ = Vector3T<Extended>::Zero();
  Extended forces_ = 0.0, moments_ = 0.0, work_ = 0.0;
};

/// part / whole, 0 where there is no whole.
double ratio(const Extended& part, const Extended& whole);

}  // namespace bondstatic
