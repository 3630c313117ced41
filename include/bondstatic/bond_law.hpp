// Bond laws as values: what a law is called, which parameters it takes, where it comes from, and the function
// from a bond's geometry and parameters to C. The case reader, `bondstatic laws`, the error messages and the
// tests all read these objects. A new law is one new file in src/bond/laws and one line in its catalogue.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bondstatic/bond.hpp"
#include "bondstatic/model.hpp"
#include "bondstatic/units.hpp"

namespace bondstatic {

/// One input of a law. Allowed are lower < value <= upper, or lower <= value where `lower_included`.
struct Parameter {
  std::string name;
  Dimension dimension;
  std::string meaning;
  double lower = 0;
  bool lower_included = false;
  double upper = std::numeric_limits<double>::infinity();
  double default_value = not_given;  ///< NaN: no default
  bool optional = false;  ///< may stay NaN although it has no default (one of several ways to say it)
  bool whole = false;     ///< a whole number (seed)
  bool truth = false;     ///< true or false in the case file, 1 or 0 here
};

/// Ways to give the same thing, e.g. {{"poisson"}, {"kappa"}}: exactly one group must be given in full, or
/// none where the first group whose members all have defaults stands in.
using Alternatives = std::vector<std::vector<std::string>>;

/// What a law may know of a bond's surroundings.
struct BondSite {
  double length = 0;    ///< L: distance of the particle centres
  double radius_a = 0;  ///< particle radii Ra, Rb
  double radius_b = 0;
  Index id_a = 0;  ///< particle ids: seeds of laws that scatter
  Index id_b = 0;

  double gap() const { return length - radius_a - radius_b; }
};

/// What a law says of one bond.
struct BondProperties {
  SectionStiffness stiffness;    ///< what the bond carries
  double radius = not_given;     ///< of the bond's section, for stresses; NaN: none
  double fraction = 0.5;         ///< contact point
  bool moments_fed_back = true;  ///< false: kt and kb enter stresses only (EDEM's torque feedback off)
};

/// How one bond's properties change with one parameter of its law.
struct BondDerivative {
  SectionStiffness stiffness;  ///< d(kn, ks, kt, kb, coupling)/dp, of what the bond carries
  double radius = 0;           ///< d(radius of the section)/dp; 0 where it has none
};

struct BondLaw {
  std::string name;                   ///< key of the case file: "timoshenko"
  std::string title;                  ///< name in the literature
  std::string source;                 ///< "[Chen2022] Eq. 14-25, Table 6, 9"
  std::vector<std::string> formulas;  ///< as printed by `bondstatic laws`
  std::vector<Parameter> parameters;
  std::vector<Alternatives> alternatives = {};
  ContactPoint contact_point;  ///< the law's own; never Kind::of_law
  std::string remark;          ///< what a user must know: assumptions, derived here, ...

  /// `evaluate` gives C at the law's own contact point: asked for at another one it is transformed, and the
  /// bond stays the same. False: C is taken as it is at whichever contact point is asked for ([Chen2022]
  /// section 4.3).
  bool stiffness_at_own_contact_point = false;

  /// Stiffness, section radius and feedback from the site and the parameters in the order of `parameters`,
  /// NaN where not given, defaults filled in, bounds already checked.
  std::function<BondProperties(const BondSite&, std::span<const double>)> evaluate;

  /// d(what evaluate says)/d(parameter at that position), by the chain rule, exact to rounding. For
  /// parameters that are numbers (neither `whole` nor `truth`) and given (not NaN).
  std::function<BondDerivative(const BondSite&, std::span<const double>, std::size_t parameter)>
      differentiate;

  /// What forbids the law at this site, as finding and cure ("gap = -1e-4 must be positive; use another
  /// law"), empty if nothing does. May be null.
  std::function<std::string(const BondSite&, std::span<const double>)> forbids = nullptr;

  /// What is wrong with the parameters together, whatever the site; complete_parameters says it. May be null.
  std::function<std::string(std::span<const double>)> inconsistent = nullptr;

  /// Position of a parameter in `parameters`, or -1.
  Index find(const std::string& parameter) const;
};

/// All laws of this build, in the order of the listing.
const std::vector<BondLaw>& bond_laws();

/// Null where there is no law of that name.
const BondLaw* find_bond_law(const std::string& name);

/// Fill in defaults; parameters in the order of the law.
/// Appends to `complaints` what is out of bounds, missing, or given twice, each as "young = -5: must be
/// positive".
std::vector<double> complete_parameters(const BondLaw& law, std::vector<double> given,
                                        std::vector<std::string>& complaints);

/// Distance a / L of the contact point from particle a. `choice` of_law means the law's own.
double contact_fraction(ContactPoint choice, const BondLaw& law, const BondSite& site);

BondSite bond_site(const Model& model, const Bond& bond);

/// Properties of every bond of the model, in its order. Throws InputError (place: none) that names bond and
/// particle ids where a law forbids a site or its stiffness is not finite, positive semi-definite.
/// Laws are evaluated by several threads at once; nothing but the time depends on `threads`.
std::vector<BondProperties> bond_properties(const Model& model, int threads = 1);

/// How the bonds of one block change with one parameter of its law, at the contact point that each is asked
/// for.
struct ParameterDerivative {
  std::vector<Index> bonds;  ///< of the block, those to which the parameter is given; positions in the model
  std::vector<BondDerivative> of_bond;  ///< to the bond's own value
  std::vector<bool> has_own;            ///< it has a value of its own, and does not follow the block's
};

/// `parameter`: position in the law's list. Throws InputError (place: none) as bond_properties() does, and
/// Error (invalid_input) for a parameter that is no number to differentiate by (seed, torque_feedback).
ParameterDerivative bond_derivatives(const Model& model, Index block, std::size_t parameter, int threads = 1);

}  // namespace bondstatic
