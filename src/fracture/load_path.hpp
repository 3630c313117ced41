// The load P and the displacement d of a pattern that scales: see bondstatic/fracture.hpp.
#pragma once

#include <vector>

#include "model/boundary.hpp"
#include "system/extended.hpp"
#include "system/natural_form.hpp"

namespace bondstatic {

/// A quantity of the state that is held + factor * scaled.
struct Affine {
  double held = 0;
  double scaled = 0;
  double at(double factor) const { return held + factor * scaled; }
};

class LoadPath {
 public:
  /// Throws Error (invalid_input) where the pattern scales nothing, or both forces and motions.
  LoadPath(const BondNetwork& network, const Boundary& held, const Boundary& scaled);

  /// Of the motions of both parts.
  Affine load(const Incidence& incidence, const BodyVectors<Extended>& held,
              const BodyVectors<Extended>& scaled) const;
  Affine displacement(const BodyVectors<Extended>& held, const BodyVectors<Extended>& scaled) const;

  /// Work of the loads that stay, from motion zero.
  Affine held_work(const BodyVectors<Extended>& held, const BodyVectors<Extended>& scaled) const;

  /// Particles that the pattern loads or moves, by position.
  const std::vector<Index>& particles() const { return particles_; }
  bool of_forces() const { return kind_ == Kind::forces; }

 private:
  enum class Kind { forces, motions, strain };

  double load_of(const Incidence& incidence, const Boundary& of, const BodyVectors<Extended>& motion) const;

  const BondNetwork& network_;
  const Boundary& held_;
  const Boundary& scaled_;
  Kind kind_ = Kind::forces;
  double reference_ = 0;
  std::vector<Index> particles_;
};

}  // namespace bondstatic
