// The model while a case is read, with the names that other blocks refer to.
#pragma once

#include <map>

#include "bondstatic/model.hpp"
#include "case/reading.hpp"
#include "io/id_table.hpp"

namespace bondstatic {

/// What a block of [[loads]] or [[supports]] does to the model, for what is said of several blocks together.
struct Action {
  enum class Kind { hold, motion, force, strain };  ///< hold: prescribed zeros alone
  Kind kind;
  Index load_case;
  Place place;
};

struct Draft {
  Reading reading;
  Model model;
  IdTable particle_of_id;  ///< position in Model::particles
  IdTable bond_of_id;
  std::map<std::string, std::vector<Index>> groups;  ///< ascending positions of particles
  std::vector<Action> actions;                       ///< in the order of the file; loads of zero are left out

  /// False where a block of particles or bonds is at fault: what refers to them is then read, but not
  /// resolved, so that one fault is not reported a hundred times.
  bool particles_known = true;
  bool bonds_known = true;
};

}  // namespace bondstatic
