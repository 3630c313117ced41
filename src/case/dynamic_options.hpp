// [dynamics]: the explicit run to rest.
//
//   kinematics = "finite" | "small"; particle_damping, below 1; bond_damping = NUMBER, the one of the paper |
//   { normal, shear, twisting, bending }, parts of critical
//   time_step | safety, the part of the critical time step; ramp_time, ramp = "linear" | "smooth"
//   velocity_limit, force_limit, hold_time: when it is at rest; max_steps; record_interval; save_interval
//
// [check]: tolerance. What the run works out for itself (time_step, the other times) stays absent.
#pragma once

#include "bondstatic/relaxation.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

RelaxOptions read_dynamic_options(Reading& reading, Node& table);

double read_check_tolerance(Reading& reading, Node& table);

}  // namespace bondstatic
