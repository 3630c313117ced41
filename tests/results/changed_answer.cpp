#include "results/changed_answer.hpp"

#include <Eigen/LU>
#include <cmath>

namespace bondstatic::test {

namespace {

/// As statics/recover.cpp has them.
void settle_bond(BondResult& bond, const Vector3& axis, double radius) {
  const Vector3 force = bond.force.head<3>(), moment = bond.force.tail<3>();
  bond.normal_force = -axis.dot(force);
  bond.shear_force = (force - axis.dot(force) * axis).norm();
  bond.twisting_moment = axis.dot(moment);
  bond.bending_moment = (moment - axis.dot(moment) * axis).norm();
  const SectionStress stress = section_stress(
      {bond.normal_force, bond.shear_force, bond.twisting_moment, bond.bending_moment}, radius);
  bond.sigma = stress.sigma;
  bond.tau = stress.tau;
}

EffectiveStiffness effective_of(const std::vector<LoadCaseResult>& cases) {
  Matrix6 strains, stresses;
  for (int c = 0; c < 6; ++c) {
    strains.col(c) = voigt_of_strain(cases[std::size_t(c)].strain);
    stresses.col(c) = voigt_of_stress(cases[std::size_t(c)].stress);
  }
  const Matrix6 found = stresses * strains.inverse();
  EffectiveStiffness effective;
  effective.stiffness = 0.5 * (found + found.transpose());
  effective.isotropic = isotropic_fit(effective.stiffness);
  return effective;
}

void settle(const Model& model, AnswerWithSections& answer) {
  for (LoadCaseResult& one : answer.solution.cases) {
    one.work = 2 * one.energy;
    for (std::size_t k = 0; k < model.bonds.size(); ++k)
      settle_bond(one.bonds[k], model.bonds[k].branch.normalized(), answer.properties[k].radius);
  }
  answer.solution.effective = effective_of(answer.solution.cases);
}

}  // namespace

AnswerWithSections random_answer(const Model& model, std::mt19937_64& random, Index left_out) {
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return Vector6(Vector6::NullaryExpr([&] { return number(random); })); };
  AnswerWithSections answer;
  for (int c = 0; c < 6; ++c) {
    LoadCaseResult one;
    one.name = std::string(1, char('a' + c));
    for (std::size_t p = 0; p < model.particles.size(); ++p) {
      one.displacement.push_back(vector());
      one.displacement.back().head<3>() += model.particles[p].position;
      one.reaction.push_back(vector());
    }
    for (std::size_t k = 0; k < model.bonds.size(); ++k) {
      one.bonds.emplace_back().force = vector();
      one.bonds.back().energy = number(random);
    }
    one.energy = number(random);
    const Matrix3 strain = Matrix3::NullaryExpr([&] { return number(random); }),
                  stress = Matrix3::NullaryExpr([&] { return number(random); });
    one.strain = strain + strain.transpose();
    one.stress = stress + stress.transpose();
    if (c > 0) {
      one.displacement[std::size_t(left_out)].setConstant(not_given);
      one.reaction[std::size_t(left_out)].setConstant(not_given);
      for (std::size_t k = 0; k < model.bonds.size(); ++k)
        if (model.bonds[k].a == left_out || model.bonds[k].b == left_out) one.bonds[k] = left_out_bond();
    }
    answer.solution.cases.push_back(one);
  }
  for (std::size_t k = 0; k < model.bonds.size(); ++k)
    answer.properties.emplace_back().radius = 1.5 + 0.5 * number(random);
  settle(model, answer);
  return answer;
}

AnswerWithSections moved(const Model& model, const AnswerWithSections& answer,
                         const AnswerWithSections& direction, double step) {
  AnswerWithSections changed = answer;
  for (std::size_t c = 0; c < answer.solution.cases.size(); ++c) {
    LoadCaseResult& one = changed.solution.cases[c];
    const LoadCaseResult& along = direction.solution.cases[c];
    for (std::size_t p = 0; p < one.displacement.size(); ++p) {
      one.displacement[p] += step * along.displacement[p];
      one.reaction[p] += step * along.reaction[p];
    }
    for (std::size_t k = 0; k < one.bonds.size(); ++k) {
      one.bonds[k].force += step * along.bonds[k].force;
      one.bonds[k].energy += step * along.bonds[k].energy;
    }
    one.energy += step * along.energy;
    one.stress += step * along.stress;
  }
  for (std::size_t k = 0; k < changed.properties.size(); ++k)
    changed.properties[k].radius += step * direction.properties[k].radius;
  settle(model, changed);
  return changed;
}

Change applied(const Functionals& functionals, const AnswerWithSections& direction) {
  Change change;
  const auto add = [&](double part) { change.value += part, change.magnitude += std::abs(part); };
  for (const Functional& functional : functionals) {
    const State& along = direction.solution.cases[std::size_t(functional.load_case)];
    for (const auto& [p, weight] : functional.displacement)
      add(weight.dot(along.displacement[std::size_t(p)]));
    for (const auto& [p, weight] : functional.reaction) add(weight.dot(along.reaction[std::size_t(p)]));
    for (const BondWeight& weight : functional.bonds) {
      const auto k = std::size_t(weight.bond);
      add(weight.force.dot(along.bonds[k].force));
      add(weight.energy * along.bonds[k].energy);
      add(weight.radius * direction.properties[k].radius);
    }
    add(functional.energy * along.energy);
    add(functional.stress.cwiseProduct(along.stress).sum());
  }
  return change;
}

}  // namespace bondstatic::test
