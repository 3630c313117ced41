// A model with an answer, whole and as the pieces that the ranks of a run hold.
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "bondstatic/statics.hpp"
#include "model/piece.hpp"
#include "support/models.hpp"

namespace bondstatic::test {

struct Whole {
  Model model;
  StaticSolution solution;
};

/// Nothing in the answer is zero or twice the same, so that each number can only have come from its place.
/// Particle 5 is left out in the first load case, with its bonds.
inline Whole whole_answer(std::vector<std::string> load_cases) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  Whole whole;
  whole.model = random_packing(random, 4, block("timoshenko", {{"young", 1e9}, {"poisson", 0.25}}));
  for (Particle& particle : whole.model.particles) particle.id = 1000 - particle.id;
  fix_all(whole.model, 0);
  fix_all(whole.model, 63);
  for (Index p = 1; p < 63; ++p)
    load(whole.model, p, vector6(1, 2, 3, 4, 5, 6) * double(p), p % 2 == 0 ? every_case : 0);
  whole.model.load_cases = std::move(load_cases);
  for (const std::string& name : whole.model.load_cases) {
    LoadCaseResult result;
    result.name = name;
    for (std::size_t p = 0; p < whole.model.particles.size(); ++p) {
      result.displacement.push_back(Vector6::NullaryExpr([&] { return number(random); }));
      result.reaction.push_back(Vector6::NullaryExpr([&] { return number(random); }));
    }
    for (std::size_t k = 0; k < whole.model.bonds.size(); ++k) {
      BondResult bond;
      bond.force = Vector6::NullaryExpr([&] { return number(random); });
      for (double* value : {&bond.normal_force, &bond.shear_force, &bond.twisting_moment,
                            &bond.bending_moment, &bond.sigma, &bond.tau, &bond.energy})
        *value = number(random);
      result.bonds.push_back(bond);
    }
    result.energy = number(random);
    result.work = number(random);
    whole.solution.cases.push_back(result);
  }
  LoadCaseResult& first = whole.solution.cases.front();
  first.displacement[5].setConstant(not_given);
  first.reaction[5].setConstant(not_given);
  for (std::size_t k = 0; k < first.bonds.size(); ++k)
    if (whole.model.bonds[k].a == 5 || whole.model.bonds[k].b == 5) first.bonds[k] = left_out_bond();
  whole.solution.report.solver = "by hand";
  whole.solution.report.dropped = {{whole.model.particles[5].id}};
  return whole;
}

/// Particles dealt out in slabs along x, except that every eleventh goes elsewhere.
inline std::vector<int> deal(const Model& model, int ranks) {
  std::vector<int> rank_of;
  for (std::size_t p = 0; p < model.particles.size(); ++p)
    rank_of.push_back(p % 11 == 0 ? int(p) % ranks : int(p * std::size_t(ranks) / model.particles.size()));
  return rank_of;
}

/// What a rank has of the answer. Reactions of copies are as wrong as a rank would have them.
inline StaticSolution restricted(const StaticSolution& whole, const Piece& piece) {
  StaticSolution part;
  part.report = whole.report;
  for (const LoadCaseResult& of_all : whole.cases) {
    LoadCaseResult result = of_all;
    result.displacement.clear(), result.reaction.clear(), result.bonds.clear();
    for (std::size_t p = 0; p < piece.particle.size(); ++p) {
      const auto at = std::size_t(piece.particle[p]);
      result.displacement.push_back(of_all.displacement[at]);
      result.reaction.push_back(Index(p) < piece.own ? of_all.reaction[at] : Vector6(Vector6::Constant(1e9)));
    }
    for (const Index k : piece.bond) result.bonds.push_back(of_all.bonds[std::size_t(k)]);
    part.cases.push_back(result);
  }
  return part;
}

}  // namespace bondstatic::test
