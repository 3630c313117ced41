#include "results/inquiry.hpp"

#include <algorithm>
#include <span>

#include "results/quantities.hpp"

namespace bondstatic {

void describe(Archive& archive, SpecimenParticle& p) {
  archive(p.position, p.displacement, p.reaction);
}

void describe(Archive& archive, Question& q) {
  archive(q.last, q.made_of, q.of, q.axis, q.load_case, q.places);
}

void describe(Archive& archive, Reply& r) {
  archive(r.places, r.values, r.specimen, r.box.low, r.box.high);
}

namespace {

/// Calls found(position in the piece, position in the whole) for all of `mine`, which ascend, in `places`.
template <class Found>
void each_in(const std::vector<std::array<Index, 2>>& places, std::span<const Index> mine, Found found) {
  for (const auto& [begin, end] : places)
    for (auto at = std::lower_bound(mine.begin(), mine.end(), begin); at != mine.end() && *at < end; ++at)
      found(Index(at - mine.begin()), *at);
}

}  // namespace

Reply reply_to(const Question& question, const Piece& piece, const StaticSolution& solution) {
  const State& state = solution.cases[question.load_case];
  const std::span own(piece.particle.data(), std::size_t(piece.own));
  Reply found;
  if (question.made_of == MadeOf::particles) {
    const ParticleQuantity& quantity = *find_particle_quantity(question.of);
    each_in(question.places, own, [&](Index here, Index place) {
      found.places.push_back(place);
      found.values.push_back(value_at(quantity, piece.model, state, here));
    });
  } else if (question.made_of == MadeOf::bonds) {
    const BondQuantity& quantity = *find_bond_quantity(question.of);
    each_in(question.places, std::span(piece.bond), [&](Index here, Index place) {
      if (!piece.owns(piece.model.bonds[std::size_t(here)])) return;
      found.places.push_back(place);
      found.values.push_back(quantity.of(state.bonds[std::size_t(here)]));
    });
  } else {
    each_in(question.places, own, [&](Index here, Index place) {
      found.places.push_back(place);
      found.specimen.push_back(specimen_particle(piece.model, state, here));
    });
    if (question.made_of == MadeOf::apparent_young)
      found.box = lateral_box(piece.model, state, piece.own, question.axis);
  }
  return found;
}

}  // namespace bondstatic
