// What a run of fracture needs to go on: the checkpoint of the run itself, and what its hooks have heard
// before.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/results.hpp"

namespace bondstatic {

struct KeptFracture {
  std::string run;        ///< FractureHooks::resume
  FractureRecord record;  ///< a column for each output of the case
};

std::string packed(const KeptFracture& kept, const std::vector<Output>& outputs);

/// Of an empty `content`: that of a run that has not begun. Throws Error (invalid_input) where it is damaged,
/// or of other outputs.
KeptFracture unpacked(const std::string& content, const std::string& shown,
                      const std::vector<Output>& outputs);

}  // namespace bondstatic
