// What the two motions of a damaged model mean: resultants, energy, the state at a factor, a checkpoint.
#include <algorithm>
#include <array>

#include "fracture/damaged_model.hpp"
#include "statics/recover.hpp"

namespace bondstatic {

namespace {

// Parts of the largest motion that are rounding of numbers of 106 bits: a bond that only rides along would
// break by them, at a factor of 1e29.
constexpr double nothing = 1e-24;

/// Largest entry, with rotations times `length`.
double size_of(const Vector6& motion, double length) {
  return std::max(motion.head<3>().cwiseAbs().maxCoeff(), length * motion.tail<3>().cwiseAbs().maxCoeff());
}

double size_of(const BodyVectors<Extended>& motions, const Boundary& boundary, double length) {
  double most = length * boundary.strain.cwiseAbs().maxCoeff();
  for (const auto& motion : motions) most = std::max(most, size_of(motion.cast<double>(), length));
  return most;
}

Vector6 link_motion_at(const Link& link, const std::vector<BodyVectors<Extended>>& motions,
                       const Boundary& held, const Boundary& scaled, double factor) {
  const auto of_held = link_motion<Extended>(link, motions[0], held.strain);
  const auto of_scaled = link_motion<Extended>(link, motions[1], scaled.strain);
  return (of_held + Extended(factor) * of_scaled).cast<double>();
}

}  // namespace

void DamagedModel::recover_parts() {
  const Index bonds = Index(network_.links.size());
  carried_.resize(network_.links.size());
  std::vector<StrainEnergy> energies(network_.links.size());
  const double length = network_.rotation_length;
  const double least[] = {nothing * size_of(motions_[0], held_, length),
                          nothing * size_of(motions_[1], scaled_, length)};
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1 && bonds > worth_threads)
  for (Index i = 0; i < bonds; ++i) {
    const auto k = std::size_t(i);
    const Link& link = network_.links[k];
    carried_[k] = {};
    if (!stands(i)) continue;
    const Vector3 axis = bond_axis<double>(link);
    const auto delta_of = [&](std::size_t part, const Boundary& boundary) {
      const Vector6 delta = link_motion<Extended>(link, motions_[part], boundary.strain).cast<double>();
      return size_of(delta, length) > least[part] ? delta : Vector6(Vector6::Zero());
    };
    // Torque feedback off: moments that equilibrium does not see load the bond all the same.
    const SectionStiffness& c = properties_[k].stiffness;
    const Vector6 scaled = delta_of(1, scaled_), q_scaled = resultants<double>(link.stiffness, axis, scaled);
    carried_[k].scaled = section_vector(link.branch, resultants<double>(c, axis, scaled));
    energies[k].scaled = scaled.dot(q_scaled);
    if (!preloaded_) continue;
    const Vector6 held = delta_of(0, held_);
    carried_[k].held = section_vector(link.branch, resultants<double>(c, axis, held));
    energies[k].held = held.dot(resultants<double>(link.stiffness, axis, held));
    energies[k].mixed = held.dot(q_scaled);
  }
  energy_ = {};
  for (const StrainEnergy& of_bond : energies) {
    energy_.held += of_bond.held;
    energy_.mixed += of_bond.mixed;
    energy_.scaled += of_bond.scaled;
  }
}

Vector6 DamagedModel::motion_of(Index bond, double factor) const {
  return link_motion_at(network_.links[std::size_t(bond)], motions_, held_, scaled_, factor);
}

Vector6 DamagedModel::resultants_of(Index bond, double factor) const {
  const Link& link = network_.links[std::size_t(bond)];
  return resultants<double>(link.stiffness, bond_axis<double>(link), motion_of(bond, factor));
}

State DamagedModel::state(double factor) const {
  const std::size_t bodies = model_.particles.size();
  Boundary boundary = scaled_;
  Refined refined{BodyVectors<Extended>(bodies), accuracy_};
  boundary.strain = held_.strain + factor * scaled_.strain;
  boundary.load_tail.resize(bodies);
  for (std::size_t p = 0; p < bodies; ++p) {
    const Vector6T<Extended> load =
        held_.load[p].cast<Extended>() + Extended(factor) * scaled_.load[p].cast<Extended>();
    boundary.load[p] = load.cast<double>();
    boundary.load_tail[p] = (load - boundary.load[p].cast<Extended>()).cast<double>();
    boundary.prescribed[p] = held_.prescribed[p] + factor * scaled_.prescribed[p];
    refined.motion[p] = motions_[0][p] + Extended(factor) * motions_[1][p];
  }
  return recover(model_, network_, incidence_, properties_, boundary, left_out_, refined, threads_);
}

void DamagedModel::carry(Archive& archive) {
  using Halves = std::array<double, 12>;
  archive(gone_, left_out_);
  for (auto& motion : motions_) {
    std::vector<Halves> halves(motion.size());
    for (std::size_t p = 0; p < motion.size(); ++p)
      for (int i = 0; i < 6; ++i) {
        halves[p][std::size_t(2 * i)] = motion[p][i].x[0];
        halves[p][std::size_t(2 * i + 1)] = motion[p][i].x[1];
      }
    archive(halves);
    if (!archive.reading()) continue;
    motion.resize(halves.size());
    for (std::size_t p = 0; p < motion.size(); ++p)
      for (int i = 0; i < 6; ++i)
        motion[p][i] = dd_real(halves[p][std::size_t(2 * i)], halves[p][std::size_t(2 * i + 1)]);
  }
  if (!archive.reading()) return;
  for (std::size_t k = 0; k < gone_.size(); ++k)
    if (gone_[k]) network_.links[k].stiffness = properties_[k].stiffness = {};
  for (std::size_t p = 0; p < left_out_.size(); ++p)
    if (left_out_[p]) leave_out(Index(p));
  std::vector<std::uint8_t> free = scaled_.free;
  for (std::size_t p = 0; p < free.size(); ++p)
    if (left_out_[p]) free[p] = 0;
  dofs_ = number_free_dofs(std::move(free));
  analysed_ = fresh_ = false;
}

}  // namespace bondstatic
