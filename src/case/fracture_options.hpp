// [fracture]: bonds break one after another.
//
//   pattern = "press"      load case that scales by the factor; absent where there is but one beside the
//   preload preload = "confine"    load case that stays; absent: none control = "event" | "load" |
//   "displacement": what never falls max_breaks, max_factor, max_displacement, load_drop (part of the largest
//   load): where it ends; the first
//       three without limit where they are absent. max_displacement is of d (fracture.hpp): a length, a plain
//       number where the pattern is a strain of the cell, or moments or rotations alone
//   save_every (breaks), tie
#pragma once

#include "case/draft.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

/// After bonds, supports and loads. For Purpose::fracture `table` is there, and the case must have what the
/// run rests on; `bonds` is [[bonds]], null where there is none. A null table: the defaults.
FractureOptions read_fracture_options(Draft& draft, Node* table, const Node* bonds);

}  // namespace bondstatic
