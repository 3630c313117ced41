#include "support/models.hpp"

#include <algorithm>
#include <stdexcept>

namespace bondstatic::test {

BondBlock block(const std::string& law_name, const Values& values, ContactPoint contact_point) {
  const BondLaw* law = find_bond_law(law_name);
  if (!law) throw std::logic_error("no law " + law_name);
  std::vector<double> given(law->parameters.size(), not_given);
  for (const auto& [name, value] : values) {
    const Index at = law->find(name);
    if (at < 0) throw std::logic_error(law_name + " has no parameter " + name);
    given[std::size_t(at)] = value;
  }
  std::vector<std::string> complaints;
  BondBlock result{law_name, complete_parameters(*law, given, complaints), contact_point, {}};
  if (!complaints.empty()) throw std::logic_error(complaints.front());
  return result;
}

Index add_particle(Model& model, const Vector3& position, double radius) {
  const Index at = Index(model.particles.size());
  model.particles.push_back({at + 1, position, radius, not_given});
  return at;
}

void add_bond(Model& model, Index a, Index b, Index block) {
  Index in_block = 0;
  const auto last = std::find_if(model.bonds.rbegin(), model.bonds.rend(),
                                 [block](const Bond& bond) { return bond.block == block; });
  if (last != model.bonds.rend()) in_block = last->in_block + 1;
  model.bonds.push_back({Index(model.bonds.size()) + 1, a, b,
                         model.particles[std::size_t(b)].position - model.particles[std::size_t(a)].position,
                         block, in_block});
}

void bond_within(Model& model, double reach) {
  const Index count = Index(model.particles.size());
  for (Index a = 0; a < count; ++a)
    for (Index b = a + 1; b < count; ++b)
      if ((model.particles[std::size_t(b)].position - model.particles[std::size_t(a)].position).norm() <
          reach)
        add_bond(model, a, b);
}

void fix_all(Model& model, Index particle, const Vector6& value) {
  model.supports.push_back({particle, {true, true, true, true, true, true}, value, every_case});
}

void load(Model& model, Index particle, const Vector6& force, Index load_case) {
  model.loads.push_back({particle, force, load_case});
}

Model chain(const BondBlock& block, const Vector3& from, const Vector3& to, Index bonds, double radius) {
  Model model;
  model.blocks.push_back(block);
  for (Index i = 0; i <= bonds; ++i)
    add_particle(model, from + double(i) / double(bonds) * (to - from), radius);
  for (Index i = 0; i < bonds; ++i)
    model.bonds.push_back(
        {i + 1, i, i + 1,
         model.particles[std::size_t(i) + 1].position - model.particles[std::size_t(i)].position, 0, i});
  fix_all(model, 0);
  return model;
}

Model random_packing(std::mt19937_64& random, int edge, const BondBlock& law_block, double smallest) {
  std::uniform_real_distribution<double> jitter(-0.15, 0.15), radius(smallest, 2 * smallest);
  Model model;
  model.blocks = {law_block, block("timoshenko", {{"young", 1e9}, {"poisson", 0.2}, {"radius_factor", 0.7}})};
  for (int x = 0; x < edge; ++x)
    for (int y = 0; y < edge; ++y)
      for (int z = 0; z < edge; ++z) {
        const Vector3 shift(jitter(random), jitter(random), jitter(random));
        add_particle(model, Vector3(x, y, z) + shift, radius(random));
      }
  const BondLaw& law = *find_bond_law(law_block.law);
  const BondProperties sample = law.evaluate({1.0, 0.3, 0.3, 1, 2}, law_block.parameters);
  const bool complete = sample.stiffness.full_rank() && sample.moments_fed_back;
  const Index count = Index(model.particles.size()), e = edge;
  for (Index a = 0; a < count; ++a)
    for (Index b = a + 1; b < count; ++b) {
      const double distance =
          (model.particles[std::size_t(b)].position - model.particles[std::size_t(a)].position).norm();
      const Index apart = b - a;
      const bool lattice =
          (apart == 1 && b % e != 0) || (apart == e && (a / e) % e != e - 1) || apart == e * e;
      if (lattice || distance < 1.3) add_bond(model, a, b, lattice && !complete ? 1 : 0);
    }
  return model;
}

Vector6 vector6(double x, double y, double z, double rx, double ry, double rz) {
  Vector6 v;
  v << x, y, z, rx, ry, rz;
  return v;
}

}  // namespace bondstatic::test
