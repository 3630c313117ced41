// Static answer and explicit run of the same model side by side: the certificate that they are the same
// state.
//
// With small kinematics the run's limit is the linear static answer. With finite kinematics it differs at
// second order in the load; runs at one half (and, where higher orders are felt, one quarter and one eighth)
// of the load tell the orders apart:
//
//     run(s) - s static = s d1 + s^2 d2 + s^3 d3 + s^4 d4,      s = 1, 1/2, 1/4, 1/8,
//
// and only d1, which should not be there, is held against the tolerance.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "bondstatic/relaxation.hpp"
#include "bondstatic/statics.hpp"

namespace bondstatic {

/// Where a difference is largest.
struct Worst {
  bool of_bond = false;
  Index at = -1;  ///< model position of the particle or bond; -1 for the energy
};

/// One field of the answer. Differences are relative: the largest over the largest magnitude of the static
/// field (or, where that field vanishes, a thousandth of what its kind could be), norms over norms likewise.
struct FieldDifference {
  std::string
      field;  ///< displacement, rotation, reaction force, reaction moment, bond force, bond moment, energy
  double largest = 0;
  double norm = 0;
  Worst worst;
  double first_order = 0;           ///< largest of d1; equals `largest` where kinematics are small
  double second_order = not_given;  ///< largest of d2; NaN where kinematics are small
  double third_order = not_given;   ///< largest of d3; NaN where two runs told enough
};

struct CaseCertificate {
  std::string name;
  std::vector<FieldDifference> fields;
  RelaxedCase run;  ///< under the full load
  Accuracy statics;
  bool at_rest = false;  ///< every run that this rests on
  bool agrees = false;   ///< at rest, and every first_order within the tolerance
};

struct Certificate {
  Kinematics kinematics = Kinematics::finite;
  double tolerance = 0;
  std::vector<CaseCertificate> cases;
  StaticReport statics;
  double static_seconds = 0;   ///< all load cases
  double dynamic_seconds = 0;  ///< all load cases under the full load
  std::vector<std::string> warnings;

  bool agrees() const;
};

/// What check is doing: "static", "run", "run at 1/2 of the load", ... and how far that is (null for a
/// solve). False stops; the certificate then ends where it is, without agreement.
using CheckProgress = std::function<bool(const std::string& part, const RelaxProgress* run)>;

/// Throws what solve_statics and relax throw.
Certificate check(const Model& model, const StaticOptions& solve, const RelaxOptions& options,
                  const CheckProgress& progress = {});

}  // namespace bondstatic
