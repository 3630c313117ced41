// at = { ... }: which particles, or which bonds. Several keys in one selector intersect.
//
//   id = 1 | [1, 2]                      ids
//   group = "top" | [..]                 members of any of the groups
//   box = { min = [..], max = [..] }     either may be left out, components may be inf
//   sphere = { centre = [..], radius }
//   plane = { point = [..], normal = [..] }    the side that the normal points to
//   lowest = { axis = "z", within = "2 mm" }   centres at most that far above the lowest centre; highest
//   likewise all = true
//
// Centres on the boundary are inside, within 1e-9 of the particle's radius. Outputs of bonds are selected
// with bond = 3 | [..], ids of bonds, or all = true.
#pragma once

#include "case/draft.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

/// Ascending model positions of what the selector under `key` of `owner` selects; nothing where it is at
/// fault, selects nothing (a fault too), or refers to blocks that are at fault. The key must be there.
std::optional<std::vector<Index>> select_particles(Draft& draft, TableReader& owner, const std::string& key);
std::optional<std::vector<Index>> select_bonds(Draft& draft, TableReader& owner, const std::string& key);

/// [[groups]]: name and selector; they may use the groups before them.
void read_groups(Draft& draft, Node* list);

/// Members of a named group, ascending; null and a fault where there is none of that name.
const std::vector<Index>* find_group(Draft& draft, const std::string& name, const Place& place);

}  // namespace bondstatic
