// Bond models of other DEM codes as values: what a code stores of a bond, how its numbers become stiffness at
// a contact point, and back. `bondstatic laws --codes` and `translate`, and the tests, all read these
// objects.
//
// What is said of a code was looked up where `source` names; what could not be found there says so.
#pragma once

#include "bondstatic/bond_law.hpp"

namespace bondstatic {

/// One number that the code stores of a bond.
struct CodeParameter {
  std::string name;  ///< as in that code, and as a column of a translation's bonds.csv
  Dimension dimension;
  std::string meaning;
  std::string input;   ///< where a user of that code gives it
  bool truth = false;  ///< yes or no there, 1 or 0 here
};

struct BondCode {
  std::string name;     ///< "lammps-bpm-rotational"
  std::string title;    ///< "LAMMPS, bond_style bpm/rotational"
  std::string version;  ///< looked at
  std::vector<CodeParameter> stored;
  std::vector<std::string> formulas;  ///< from the stored numbers to kn, ks, kt, kb

  ContactPoint contact_point;
  std::string contact_point_text;
  std::string known_from;  ///< how sure that is

  std::string shear;                 ///< rule of the shear displacement
  std::string moments;               ///< what becomes of them
  std::string here;                  ///< what to write in a case file
  std::string fit;                   ///< the rule of `stored_for` where not all can be had
  std::vector<std::string> remarks;  ///< what else changes an answer
  std::string source;

  /// C of a bond of this site with these numbers, in the order of `stored`; fraction is the code's own.
  std::function<BondProperties(const BondSite&, std::span<const double>)> realised;

  /// The numbers to give this code for a bond that carries `wanted`, whose coupling is zero. `realised` turns
  /// them into `wanted` to rounding where the code can do it.
  std::function<std::vector<double>(const BondSite&, const BondProperties&)> stored_for;

  /// How far the code's own element is from `realised` at this site, as `departure_text` says; null where
  /// they are the same at every site.
  std::function<double(const BondSite&)> departure = nullptr;
  std::string departure_text = {};
};

/// All codes of this build, in the order of the listing.
const std::vector<BondCode>& bond_codes();

/// Null where there is no code of that name.
const BondCode* find_bond_code(const std::string& name);

}  // namespace bondstatic
