// A small model and an answer made by hand: the rooms below need not work for results to be tested.
#pragma once

#include "bondstatic/model.hpp"
#include "bondstatic/statics.hpp"

namespace bondstatic::test {

/// Four particles on a line along z, ids 10, 20, 30 and 99, the last one left out; bonds 10-20 and 20-30.
inline Model hand_made_model() {
  Model model;
  const Index ids[] = {10, 20, 30, 99};
  for (int i = 0; i < 4; ++i) model.particles.push_back({ids[i], Vector3(0, 0, 2.0 * i), 1.0});
  model.particles[1].radius = 1.5;
  model.particles[3].position.x() = 50;
  model.blocks.push_back({"generic", {600, 600, 1, 1}, {}, {}});
  model.bonds.push_back({1, 0, 1, Vector3(0, 0, 2), 0, 0});
  model.bonds.push_back({2, 1, 2, Vector3(0, 0, 2), 0, 1});
  Support support;
  support.particle = 0;
  support.fixed.fill(true);
  model.supports.push_back(support);
  return model;
}

/// Pulled by 6 along z at particle 30, which moves by 0.03.
inline LoadCaseResult hand_made_result(const std::string& name) {
  LoadCaseResult result;
  result.name = name;
  result.displacement.assign(4, Vector6::Zero());
  result.reaction.assign(4, Vector6::Zero());
  result.displacement[1] << 0, 0, 0.01, 0, 0, 0;
  result.displacement[2] << 0.04, 0, 0.03, 0, 0.3, 0.4;
  result.reaction[0] << 0, 0, -6, 0, 1, 0;
  result.displacement[3].setConstant(not_given);
  result.reaction[3].setConstant(not_given);
  result.bonds.resize(2);
  result.bonds[0].force << 0, 0, -6, 0, 0, 0;
  result.bonds[0].normal_force = 6;
  result.bonds[0].sigma = 0.1;
  result.bonds[0].energy = 0.25;
  result.bonds[1].normal_force = 5;
  result.bonds[1].energy = 0.5;
  result.energy = 0.75;
  result.work = 1.5;
  return result;
}

}  // namespace bondstatic::test
