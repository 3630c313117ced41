// [[bonds]]: one law a block.
//
//   law and its parameters, as `bondstatic laws` lists them; "generic" where a file gives kn, ks, kt and kb
//   gap (0) | contact_radius_factor | file = "bonds.csv": where bonds form. A file has columns a, b (particle
//       ids) and, where wanted, id, any parameter of the law for single bonds, and contact_point, a number as
//       below. Or it is another code's: LAMMPS data, a local dump (bond_columns = ["c_1[1]", "c_1[2]"],
//       step), YADE, MUSEN, PFC; what it gives of the law's parameters, and of strengths, is each bond's own
//   between = "group" | ["a", "b"]: one end in each group
//   contact_point = "gap" | "beam" | "contact-radii" (with contact_radius_factor) | a number in (0, 1): part
//   of the
//       branch from the bond's particle a. Absent: the law's own
//   strength = { .. }: when they break (bond_strength.hpp)
//   existing = "error" | "add" | "skip": what happens to a pair that is bonded already
//
// Bonds from a distance run from the smaller to the larger id; ids without a file's id column go on from the
// largest so far, from 1.
#pragma once

#include <functional>
#include <optional>

#include "case/bond_rows.hpp"
#include "case/draft.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

void read_bonds(Draft& draft, Node* list);

/// Bonds that are listed elsewhere than in a file of the block; rows as bond_rows() gives them.
struct ListedBonds {
  bool gives_stiffness = false;  ///< law "generic" then goes without saying
  std::function<std::optional<BondRows>(const BondLaw& law, const std::vector<double>& given,
                                        const GivenStrengths* strengths)>
      rows;
};

/// One block; `listed` takes the place of its file, and `between` then chooses among the rows. May be null.
void read_bond_block(Draft& draft, TableReader& block, const ListedBonds* listed);

}  // namespace bondstatic
