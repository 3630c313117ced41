// What happens to a model when bonds go: what comes loose with them is left out, the rest settles anew.
#include <fmt/format.h>

#include <algorithm>

#include "bondstatic/error.hpp"
#include "bondstatic/mechanism.hpp"
#include "fracture/damaged_model.hpp"
#include "system/unknowns.hpp"

namespace bondstatic {

namespace {

// What is left of a link's stiffness below which its removal may leave a mechanism, which then is looked for;
// and below which it is rounding that is left, and the old factor says nothing of what remains.
constexpr double doubtful = 1e-3, too_little = 1e-9;

}  // namespace

BondNetwork DamagedModel::standing() const {
  BondNetwork rest = network_;
  rest.links.clear();
  for (std::size_t k = 0; k < gone_.size(); ++k)
    if (!gone_[k]) rest.links.push_back(network_.links[k]);
  return rest;
}

// What came loose is left out, unless the rest then does not stand.
DamagedModel::Removal DamagedModel::drop_what_is_loose() {
  Removal removal;
  std::vector<std::uint8_t> free = dofs_.free;
  std::vector<bool> left_out = left_out_;
  auto found = find_mechanisms(model_, standing(), dofs_, left_out_);
  if (!found.empty()) {
    // Without the cure, which is for models that are mechanisms from the start.
    removal.what = describe(model_, found.front());
    removal.what.erase(std::min(removal.what.find('\n'), removal.what.size()));
    if (found.size() > 1) removal.what += fmt::format("; {} more are loose", found.size() - 1);
  }
  for (Mechanism& mechanism : found) {
    if (mechanism.kind == Mechanism::Kind::internal) {
      removal.outcome = Outcome::mechanism;
      continue;
    }
    for (const Index p : mechanism.particles) {
      const auto i = std::size_t(p);
      if (!scaled_.load[i].isZero(0) && removal.outcome == Outcome::stands)
        removal.outcome = Outcome::cut_off;
      if (!held_.load[i].isZero(0)) removal.load_lost = true;
      free[i] = 0;
      left_out[i] = true;
    }
    removal.separated.push_back(std::move(mechanism.particles));
  }
  FreeDofs dofs = number_free_dofs(std::move(free));
  const auto& acted_on = path_->particles();
  const auto is_out = [&](Index p) { return left_out[std::size_t(p)]; };
  if (removal.outcome == Outcome::stands &&
      (dofs.unknowns() == 0 || (!acted_on.empty() && std::all_of(acted_on.begin(), acted_on.end(), is_out))))
    removal.outcome = Outcome::cut_off;
  if (removal.outcome != Outcome::stands || removal.separated.empty()) return removal;
  const Affine work = held_work();
  for (const auto& body : removal.separated)
    for (const Index p : body) leave_out(p);
  const Affine work_left = held_work();
  removal.lost_work = {work.held - work_left.held, work.scaled - work_left.scaled};
  dofs_ = std::move(dofs);
  analysed_ = false;
  return removal;
}

void DamagedModel::pin(const std::vector<Index>& body) {
  // A particle that supports leave all its motions can take up those of the whole body.
  const auto most_free = std::max_element(body.begin(), body.end(), [&](Index l, Index r) {
    return low_rank_->unknowns_of(l) < low_rank_->unknowns_of(r);
  });
  double stiffness = 0;
  for (const Index k : incidence_.of(*most_free))
    stiffness = std::max(stiffness, normal_stiffness_[std::size_t(k)]);
  low_rank_->pin(*most_free, stiffness);
}

// Columns: scaled, held. Returns the largest entry of each.
std::vector<double> DamagedModel::move_by(const Eigen::MatrixXd& steps) {
  std::vector<double> sizes;
  for (Index c = 0; c < steps.cols(); ++c) {
    auto& motion = motions_[std::size_t(1 - c)];
    for_each_unknown(dofs_, [&](std::size_t p, int i, Index unknown) {
      motion[p][i] += Extended(steps(unknown, c)) / (i < 3 ? 1 : network_.rotation_length);
    });
    sizes.push_back(steps.rows() > 0 ? steps.col(c).lpNorm<Eigen::Infinity>() : 0);
  }
  return sizes;
}

DamagedModel::Removal DamagedModel::take_out(const std::vector<BrokenBond>& bonds) {
  std::vector<Link> links;
  std::vector<SectionStiffness> stiffness;
  for (const BrokenBond& broken : bonds) {
    const auto k = std::size_t(broken.bond);
    links.push_back(network_.links[k]);
    stiffness.push_back(properties_[k].stiffness);
    network_.links[k].stiffness = properties_[k].stiffness = {};
    gone_[k] = true;
  }
  const auto put_back = [&] {
    for (std::size_t i = 0; i < bonds.size(); ++i) {
      const auto k = std::size_t(bonds[i].bond);
      network_.links[k] = links[i];
      properties_[k].stiffness = stiffness[i];
      gone_[k] = false;
    }
  };
  // Deformed as they are, they will let go.
  std::vector<std::vector<Vector6>> deltas;
  for (const std::size_t part : {1, 0}) {
    if (part == 0 && !preloaded_) continue;
    auto& of_part = deltas.emplace_back();
    for (const Link& link : links)
      of_part.push_back(
          link_motion<Extended>(link, motions_[part], (part == 0 ? held_ : scaled_).strain).cast<double>());
  }
  const auto before = motions_;
  Removal removal;
  fresh_ = false;
  // Of very many at once, a new factor costs less.
  const bool few = low_rank_ && 6 * Index(links.size()) <= most_rank_;
  double left = few ? low_rank_->take_out(links, doubtful) : solver_ ? 0 : 1;
  const bool looked = left < doubtful;
  if (looked) {
    removal = drop_what_is_loose();
    if (removal.outcome != Outcome::stands) {
      put_back();
      return removal;
    }
    if (few) {
      for (const auto& body : removal.separated) pin(body);
      left = low_rank_->take_out(links, too_little);
      low_rank_->keep_only(dofs_);
    }
    if (left < too_little) refresh();
  }
  try {
    std::vector<double> came_by;
    if (low_rank_ && !fresh_) came_by = move_by(low_rank_->let_go(deltas));
    refine(std::move(came_by));
  } catch (const AccuracyError&) {
    // The changes have spoilt the factor, or rounding has hidden that something came loose.
    motions_ = before;
    if (!looked) removal = drop_what_is_loose();
    if (removal.outcome != Outcome::stands) put_back();
    motions_.assign(2, {});
    refresh();
    refine({});
  }
  recover_parts();
  return removal;
}

}  // namespace bondstatic
