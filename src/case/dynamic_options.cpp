#include "case/dynamic_options.hpp"

#include <fmt/format.h>

namespace bondstatic {
namespace {

using Choices = std::vector<std::string>;

BondDamping read_bond_damping(TableReader& dynamics) {
  constexpr auto part = [](TableReader& table, const char* key) {
    return table.number_or(key, 0, dimension::none, Allowed::not_negative);
  };
  BondDamping damping;
  Node* node = dynamics.find("bond_damping");
  if (node && node->is_table()) {
    TableReader members(dynamics.reading(), *node, "bond_damping");
    damping.normal = part(members, "normal");
    damping.shear = part(members, "shear");
    damping.twisting = part(members, "twisting");
    damping.bending = part(members, "bending");
    members.finish();
  } else if (node && !node->is_number() && !node->is_text()) {
    dynamics.reading().fault(
        node->place, fmt::format("bond_damping = {} must be a number or a table", shown(*node)),
        "write bond_damping = NUMBER or { normal = N, shear = N, twisting = N, bending = N }");
  } else {
    damping.paper = part(dynamics, "bond_damping");
  }
  return damping;
}

double read_particle_damping(TableReader& dynamics, double fallback) {
  const double damping =
      dynamics.number_or("particle_damping", fallback, dimension::none, Allowed::not_negative);
  if (damping < 1) return damping;
  dynamics.reading().fault(dynamics.place_of("particle_damping"),
                           fmt::format("particle_damping = {} must be below 1", damping),
                           fmt::format("write particle_damping = {}, or 0 for none", fallback));
  return fallback;
}

/// Above 1 a run blows up, which somebody may want to see; far above it shows nothing more.
double read_safety(TableReader& dynamics, double fallback) {
  constexpr double most = 2;
  const double safety = dynamics.number("safety", dimension::none, Allowed::positive).value_or(fallback);
  Reading& reading = dynamics.reading();
  const Place& place = dynamics.place_of("safety");
  if (safety > most) {
    reading.fault(place, fmt::format("safety = {} must be at most {}", safety, most),
                  fmt::format("write safety = {}; the run is stable below 1", fallback));
    return fallback;
  }
  if (safety > 1 && reading.purpose == Purpose::dynamics)
    reading.warnings.push_back(to_string(Fault{
        place, fmt::format("safety = {}: above the critical time step the run may blow up", safety), ""}));
  return safety;
}

void read_time_step(TableReader& dynamics, RelaxOptions& options) {
  const std::string given = dynamics.at_most_one_of(Choices{"time_step", "safety"});
  options.time_step = dynamics.number("time_step", dimension::time, Allowed::positive).value_or(0);
  options.safety = read_safety(dynamics, options.safety);
  if (given.empty()) dynamics.set_default("safety", Node::of(options.safety));
}

}  // namespace

RelaxOptions read_dynamic_options(Reading& reading, Node& table) {
  TableReader dynamics(reading, table, "[dynamics]");
  RelaxOptions options;
  options.kinematics = dynamics.choice_or("kinematics", "finite", Choices{"finite", "small"}) == "small"
                           ? Kinematics::small
                           : Kinematics::finite;
  options.particle_damping = read_particle_damping(dynamics, options.particle_damping);
  options.bond_damping = read_bond_damping(dynamics);
  read_time_step(dynamics, options);
  options.ramp = dynamics.choice_or("ramp", "linear", Choices{"linear", "smooth"}) == "smooth" ? Ramp::smooth
                                                                                               : Ramp::linear;
  options.ramp_time =
      dynamics.number("ramp_time", dimension::time, Allowed::not_negative).value_or(not_given);
  options.velocity_limit =
      dynamics.number_or("velocity_limit", options.velocity_limit, dimension::velocity, Allowed::positive);
  options.force_limit =
      dynamics.number_or("force_limit", options.force_limit, dimension::none, Allowed::positive);
  options.hold_time = dynamics.number("hold_time", dimension::time, Allowed::positive).value_or(not_given);
  options.max_steps = dynamics.whole_or("max_steps", options.max_steps, 1);
  options.record_interval =
      dynamics.number("record_interval", dimension::time, Allowed::positive).value_or(not_given);
  options.save_interval =
      dynamics.number("save_interval", dimension::time, Allowed::positive).value_or(not_given);
  dynamics.finish();
  return options;
}

double read_check_tolerance(Reading& reading, Node& table) {
  TableReader check(reading, table, "[check]");
  const double tolerance =
      check.number_or("tolerance", RelaxOptions{}.check_tolerance, dimension::none, Allowed::positive);
  check.finish();
  return tolerance;
}

}  // namespace bondstatic
