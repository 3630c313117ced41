#include "calibration/tests_of_models.hpp"

#include <cmath>

namespace bondstatic::test {

namespace {

Output output(const std::string& name, const std::string& of, std::vector<Index> at,
              const std::string& load_case, Output::Reduce reduce = Output::Reduce::value) {
  Output made;
  made.name = name;
  made.of = of;
  made.at = std::move(at);
  made.load_case = load_case;
  made.reduce = reduce;
  return made;
}

}  // namespace

CalibrationTest cantilever_test(const std::string& law, const Values& values, bool without_twist) {
  CalibrationTest test;
  test.model = chain(block(law, values), {0, 0, 0}, {1, 0, 0}, 10, 0.05);
  test.model.load_cases = {"across", "along", "about"};
  load(test.model, 10, vector6(0, -1e3, 0), 0);
  load(test.model, 10, vector6(1e3, 0, 0), 1);
  load(test.model, 10, vector6(0, 0, 0, 10), 2);
  test.outputs = {output("tip", "uy", {10}, "across"), output("middle", "uy", {5}, "across"),
                  output("stretch", "ux", {10}, "along"), output("half_stretch", "ux", {5}, "along"),
                  output("pull", "reaction_fx", {0}, "along")};
  test.outputs.back().scale = -1e-3;
  if (!without_twist) test.outputs.back() = output("twist", "rx", {10}, "about");
  return test;
}

CalibrationTest packing_test(const std::string& law, const Values& values) {
  CalibrationTest test;
  std::mt19937_64 random(3);
  test.model = random_packing(random, 3, block(law, values));
  test.model.supports.clear();
  test.model.loads.clear();
  test.model.load_cases = {"down", "across", "turned"};
  std::vector<Index> top;
  for (Index p = 0; p < Index(test.model.particles.size()); ++p) {
    const double z = test.model.particles[std::size_t(p)].position.z();
    if (z < 0.5) fix_all(test.model, p);
    if (z <= 1.5) continue;
    top.push_back(p);
    for (Index c = 0; c < 3; ++c) {
      Support plate{.particle = p, .fixed = {true, true, true, true, true, true}, .load_case = c};
      if (c == 0) plate.value = vector6(0, 0, -1e-3);
      if (c == 1) plate.value = vector6(1e-3, 0, 0);
      if (c == 2) plate.value = vector6(0, 0, 0, 0, 0, 1e-3);
      test.model.supports.push_back(plate);
    }
  }
  using Reduce = Output::Reduce;
  test.outputs = {output("press", "reaction_fz", top, "down", Reduce::sum),
                  output("shear", "reaction_fx", top, "across", Reduce::sum),
                  output("torque", "reaction_mz", top, "turned", Reduce::sum),
                  output("energy", "energy", {}, "down"), output("shear_energy", "energy", {}, "across")};
  return test;
}

std::vector<BlockParameter> moves(const CalibrationTest& test, const std::string& parameter) {
  return {{.block = 0, .parameter = std::size_t(find_bond_law(test.model.blocks[0].law)->find(parameter))}};
}

std::vector<double> outputs_of(const CalibrationTest& test) {
  std::vector<double> values;
  const StaticSolution solution = solve_statics(test.model, test.solve);
  for (const OutputValue& value : evaluate_outputs(test.model, solution, test.outputs))
    values.push_back(value.value);
  return values;
}

std::vector<CalibrationTarget> targets_of(const CalibrationTest& test, const std::vector<double>& wanted,
                                          double tolerance) {
  std::vector<CalibrationTarget> targets;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    targets.push_back({.output = test.outputs[i].name,
                       .test = test.name,
                       .wanted = wanted[i],
                       .tolerance = tolerance * std::abs(wanted[i])});
  return targets;
}

std::vector<CalibrationParameter> Known::parameters() const {
  std::vector<CalibrationParameter> list;
  for (std::size_t p = 0; p < names.size(); ++p)
    list.push_back({.name = names[p], .lower = lower[p], .upper = upper[p], .logarithmic = lower[p] > 0});
  return list;
}

std::vector<Known> known_parameters() {
  const auto with = [](CalibrationTest test, const std::vector<std::string>& names) {
    for (const std::string& name : names) test.parameters.push_back(moves(test, name));
    return test;
  };
  using V = const std::vector<double>&;
  return {
      {.name = "TimoshenkoBeam",
       .names = {"young", "poisson"},
       .truth = {35e9, 0.2},
       .start = {50e9, 0.3},
       .lower = {1e9, 0},
       .upper = {1e12, 0.5},
       .test =
           [with](V v) {
             return with(cantilever_test("timoshenko", {{"young", v[0]}, {"poisson", v[1]}}),
                         {"young", "poisson"});
           }},
      {.name = "ParallelPacking",
       .names = {"young", "kappa"},
       .truth = {35e9, 3},
       .start = {60e9, 2},
       .lower = {1e9, 0.5},
       .upper = {1e12, 20},
       .test =
           [with](V v) {
             return with(packing_test("parallel", {{"young", v[0]}, {"kappa", v[1]}}), {"young", "kappa"});
           }},
      {.name = "EdemPacking",
       .names = {"normal_stiffness", "shear_stiffness"},
       .truth = {3e10, 1.2e10},
       .start = {1e10, 1e10},
       .lower = {1e8, 1e8},
       .upper = {1e13, 1e13},
       .test =
           [with](V v) {
             return with(packing_test(
                             "edem-v2",
                             {{"normal_stiffness", v[0]}, {"shear_stiffness", v[1]}, {"torque_feedback", 1}}),
                         {"normal_stiffness", "shear_stiffness"});
           }},
  };
}

}  // namespace bondstatic::test
