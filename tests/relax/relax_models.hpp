// Models small enough to run to rest in a fraction of a second.
#pragma once

#include <cstring>

#include "bondstatic/relaxation.hpp"
#include "support/models.hpp"

namespace bondstatic::test {

inline StaticOptions one_thread() {
  StaticOptions options;
  options.threads = 1;
  options.yield_cores = false;
  return options;
}

inline RelaxOptions small_kinematics() {
  RelaxOptions options;
  options.kinematics = Kinematics::small;
  return options;
}

/// A skew cantilever with a load across its tip.
inline Model loaded_cantilever(Index bonds = 5) {
  Model model = chain(block("timoshenko", {{"young", 1e8}, {"poisson", 0.3}, {"radius", 0.15}}),
                      Vector3::Zero(), 0.5 * double(bonds) * Vector3(0.6, 0.64, 0.48), bonds, 0.2);
  for (Particle& particle : model.particles) particle.density = 2000;
  load(model, bonds, vector6(10, -20, 30, 1, 2, 3));
  return model;
}

/// A packing with a moved support beside held ones; its law is in every bond beyond the lattice neighbours.
inline Model loaded_packing(int edge, const BondBlock& law) {
  std::mt19937_64 random(41);
  Model model = random_packing(random, edge, law);
  std::uniform_real_distribution<double> density(2000, 3000);
  for (Particle& particle : model.particles) particle.density = density(random);
  for (Index p = 0; p < edge * edge; ++p) fix_all(model, p);
  const Index last = Index(model.particles.size()) - 1;
  load(model, last, vector6(1e4, -2e4, 3e4, 1e3, 2e3, 3e3));
  model.supports.push_back(
      {last - 1, {true, false, false, false, true, false}, vector6(1e-5, 0, 0, 0, 2e-5, 0), every_case});
  return model;
}

inline RelaxedCase relaxed(const Model& model, const RelaxOptions& options, const RelaxHooks& hooks = {}) {
  return relax(model, options, one_thread(), hooks).cases.at(0);
}

template <class Range>
bool same_bytes(const Range& a, const Range& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(*a.data())) == 0;
}

/// One after another: between results there may be bytes that mean nothing.
inline std::vector<double> numbers(const std::vector<BondResult>& bonds) {
  std::vector<double> all;
  for (const BondResult& b : bonds) {
    all.insert(all.end(), b.force.data(), b.force.data() + 6);
    all.insert(all.end(), {b.normal_force, b.shear_force, b.twisting_moment, b.bending_moment, b.sigma, b.tau,
                           b.energy});
  }
  return all;
}

/// Bit for bit, NaN included.
inline bool same_bits(const RelaxedCase& a, const RelaxedCase& b) {
  bool same = a.steps == b.steps && a.end == b.end && a.history.size() == b.history.size();
  same = same && std::memcmp(&a.energies, &b.energies, sizeof a.energies) == 0;
  same = same && a.unrest.fastest == b.unrest.fastest && a.unrest.unbalanced == b.unrest.unbalanced;
  same = same && same_bytes(a.state.displacement, b.state.displacement);
  same = same && same_bytes(a.state.reaction, b.state.reaction);
  same = same && same_bytes(numbers(a.state.bonds), numbers(b.state.bonds));
  for (std::size_t c = 0; same && c < a.history.size(); ++c)
    same = a.history[c].name == b.history[c].name && same_bytes(a.history[c].values, b.history[c].values);
  return same;
}

inline const std::vector<double>& column(const RelaxedCase& of, const std::string& name) {
  for (const HistoryColumn& c : of.history)
    if (c.name == name) return c.values;
  throw std::logic_error("no column " + name);
}

}  // namespace bondstatic::test
