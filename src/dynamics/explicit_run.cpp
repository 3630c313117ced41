#include <cmath>

#include "bondstatic/dynamics.hpp"
#include "dynamics/run_data.hpp"

namespace bondstatic {

double run_memory(const Model& model, const DynamicOptions& options) {
  const double packs = std::ceil(double(model.bonds.size()) / pack_size);
  const double pack =
      sizeof(BondPack) + sizeof(EndForces) + (options.bond_damping.any() ? sizeof(DashpotPack) : 0);
  const double body = 5 * 6 * sizeof(double) + 5 * sizeof(double) + sizeof(Vector6) * 2;
  const double bond = sizeof(BondProperties) + 3 * sizeof(Index);
  return packs * pack + double(model.particles.size()) * body + double(model.bonds.size()) * bond;
}

ExplicitRun::ExplicitRun(const Model& model, std::span<const BondProperties> properties, Index load_case,
                         const std::vector<bool>& left_out, const DynamicOptions& options)
    : data_(std::make_unique<Data>()) {
  Data& d = *data_;
  d.properties.assign(properties.begin(), properties.end());
  d.options = options;
  d.name = model.load_cases.at(std::size_t(load_case));
  d.boundary = boundary_of(model, load_case);
  const std::vector<bool> nobody(model.particles.size(), false);
  const std::vector<bool>& out = left_out.empty() ? nobody : left_out;
  d.bodies = make_bodies(model, d.boundary, out, options);
  d.packs = bond_packs(model, properties, out, d.bodies.count, d.bond_of_lane);
  if (!options.bond_damping.any()) return;
  const auto coefficients = bondstatic::dashpots(model, properties, d.boundary.free, options.bond_damping);
  d.dashpots.resize(d.packs.size());
  for (std::size_t slot = 0; slot < d.bond_of_lane.size(); ++slot) {
    const SectionStiffness& c = coefficients[std::size_t(d.bond_of_lane[slot])];
    DashpotPack& pack = d.dashpots[slot / pack_size];
    const int lane = int(slot % pack_size);
    pack.cn[lane] = c.kn;
    pack.cs[lane] = c.ks;
    pack.ct[lane] = c.kt;
    pack.cb[lane] = c.kb;
  }
}

ExplicitRun::~ExplicitRun() = default;
ExplicitRun::ExplicitRun(ExplicitRun&&) noexcept = default;

void ExplicitRun::set_velocity(Index particle, const Vector6& velocity) {
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t dof = 6 * std::size_t(particle) + i;
    if (data_->bodies.inverse[dof] > 0) data_->bodies.velocity[dof] = velocity[Eigen::Index(i)];
  }
}

void ExplicitRun::advance(Index steps) {
  if (steps <= 0) return;
  if (data_->step == 0) data_->begin();
  const auto alone = [this](Index count) {
    for (Index n = 0; n < count; ++n) data_->one_step();
  };
  // Threads that meet three times a step cost microseconds, as much as a hundred bonds.
  constexpr Index worth_threads = 1000;
  if (data_->options.threads < 2 || Index(data_->bond_of_lane.size()) < worth_threads) return alone(steps);
  data_->thread_choice(steps, [&](Index count, bool together) {
    if (together)
      data_->steps_on_threads(count);
    else
      alone(count);
  });
}

Index ExplicitRun::step() const {
  return data_->step;
}

double ExplicitRun::time() const {
  return double(data_->step) * data_->options.time_step;
}

double ExplicitRun::load_factor() const {
  return data_->options.load_factor * data_->factor_at(data_->step);
}

}  // namespace bondstatic
