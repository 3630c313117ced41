// The run to rest told as numbered steps.
#include "bondstatic/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "bondstatic/error.hpp"
#include "io/archive.hpp"
#include "relax/case_run.hpp"
#include "relax/plan.hpp"
#include "solver/machine.hpp"

namespace bondstatic {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

const ArchiveFormat checkpoint_format{"checkpoint", 1};

void describe(Archive& archive, const BondDamping& d) {
  archive(d.paper, d.normal, d.shear, d.twisting, d.bending);
}

}  // namespace

void describe(Archive& archive, DynamicPlan& p) {
  archive(p.critical_time_step, p.time_step, p.highest, p.lowest, p.ramp_time, p.hold_time, p.speed, p.decay,
          p.predicted_steps, p.best_particle_damping, p.best_decay, p.best_predicted_steps);
}

namespace {

/// Of all that a run depends on; max_steps may be raised between two parts of it.
std::uint64_t fingerprint_of(const Model& model, std::span<const BondProperties> properties,
                             const RelaxOptions& options, Unsupported unsupported) {
  Archive f;
  for (const Particle& p : model.particles) f(p.id, p.position, p.radius, p.density);
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    const Bond& bond = model.bonds[k];
    const SectionStiffness& c = properties[k].stiffness;
    const double share = properties[k].fraction;
    f(bond.id, bond.a, bond.b, bond.branch, c.kn, c.ks, c.kt, c.kb, c.coupling, share,
      properties[k].moments_fed_back);
  }
  for (const Support& s : model.supports) f(s.particle, s.fixed, s.value, s.load_case);
  for (const Load& l : model.loads) f(l.particle, l.force, l.load_case);
  f(model.load_cases, unsupported, options.kinematics, options.particle_damping);
  describe(f, options.bond_damping);
  f(options.time_step, options.safety, options.ramp, options.ramp_time, options.velocity_limit,
    options.force_limit, options.hold_time, options.record_interval, options.load_factor);
  return f.checksum();
}

void refuse_what_does_not_fit(double bytes, const StaticOptions& solve) {
  const double limit = solve.memory_limit > 0 ? solve.memory_limit : available_memory();
  if (bytes <= limit) return;
  throw MemoryError(
      fmt::format("the run needs {:.3g} GB of memory, {:.3g} GB are at hand\n    cure: use a machine with "
                  "more memory, or fewer "
                  "load cases at a time",
                  bytes / 1e9, limit / 1e9));
}

void warn_of_step(const DynamicPlan& plan, std::vector<std::string>& warnings) {
  if (plan.time_step <= plan.critical_time_step) return;
  const std::string text =
      fmt::format("the time step {:.6g} is {:.4g} times the critical one: the run may blow up",
                  plan.time_step, plan.time_step / plan.critical_time_step);
  if (std::find(warnings.begin(), warnings.end(), text) == warnings.end()) warnings.push_back(text);
}

/// The runs so far, with their plans.
struct Progress {
  std::vector<DynamicPlan> plans;
  std::vector<CaseRun> runs;
};

std::string checkpoint(std::uint64_t fingerprint, Progress& progress) {
  Archive archive(checkpoint_format);
  archive(fingerprint, progress.plans);
  for (CaseRun& run : progress.runs) run.carry(archive);
  return archive.finish();
}

}  // namespace

bool Relaxation::at_rest() const {
  return std::all_of(cases.begin(), cases.end(),
                     [](const RelaxedCase& c) { return c.end == RunEnd::at_rest; });
}

Relaxation relax(const Model& model, const RelaxOptions& options, const StaticOptions& solve,
                 const RelaxHooks& hooks) {
  Relaxation relaxation;
  const int asked = solve.threads > 0 ? solve.threads : cores_at_hand();
  relaxation.threads = solve.yield_cores ? threads_worth_having(asked) : asked;

  // 1. What each bond is, and what holds the model in each load case.
  const auto properties = bond_properties(model);
  const BondNetwork network = bond_network(model, properties);
  refuse_what_does_not_fit(
      run_memory(model, {options.kinematics, 0, options.bond_damping}) * double(model.load_cases.size()),
      solve);
  std::vector<Boundary> boundaries;
  std::vector<Held> held;
  for (std::size_t c = 0; c < model.load_cases.size(); ++c) {
    boundaries.push_back(boundary_of(model, Index(c)));
    const bool as_before = c > 0 && boundaries[c].free == boundaries[c - 1].free;
    held.push_back(as_before ? held.back() : held_by(model, network, boundaries[c].free, solve.unsupported));
    const std::string lost = lost_loads(model, held[c], boundaries[c], model.load_cases[c]);
    if (!lost.empty()) relaxation.warnings.push_back(lost);
    if (!as_before)
      relaxation.dropped.insert(relaxation.dropped.end(), held[c].dropped.begin(), held[c].dropped.end());
  }

  // 2. Where an earlier part of the run stopped.
  const std::uint64_t fingerprint = fingerprint_of(model, properties, options, solve.unsupported);
  Progress progress;
  const auto start = [&](std::size_t c) {
    progress.runs.emplace_back(model, properties, Index(c), held[c].left_out, progress.plans[c], options,
                               relaxation.threads);
  };
  if (!hooks.resume.empty()) {
    Archive archive(checkpoint_format, hooks.resume, hooks.resume_name);
    std::uint64_t saved = 0;
    archive(saved);
    if (saved != fingerprint)
      throw Error(
          ExitCode::invalid_input,
          fmt::format("{}: belongs to another model or other options of [dynamics]\n"
                      "    cure: resume with the case it was started with, or start anew without --resume",
                      hooks.resume_name));
    archive(progress.plans);
    for (std::size_t c = 0; c < progress.plans.size(); ++c) {
      start(c);
      progress.runs.back().carry(archive);
    }
    archive.expect_end();
  }

  // 3. Each load case from rest without loads to rest under loads.
  auto kept = Clock::now();
  const auto keep = [&] {
    if (hooks.keep) hooks.keep(checkpoint(fingerprint, progress));
    kept = Clock::now();
  };
  bool go_on = true;
  for (std::size_t c = 0; c < boundaries.size() && go_on; ++c) {
    if (c == progress.runs.size()) {
      const auto begin = Clock::now();
      if (c > 0) keep();
      if (hooks.phase) hooks.phase(true);
      const PlanInput input{model, network, properties, boundaries[c], held[c]};
      progress.plans.push_back(plan_run(input, options, solve, relaxation.threads));
      start(c);
      relaxation.planning_seconds += seconds_since(begin);
      warn_of_step(progress.plans.back(), relaxation.warnings);
    }
    if (hooks.phase) hooks.phase(false);
    CaseRun& run = progress.runs[c];
    while (!run.ended() && go_on) {
      run.go_on(hooks.probe);
      if (seconds_since(kept) >= hooks.keep_every) keep();
      if (hooks.progress)
        go_on =
            hooks.progress({model.load_cases[c], run.step(), run.time(), run.unrest(), run.seconds_left()});
    }
    // Energy, work and reactions of a state of rest; of an interrupted one they are what they are.
    relaxation.cases.push_back(run.result());
  }
  if (!go_on || !relaxation.at_rest()) keep();
  return relaxation;
}

}  // namespace bondstatic
