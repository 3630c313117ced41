// [calibration]: which parameters of bond laws shall make which outputs what was measured. Only the command
// of that name uses it.
//
//   cases = ["shear.toml"]: other tests beside this case
//   seeds = { key = "bonds.0.seed", values = [1, 2, 3] }: this case once for each; any whole number of it
//   loss = "squares" | "huber" | "cauchy"; most_evaluations
//
// [[calibration.parameters]]
//   key = "bonds.0.young", or "young" of all blocks that give it; min, max; start, what the case has unless
//   given; scale = "log" (where min > 0) | "linear"
//
// [[calibration.targets]]
//   output, a name of [[outputs]]; wanted, as the output is told, or with a unit; tolerance, the standard
//   deviation of what was measured, of all targets or of none; weight, where there are no tolerances
//   case = "shear.toml" | "this": which test; absent: every test that has the output
#pragma once

#include "bondstatic/calibration.hpp"
#include "case/draft.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

/// `root`: of the whole case, read so far that its defaults stand in it.
CalibrationPlan read_calibration_plan(Draft& draft, Node& root, const std::vector<Output>& outputs);

}  // namespace bondstatic
