// One step after another, alone or on several threads.
#include <algorithm>
#include <cmath>

#include "dynamics/body_lanes.hpp"
#include "dynamics/run_data.hpp"

namespace bondstatic {

namespace {

// Sums over blocks of a fixed size, added up in order, do not depend on who worked on which block.
constexpr Index packs_a_block = 16;

Index blocks_of(Index count, Index size) {
  return (count + size - 1) / size;
}

void gather(const EndsOfBody& of, const std::vector<EndForces>& all, Index body, Bodies& bodies) {
  double* f = &bodies.force[6 * std::size_t(body)];
  for (Index e = of.offset[std::size_t(body)]; e < of.offset[std::size_t(body) + 1]; ++e) {
    const Index end = of.end[std::size_t(e)], slot = end / 2;
    const EndForces& ends = all[std::size_t(slot / pack_size)];
    const auto lane = std::size_t(slot % pack_size);
    for (int i = 0; i < 3; ++i) {
      if (end % 2 == 0) {
        f[i] -= ends.force[i].at[lane];
        f[i + 3] += ends.moment_a[i].at[lane];
      } else {
        f[i] += ends.force[i].at[lane];
        f[i + 3] += ends.moment_b[i].at[lane];
      }
    }
  }
}

}  // namespace

EndsOfBody ends_of_bodies(const std::vector<BondPack>& packs, Index bodies) {
  EndsOfBody of;
  of.offset.assign(std::size_t(bodies) + 2, 0);
  const auto each_end = [&](auto use) {
    for (std::size_t pack = 0; pack < packs.size(); ++pack)
      for (int lane = 0; lane < pack_size; ++lane) {
        const Index slot = Index(pack) * pack_size + lane;
        use(packs[pack].a[lane], 2 * slot);
        use(packs[pack].b[lane], 2 * slot + 1);
      }
  };
  each_end([&](Index body, Index) { ++of.offset[std::size_t(body) + 1]; });
  for (std::size_t p = 1; p < of.offset.size(); ++p) of.offset[p] += of.offset[p - 1];
  of.end.resize(std::size_t(of.offset.back()));
  std::vector<Index> next = of.offset;
  each_end([&](Index body, Index end) { of.end[std::size_t(next[std::size_t(body)]++)] = end; });
  return of;
}

double ExplicitRun::Data::factor_at(Index at_step) const {
  const double t = double(at_step) * options.time_step;
  if (!(t < options.ramp_time)) return 1;
  const double s = t / options.ramp_time;
  return options.ramp == Ramp::linear ? s : s * s * (3 - 2 * s);
}

void ExplicitRun::Data::begin() {
  // Half a kick back, so that the first whole one leaves the velocity of step 0 in the middle. The half of
  // the work that belongs to the time before the start is taken off again.
  const double dt = options.time_step, ramp = factor_at(0);
  double work_before = 0, damped_before = 0, energy = 0;
  for (std::size_t dof = 0; dof < bodies.velocity.size(); ++dof) {
    if (!(bodies.inverse[dof] > 0)) continue;
    const double applied = ramp * bodies.load[dof], f = bodies.force[dof] + applied, v = bodies.velocity[dof];
    const double d = first_particle_damping(options.particle_damping, f, v, bodies.inverse[dof]);
    const double kick = 0.5 * dt * bodies.inverse[dof] * (f + d);
    bodies.velocity[dof] = v - kick;
    work_before += 0.5 * dt * applied * (v - kick);
    damped_before -= 0.5 * dt * d * (v - kick);
    energy += 0.5 * (v - kick) * (v + kick) / bodies.inverse[dof];
  }
  work.add(-work_before);
  dissipated.add(-damped_before);
  initial_energy = energy;
}

StepSums ExplicitRun::Data::move_block(Index block, const Loading& now) {
  const StepSums sums = kick_and_drift(bodies, block, options, now);
  if (options.kinematics == Kinematics::finite) turn(bodies, block, options.time_step);
  return sums;
}

/// Bonds of one block of packs; into the bodies at once, or kept for them to gather.
StepSums ExplicitRun::Data::advance_block(Index block, EndForces* kept) {
  const bool finite = options.kinematics == Kinematics::finite;
  const Index last = std::min(Index(packs.size()), (block + 1) * packs_a_block);
  StepSums sums;
  EndMotions motions;
  EndForces own;
  Lanes damped;
  for (Index k = block * packs_a_block; k < last; ++k) {
    BondPack& pack = packs[std::size_t(k)];
    EndForces& out = kept ? kept[k] : own;
    read_motions(pack, bodies, finite, motions);
    if (dashpots.empty()) {
      advance_bonds(options.kinematics, pack, motions, options.time_step, out);
    } else {
      advance_bonds(options.kinematics, pack, dashpots[std::size_t(k)], motions, options.time_step, out,
                    damped);
      for (const double part : damped.at) sums.dissipated += part;
    }
    if (!kept) add_forces(pack, own, bodies);
  }
  return sums;
}

void ExplicitRun::Data::one_step() {
  const Loading now = loading();
  for (Index block = 0; block < blocks_of(Index(bodies.motion.size()), dofs_a_block); ++block) {
    const StepSums sums = move_block(block, now);
    work.add(sums.work);
    dissipated.add(sums.dissipated);
  }
  for (Index block = 0; block < blocks_of(Index(packs.size()), packs_a_block); ++block)
    dissipated.add(advance_block(block, nullptr).dissipated);
  ++step;
}

void ExplicitRun::Data::add_up(const BlockSums& sums) {
  for (const StepSums& of_bodies : sums.bodies) {
    work.add(of_bodies.work);
    dissipated.add(of_bodies.dissipated);
  }
  for (const StepSums& of_packs : sums.packs) dissipated.add(of_packs.dissipated);
}

void ExplicitRun::Data::steps_on_threads(Index steps) {
  const Index body_blocks = blocks_of(Index(bodies.motion.size()), dofs_a_block);
  const Index pack_blocks = blocks_of(Index(packs.size()), packs_a_block);
  if (ends.empty()) {
    ends.resize(packs.size());
    ends_of_body = ends_of_bodies(packs, bodies.count);
  }
  const auto gather_block = [this](Index block) {
    const Index first = block * (dofs_a_block / 6), last = std::min(bodies.count, first + dofs_a_block / 6);
    for (Index body = first; body < last; ++body) gather(ends_of_body, ends, body, bodies);
  };
  // Two of them: one is added up while the next step fills the other.
  BlockSums sums[2];
  for (BlockSums& one : sums) {
    one.bodies.resize(static_cast<std::size_t>(body_blocks));
    one.packs.resize(static_cast<std::size_t>(pack_blocks));
  }
#pragma omp parallel num_threads(options.threads)
  {
    for (Index n = 0; n < steps; ++n) {
      const Loading now{factor_at(step + n), factor_at(step + n + 1)};
      BlockSums& here = sums[n % 2];
#pragma omp for schedule(static)
      for (Index block = 0; block < body_blocks; ++block) {
        if (n > 0) gather_block(block);
        here.bodies[std::size_t(block)] = move_block(block, now);
      }
#pragma omp for schedule(static)
      for (Index block = 0; block < pack_blocks; ++block)
        here.packs[std::size_t(block)] = advance_block(block, ends.data());
#pragma omp master
      add_up(here);
    }
#pragma omp for schedule(static)
    for (Index block = 0; block < body_blocks; ++block) gather_block(block);
  }
  step += steps;
}

}  // namespace bondstatic
