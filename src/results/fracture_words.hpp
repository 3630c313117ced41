// How files and reports call what a run of fracture tells.
#pragma once

#include <map>
#include <string>

#include "bondstatic/fracture.hpp"

namespace bondstatic {

/// Load and displacement of a pattern, by its kind (fracture.hpp), and their units in SI.
struct FractureWords {
  std::string load, load_unit;
  std::string displacement, displacement_unit;
};
FractureWords fracture_words(const Model& model, const FractureOptions& asked);

/// "tension"; "" where the bond has no such mode.
std::string mode_name(const Model& model, const BrokenBond& broken);

const char* name_of(FractureControl control);
const char* name_of(FractureEnd end);

/// Numbers of all events together.
Index count_breaks(const Fracture& fracture);
std::map<std::string, Index> breaks_by_mode(const Model& model, const Fracture& fracture);
/// The event at whose beginning the load is largest; null where there is none.
const FractureEvent* peak_of(const Fracture& fracture);
/// The last one with something left to carry afterwards; null where there is none.
const FractureEvent* last_standing(const Fracture& fracture);

}  // namespace bondstatic
