// The run to rest told as numbered steps.
#include "bondstatic/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "bondstatic/error.hpp"
#include "relax/checkpoint.hpp"
#include "relax/plan.hpp"
#include "solver/machine.hpp"

namespace bondstatic {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

void refuse_what_does_not_fit(double bytes, const StaticOptions& solve) {
  const double limit = solve.memory_limit > 0 ? solve.memory_limit : available_memory();
  if (bytes <= limit) return;
  throw MemoryError(
      fmt::format("the run needs {:.3g} GB of memory, {:.3g} GB are at hand\n    cure: use a machine with "
                  "more memory, or fewer load cases at a time",
                  bytes / 1e9, limit / 1e9));
}

void warn_of_step(const DynamicPlan& plan, std::vector<std::string>& warnings) {
  if (plan.time_step <= plan.critical_time_step) return;
  const std::string text =
      fmt::format("the time step {:.6g} is {:.4g} times the critical one: the run may blow up",
                  plan.time_step, plan.time_step / plan.critical_time_step);
  if (std::find(warnings.begin(), warnings.end(), text) == warnings.end()) warnings.push_back(text);
}

void warn_of_saved(const std::string& load_case, const CaseRun& run, double asked,
                   std::vector<std::string>& warnings) {
  const SavedStates& saved = run.saved();
  if (saved.all().empty() || saved.interval() <= asked) return;
  warnings.push_back(fmt::format(
      "{}save_interval = {:.4g} asks for more states than are kept, one every {:.4g}: at most {}, and none "
      "between two looks (record_interval)",
      load_case.empty() ? "" : load_case + ": ", asked, saved.interval(), most_saved_states));
}

/// What is prescribed and what is free, one a load case.
struct Setup {
  Boundary boundary;
  Held held;
};

/// Load cases with the same supports share what is found of them; bodies left out and loads lost are
/// reported.
std::vector<Setup> set_up(const Model& model, const BondNetwork& network, Unsupported unsupported,
                          Relaxation& relaxation) {
  std::vector<Setup> setups;
  for (std::size_t c = 0; c < model.load_cases.size(); ++c) {
    Boundary boundary = boundary_of(model, Index(c));
    const bool as_before = c > 0 && boundary.free == setups.back().boundary.free;
    Held held = as_before ? setups.back().held : held_by(model, network, boundary.free, unsupported);
    if (!as_before)
      relaxation.dropped.insert(relaxation.dropped.end(), held.dropped.begin(), held.dropped.end());
    const std::string lost = lost_loads(network, held, boundary, model.load_cases[c]);
    if (!lost.empty()) relaxation.warnings.push_back(lost);
    setups.push_back({std::move(boundary), std::move(held)});
  }
  return setups;
}

}  // namespace

bool Relaxation::at_rest() const {
  return !interrupted && std::all_of(cases.begin(), cases.end(),
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
  const std::vector<Setup> setups = set_up(model, network, solve.unsupported, relaxation);

  // 2. Where an earlier part of the run stopped.
  Progress progress(fingerprint_of(model, properties, options, solve.unsupported, hooks.probe_fingerprint),
                    [&](Index c, const DynamicPlan& plan) {
                      warn_of_step(plan, relaxation.warnings);
                      return CaseRun(model, properties, c, setups[std::size_t(c)].held.left_out, plan,
                                     options, relaxation.threads);
                    });
  if (!hooks.resume.empty()) progress.resume(hooks.resume, hooks.resume_name);
  if (!hooks.resume.empty() && hooks.resumed) hooks.resumed(progress.saved());

  // 3. Each load case from rest without loads to rest under loads.
  auto kept = Clock::now();
  const auto keep = [&] {
    if (hooks.keep) hooks.keep(progress.checkpoint());
    kept = Clock::now();
  };
  bool go_on = true;
  for (std::size_t c = 0; c < setups.size() && go_on; ++c) {
    if (c == progress.started()) {
      const auto begin = Clock::now();
      if (c > 0) keep();
      if (hooks.phase) hooks.phase(true);
      const PlanInput input{model, network, properties, setups[c].boundary, setups[c].held};
      progress.start(plan_run(input, options, solve, relaxation.threads));
      relaxation.planning_seconds += seconds_since(begin);
    }
    if (hooks.phase) hooks.phase(false);
    CaseRun& run = progress.run(c);
    while (!run.ended() && go_on) {
      run.go_on(hooks);
      if (seconds_since(kept) >= hooks.keep_every) keep();
      if (hooks.progress)
        go_on =
            hooks.progress({model.load_cases[c], run.step(), run.time(), run.unrest(), run.seconds_left()});
    }
    // Energy, work and reactions of a state of rest; of an interrupted one they are what they are.
    relaxation.cases.push_back(run.result());
    warn_of_saved(model.load_cases[c], run, options.save_interval, relaxation.warnings);
  }
  relaxation.interrupted = relaxation.cases.size() < setups.size() ||
                           std::any_of(relaxation.cases.begin(), relaxation.cases.end(),
                                       [](const RelaxedCase& c) { return c.end == RunEnd::interrupted; });
  if (!relaxation.at_rest()) keep();
  return relaxation;
}

}  // namespace bondstatic
