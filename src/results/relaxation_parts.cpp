#include "results/relaxation_parts.hpp"

namespace bondstatic {

namespace {

Json plan_of(const DynamicPlan& plan) {
  return {{"critical_time_step", plan.critical_time_step},
          {"time_step", plan.time_step},
          {"highest_frequency", plan.highest},
          {"lowest_frequencies", plan.lowest},
          {"ramp_time", plan.ramp_time},
          {"hold_time", plan.hold_time},
          {"speed_after_ramp", plan.speed},
          {"decay", plan.decay},
          {"predicted_steps", plan.predicted_steps},
          {"best_particle_damping", plan.best_particle_damping},
          {"best_predicted_steps", plan.best_predicted_steps}};
}

Json energies_of(const Energies& energies) {
  return {{"kinetic", energies.kinetic},
          {"strain", energies.strain},
          {"work", energies.work},
          {"dissipated", energies.dissipated},
          {"balance", energies.balance()}};
}

const char* name_of(RunEnd end) {
  switch (end) {
    case RunEnd::at_rest:
      return "at rest";
    case RunEnd::step_limit:
      return "step limit";
    case RunEnd::interrupted:
      break;
  }
  return "interrupted";
}

}  // namespace

Json relaxed_case_of(const Model& model, const RelaxedCase& relaxed) {
  Json one = state_of(model.load_cases, relaxed.state, largest_displacement(model, relaxed.state));
  one["end"] = name_of(relaxed.end);
  one["steps"] = relaxed.steps;
  one["time"] = relaxed.time;
  one["seconds"] = relaxed.seconds;
  one["fastest_particle"] = relaxed.unrest.fastest;
  one["unbalanced_force"] = relaxed.unrest.unbalanced;
  one["energies"] = energies_of(relaxed.energies);
  one["plan"] = plan_of(relaxed.plan);
  return one;
}

}  // namespace bondstatic
