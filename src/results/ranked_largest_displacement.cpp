#include "io/message.hpp"
#include "results/largest_place.hpp"
#include "results/ranked_outputs.hpp"

namespace bondstatic {

namespace {

/// The particle of a rank that moves most in one load case.
struct Candidate {
  double magnitude = -1;  ///< -1: all are left out
  Index place = 0;        ///< in the whole model
  Index id = 0;
  Vector3 displacement = Vector3::Zero();

  bool before(const Candidate& other) const {
    return magnitude > other.magnitude || (magnitude == other.magnitude && place < other.place);
  }
};

void describe(Archive& archive, Candidate& c) {
  archive(c.magnitude, c.place, c.id, c.displacement);
}

Candidate candidate_of(const Piece& piece, const State& state) {
  const LargestPlace largest = largest_place(state, piece.own);
  if (largest.particle < 0) return {};
  const auto p = std::size_t(largest.particle);
  return {largest.magnitude, piece.particle[p], piece.model.particles[p].id, state.displacement[p].head<3>()};
}

}  // namespace

std::vector<LargestDisplacement> largest_displacements_on_ranks(const Piece& piece,
                                                                const StaticSolution& solution,
                                                                Ranks& ranks) {
  std::vector<Candidate> mine;
  for (const State& state : solution.cases) mine.push_back(candidate_of(piece, state));
  std::vector<Candidate> best(mine.size());
  const std::vector<std::string> all = ranks.gather(packed(mine));
  for (const std::string& bytes : all) {
    const auto of_rank = unpacked<std::vector<Candidate>>(bytes);
    for (std::size_t c = 0; c < best.size(); ++c)
      if (of_rank[c].before(best[c])) best[c] = of_rank[c];
  }
  std::vector<LargestDisplacement> largest;
  if (all.empty()) return largest;
  for (const Candidate& one : best)
    largest.push_back(one.magnitude < 0 ? LargestDisplacement{}
                                        : LargestDisplacement{one.id, one.displacement});
  return largest;
}

}  // namespace bondstatic
