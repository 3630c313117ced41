#include "fracture/load_path.hpp"

#include <algorithm>

#include "bondstatic/error.hpp"

namespace bondstatic {

namespace {

bool any(const std::vector<Vector6>& vectors) {
  return std::any_of(vectors.begin(), vectors.end(), [](const Vector6& v) { return !v.isZero(0); });
}

/// Of forces where there are any, else of moments.
template <class Measure>
double measured(const std::vector<Vector6>& vectors, Measure measure) {
  double translational = 0, rotational = 0;
  for (const Vector6& v : vectors) {
    measure(translational, v.head<3>());
    measure(rotational, v.tail<3>());
  }
  return translational > 0 ? translational : rotational;
}

Extended product(const std::vector<Vector6>& forces, const BodyVectors<Extended>& motion) {
  Extended sum = 0.0;
  for (std::size_t p = 0; p < forces.size(); ++p)
    if (!forces[p].isZero(0)) sum += forces[p].cast<Extended>().eval().dot(motion[p]);
  return sum;
}

}  // namespace

LoadPath::LoadPath(const BondNetwork& network, const Boundary& held, const Boundary& scaled)
    : network_(network), held_(held), scaled_(scaled) {
  const bool forces = any(scaled.load), motions = any(scaled.prescribed), strain = !scaled.strain.isZero(0);
  if (forces + motions + strain == 0)
    throw Error(ExitCode::invalid_input,
                "the pattern that scales has no load, prescribed motion or strain\n    cure: give the load "
                "case loads, or name another one ([fracture] pattern)");
  if (forces + motions + strain > 1)
    throw Error(ExitCode::invalid_input,
                "the pattern scales more than one of loads, prescribed motions and strain, so that load and "
                "displacement would mean nothing\n    cure: put what stays into a load case of its own "
                "([fracture] preload)");
  kind_ = forces ? Kind::forces : motions ? Kind::motions : Kind::strain;
  if (forces) reference_ = measured(scaled.load, [](double& sum, const Vector3& v) { sum += v.norm(); });
  if (motions)
    reference_ =
        measured(scaled.prescribed, [](double& most, const Vector3& v) { most = std::max(most, v.norm()); });
  if (strain) reference_ = scaled.strain.cwiseAbs().maxCoeff();
  const auto& vectors = forces ? scaled.load : scaled.prescribed;
  for (std::size_t p = 0; p < vectors.size(); ++p)
    if (!vectors[p].isZero(0)) particles_.push_back(Index(p));
}

double LoadPath::load_of(const Incidence& incidence, const Boundary& of,
                         const BodyVectors<Extended>& motion) const {
  Extended sum = 0.0;
  if (kind_ == Kind::motions) {
    for (const Index p : particles_) {
      const auto i = std::size_t(p);
      const Vector6T<Extended> reaction =
          force_on_body<Extended>(network_, incidence, motion, p, of.strain) - of.load[i].cast<Extended>();
      sum += reaction.dot(scaled_.prescribed[i].cast<Extended>());
    }
  } else {
    for (const Link& link : network_.links) {
      const auto q = resultants<Extended>(link.stiffness, bond_axis<Extended>(link),
                                          link_motion<Extended>(link, motion, of.strain));
      const Vector3 apart = scaled_.strain * link.branch;
      for (int i = 0; i < 3; ++i) sum += q[i] * apart[i];
    }
  }
  return to_double(sum / reference_);
}

Affine LoadPath::load(const Incidence& incidence, const BodyVectors<Extended>& held,
                      const BodyVectors<Extended>& scaled) const {
  if (kind_ == Kind::forces) return {0, reference_};
  return {load_of(incidence, held_, held), load_of(incidence, scaled_, scaled)};
}

Affine LoadPath::displacement(const BodyVectors<Extended>& held, const BodyVectors<Extended>& scaled) const {
  if (kind_ != Kind::forces) return {0, reference_};
  return {to_double(product(scaled_.load, held) / reference_),
          to_double(product(scaled_.load, scaled) / reference_)};
}

Affine LoadPath::held_work(const BodyVectors<Extended>& held, const BodyVectors<Extended>& scaled) const {
  return {to_double(product(held_.load, held)), to_double(product(held_.load, scaled))};
}

}  // namespace bondstatic
