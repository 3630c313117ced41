// What rank 0 asks the others for one output, and what each of them replies of its own particles or bonds.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bondstatic/statics.hpp"
#include "io/archive.hpp"
#include "model/piece.hpp"
#include "results/output_values.hpp"
#include "results/specimen.hpp"

namespace bondstatic {

struct Question {
  bool last = false;  ///< no question, and none after it
  MadeOf made_of{};
  std::string of;
  Vector3 axis = Vector3::Zero();  ///< of the box of a specimen
  std::size_t load_case = 0;
  std::vector<std::array<Index, 2>> places;  ///< positions in the whole model, [begin, end), ascending
};
void describe(Archive& archive, Question& question);

/// One value a place, or one particle of a specimen.
struct Reply {
  std::vector<Index> places;  ///< in the whole model, ascending
  std::vector<double> values;
  std::vector<SpecimenParticle> specimen;
  LateralBox box;  ///< where apparent_young is asked for
};
void describe(Archive& archive, Reply& reply);

Reply reply_to(const Question& question, const Piece& piece, const StaticSolution& solution);

}  // namespace bondstatic
