// The rows of a bond file, whatever it is: what the block [[bonds]] that names it makes bonds of.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bondstatic/bond_law.hpp"
#include "case/draft.hpp"
#include "case/parameter_list.hpp"
#include "case/row_places.hpp"

namespace bondstatic {

/// A bond is given by these alone, as law "generic" takes them.
inline const std::array<std::string, 4> stiffness_names{"kn", "ks", "kt", "kb"};

struct BondRows {
  std::vector<Index> a, b;  ///< model positions
  std::vector<Index> ids;   ///< empty where there is no such column
  RowPlaces places;
  std::map<std::size_t, std::vector<double>> overrides;  ///< as in BondBlock
  std::vector<double> fractions;                         ///< as in BondBlock
  std::map<std::size_t, std::vector<double>> strengths;  ///< overrides of BondStrength
};

/// What a block gives of the strengths of its bonds; parameters are NaN where it gives nothing.
struct GivenStrengths {
  const StrengthCriterion* criterion = nullptr;
  BondStrength made;
};

/// Where what a parameter's column says of a row stands; the row itself where it has no such column.
using PlaceOf = std::function<Place(Index row, Index parameter)>;

/// Faults, at most twenty rows of a kind, where a row does not complete what the block gives (`given`) to a
/// sound whole, where a contact point lies outside of its branch, and where a bond joins a particle to
/// itself. `strengths` may be null.
void check_bond_parameters(Draft& draft, const BondLaw& law, const std::vector<double>& given,
                           const BondRows& rows, const PlaceOf& place_of);
void check_bond_strengths(Draft& draft, const GivenStrengths* strengths, const BondRows& rows,
                          const PlaceOf& place_of);
void check_fractions(Draft& draft, const BondRows& rows, const std::function<Place(Index row)>& place_of);
void check_ends(Draft& draft, const BondRows& rows);

}  // namespace bondstatic
