#include "statics/held_on_ranks.hpp"

#include <algorithm>
#include <exception>

#include "bondstatic/mechanism.hpp"
#include "io/message.hpp"
#include "mechanism/condensed.hpp"

namespace bondstatic {

namespace {

// What rank 0 finds out from the condensed pieces of all.
struct Verdict {
  bool sound = false;
  std::vector<std::vector<Index>> unsupported;  // bodies to be left out, by number in the whole model
};

void describe(Archive& archive, Verdict& verdict) {
  archive(verdict.sound, verdict.unsupported);
}

Verdict judge(const std::vector<std::string>& pieces, Unsupported unsupported) {
  std::vector<Condensed> condensed;
  for (const std::string& bytes : pieces) condensed.push_back(unpacked<Condensed>(bytes));
  const Assembled all = assemble_condensed(condensed);
  Verdict verdict;
  std::vector<bool> left_out(all.number.size(), false);
  if (unsupported == Unsupported::drop)
    for (const auto& body : unsupported_bodies(all.network, all.dofs)) {
      verdict.unsupported.emplace_back();
      for (const Index p : body) {
        left_out[std::size_t(p)] = true;
        verdict.unsupported.back().push_back(all.number[std::size_t(p)]);
      }
    }
  const bool some_left = std::find(left_out.begin(), left_out.end(), false) != left_out.end();
  verdict.sound = some_left && find_mechanisms(all.model, all.network, all.dofs, left_out).empty();
  return verdict;
}

// Throws where the whole model has a mechanism. `load_case`: whose supports count.
void judge_whole(const Model& whole, Index load_case, Unsupported unsupported) {
  const BondNetwork network = bond_network(whole, bond_properties(whole));
  held_by(whole, network, boundary_of(whole, load_case).free, unsupported);
}

// Ids of what is left out, body by body, at rank 0.
std::vector<std::vector<Index>> dropped_ids(const Piece& piece, const std::vector<Index>& body_of,
                                            std::size_t bodies, Ranks& ranks) {
  std::vector<std::vector<Index>> mine(bodies);
  for (std::size_t p = 0; p < std::size_t(piece.own); ++p)
    if (body_of[p] >= 0) mine[std::size_t(body_of[p])].push_back(piece.model.particles[p].id);
  std::vector<std::vector<Index>> ids;
  for (const std::string& bytes : ranks.gather(packed(mine))) {
    const auto theirs = unpacked<std::vector<std::vector<Index>>>(bytes);
    ids.resize(bodies);
    for (std::size_t b = 0; b < bodies; ++b) ids[b].insert(ids[b].end(), theirs[b].begin(), theirs[b].end());
  }
  for (std::vector<Index>& body : ids) std::sort(body.begin(), body.end());
  return ids;
}

}  // namespace

Held held_on_ranks(const Partners& partners, const BondNetwork& network, std::vector<std::uint8_t> free,
                   Index load_case, Unsupported unsupported) {
  const Piece& piece = partners.piece;
  Ranks& ranks = partners.ranks;
  Held held;
  held.dofs = number_free_dofs(std::move(free));
  const auto condensed = ranks.gather(packed(condense(network, held.dofs, piece.model, piece.particle)));

  std::exception_ptr failure;
  Verdict verdict;
  if (ranks.rank() == 0) try {
      verdict = judge(condensed, unsupported);
      if (!verdict.sound) judge_whole(partners.whole(), load_case, unsupported);
      verdict.sound = true;  // rounding is judged by the whole
    } catch (...) {
      failure = std::current_exception();
      verdict = {};
    }
  verdict = unpacked<Verdict>(ranks.broadcast(ranks.rank() == 0 ? packed(verdict) : ""));
  if (failure) std::rethrow_exception(failure);
  if (!verdict.sound) throw Error(ExitCode::mechanism, "rank 0 has found a mechanism");

  const std::vector<Index> body_of = spread(network, piece.model, piece.particle, verdict.unsupported);
  std::vector<std::uint8_t> left = held.dofs.free;
  held.left_out.assign(left.size(), false);
  for (std::size_t p = 0; p < left.size(); ++p)
    if (body_of[p] >= 0) held.left_out[p] = true, left[p] = 0;
  held.dofs = number_free_dofs(std::move(left));
  held.dropped = dropped_ids(piece, body_of, verdict.unsupported.size(), ranks);
  return held;
}

}  // namespace bondstatic
