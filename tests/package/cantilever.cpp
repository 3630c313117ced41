// A cantilever of three particles and two Timoshenko bonds, built in code and checked against beam theory.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "bondstatic/bond_law.hpp"
#include "bondstatic/statics.hpp"

int main() {
  using namespace bondstatic;
  const double young = 2e11, poisson = 0.3, radius = 0.2, spacing = 0.8, length = 2 * spacing, load = 1e5;

  Model model;
  for (Index id = 1; id <= 3; ++id)
    model.particles.push_back(
        {.id = id, .position = spacing * double(id - 1) * Vector3::UnitX(), .radius = radius});

  const BondLaw& law = *find_bond_law("timoshenko");
  BondBlock block;
  block.law = law.name;
  block.parameters.assign(law.parameters.size(), not_given);
  const auto set = [&](const char* name, double value) {
    block.parameters.at(std::size_t(law.find(name))) = value;
  };
  set("young", young);
  set("poisson", poisson);
  set("radius", radius);
  model.blocks.push_back(block);
  for (Index k = 0; k < 2; ++k)
    model.bonds.push_back(
        {.id = k + 1, .a = k, .b = k + 1, .branch = spacing * Vector3::UnitX(), .block = 0, .in_block = k});

  Support root;
  root.particle = 0;
  root.fixed.fill(true);
  model.supports.push_back(root);
  Load tip;
  tip.particle = 2;
  tip.force(1) = load;
  model.loads.push_back(tip);

  const StaticSolution solution = solve_statics(model, {});
  const double deflection = solution.cases.at(0).displacement.at(2)(1);

  // F L^3 / 3EI of bending and F L / (G A k) of shear, with the shear coefficient k of [Chen2022] Eq. 29.
  const double bending_stiffness = young * std::numbers::pi * std::pow(radius, 4) / 4;
  const double theory = load * std::pow(length, 3) / (3 * bending_stiffness) +
                        load * length * (20 * radius * radius * (1 + poisson) / 3) / (12 * bending_stiffness);
  const double error = std::abs(deflection / theory - 1);
  std::printf("tip deflection %.17g, theory %.17g, relative error %.1e\n", deflection, theory, error);
  return error < 1e-14 ? 0 : 1;
}
