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
  // What the run keeps of the new order, and the copy of the model that it begins with.
  const bool near = worth_renumbering(model);
  const double particle_near = near ? 2 * sizeof(Index) + sizeof(Particle) : 0;
  const double bond_near = near ? sizeof(Index) + sizeof(Bond) : 0;
  return packs * pack + double(model.particles.size()) * (body + particle_near) +
         double(model.bonds.size()) * (bond + bond_near);
}

namespace {

template <class Items>
auto in_order(const Items& items, const std::vector<Index>& order) {
  std::vector<typename Items::value_type> picked(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) picked[i] = items[std::size_t(order[i])];
  return picked;
}

}  // namespace

ExplicitRun::ExplicitRun(const Model& model, std::span<const BondProperties> properties, Index load_case,
                         const std::vector<bool>& left_out, const DynamicOptions& options)
    : data_(std::make_unique<Data>()) {
  Data& d = *data_;
  d.options = options;
  d.name = model.load_cases.at(std::size_t(load_case));
  const std::vector<bool> nobody(model.particles.size(), false);
  const std::vector<bool>& out = left_out.empty() ? nobody : left_out;
  if (!worth_renumbering(model)) {
    d.properties.assign(properties.begin(), properties.end());
    d.set_up(model, load_case, out);
    return;
  }
  // What is wrong is told of the first particle in the model's order.
  require_masses(model, boundary_of(model, load_case), out);
  d.order = space_order(model, options.threads);
  d.body_of_particle = positions_in(d.order.particle);
  d.properties = in_order(properties, d.order.bond);
  d.set_up(renumbered(model, d.order, options.threads), load_case, in_order(out, d.order.particle));
}

void ExplicitRun::Data::set_up(const Model& model, Index load_case, const std::vector<bool>& left_out) {
  boundary = boundary_of(model, load_case);
  bodies = make_bodies(model, boundary, left_out, options);
  packs = bond_packs(model, properties, left_out, bodies.count, bond_of_lane);
  if (!options.bond_damping.any()) return;
  const auto coefficients = bondstatic::dashpots(model, properties, boundary.free, options.bond_damping);
  dashpots.resize(packs.size());
  for (std::size_t slot = 0; slot < bond_of_lane.size(); ++slot) {
    const SectionStiffness& c = coefficients[std::size_t(bond_of_lane[slot])];
    DashpotPack& pack = dashpots[slot / pack_size];
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
    const std::size_t dof = 6 * std::size_t(data_->body_of(particle)) + i;
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
