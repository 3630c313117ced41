// Strength criteria as values: what a criterion is called, which strengths it takes, where it comes from, and
// the ways in which a bond of it can fail. The case reader, the listing, the error messages and the tests all
// read these objects. A new criterion is one new file in src/bond/strength and one line in its catalogue.
//
// Every criterion of the field is a set of failure modes, each a sum of magnitudes
//
//     utilisation = normal N + shear |S| + twisting |T| + bending |M|
//
// of the normal force N (tension positive), shear force S, twisting moment T and bending moment M of a
// section; the bond breaks where the largest utilisation of its modes reaches 1. Such a sum is convex along
// any straight line of resultants and scales with them, so the load factor of a break has one exact value.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "bondstatic/bond.hpp"
#include "bondstatic/bond_law.hpp"
#include "bondstatic/model.hpp"

namespace bondstatic {

/// Coefficients of one sum, 1/force and 1/moment; `normal` alone may be negative (compression).
struct FailureMode {
  int name = 0;  ///< position in StrengthCriterion::modes
  double normal = 0;
  double shear = 0;
  double twisting = 0;
  double bending = 0;
  /// Where M is taken, as a part of the branch from particle a: M there is that at the contact point and the
  /// shear force's on the lever arm between.
  double at = 0.5;
};

/// What a criterion may know of a bond.
struct BondSection {
  double radius = not_given;  ///< NaN: a point bond
  double length = 0;          ///< of the branch
  double fraction = 0.5;      ///< contact point
};

struct StrengthCriterion {
  std::string name;                   ///< key of the case file: "edem-v2"
  std::string title;                  ///< name in the literature
  std::string source;                 ///< "EDEM Bonding V2, strength", "Brown et al. 2014, Eq. ..."
  std::vector<std::string> formulas;  ///< as printed by the listing
  std::vector<Parameter> parameters;  ///< strengths, and the numbers beside them (friction_angle)
  std::vector<bool> scatters;         ///< of each parameter: it is a strength, which may scatter
  std::vector<std::string> modes;     ///< "tension", "shear", "compression", "bending", ...
  bool needs_section = true;          ///< speaks of stresses: not for point bonds
  std::string remark;                 ///< what a user must know

  /// Appends the ways in which the bond can fail; parameters in the order of `parameters`, all there (an
  /// optional one that was not given is infinite: that way is not left out, its utilisation is zero).
  std::function<void(const BondSection&, std::span<const double>, std::vector<FailureMode>&)> failure_modes;

  /// Position of a parameter in `parameters`, or -1.
  Index find(const std::string& parameter) const;
};

/// All criteria of this build, in the order of the listing.
const std::vector<StrengthCriterion>& strength_criteria();

/// Null where there is no criterion of that name.
const StrengthCriterion* find_strength_criterion(const std::string& name);

/// Fill in defaults, and infinity for optional strengths; parameters in the order of the criterion. Appends
/// to `complaints` what is out of bounds or missing, each as "tensile_strength = -5: must be positive".
std::vector<double> complete_strengths(const StrengthCriterion& criterion, std::vector<double> given,
                                       std::vector<std::string>& complaints);

/// N, S, T and M of one bond at its contact point, in axes of its own: e_x along the branch, two others
/// across, the same for all resultants of the bond.
struct SectionVector {
  double normal = 0;
  double twisting = 0;
  Eigen::Vector2d shear = Eigen::Vector2d::Zero();
  Eigen::Vector2d bending = Eigen::Vector2d::Zero();
};

/// Of q = C delta, on particle a (bond.hpp).
SectionVector section_vector(const Vector3& branch, const Vector6& q);

struct Utilisation {
  double value = 0;  ///< of the worst mode; never negative
  int mode = -1;     ///< its name; -1 where the bond has no strength, or feels nothing
};

/// `length` and `fraction`: of the bond.
Utilisation utilisation(std::span<const FailureMode> modes, double length, double fraction,
                        const SectionVector& carried);

struct Crossing {
  double factor = std::numeric_limits<double>::infinity();  ///< infinite where it never breaks
  int mode = -1;
};

/// The smallest factor not below `from` at which held + factor * scaled reaches utilisation 1, to rounding.
/// Where it is above 1 at `from` already: `from`.
Crossing first_crossing(std::span<const FailureMode> modes, double length, double fraction,
                        const SectionVector& held, const SectionVector& scaled, double from);

/// The failure modes of all bonds of a model, in its order; of a bond without strength, none.
struct BondFailures {
  std::vector<Index> first;  ///< of each bond's modes; size bonds + 1
  std::vector<FailureMode> modes;
  std::vector<std::vector<double>> strengths;  ///< of each bond, drawn, in the order of its criterion

  std::span<const FailureMode> of(Index bond) const {
    return std::span(modes).subspan(std::size_t(first[std::size_t(bond)]),
                                    std::size_t(first[std::size_t(bond) + 1] - first[std::size_t(bond)]));
  }
};

/// Draws strengths (BondStrength) and asks the criteria. Throws InputError (place: none) that names bond and
/// particle ids where a bond's strengths are out of bounds, or a point bond is asked for stresses.
BondFailures bond_failures(const Model& model, std::span<const BondProperties> properties);

}  // namespace bondstatic
