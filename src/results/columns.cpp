#include "results/columns.hpp"

#include "results/quantities.hpp"

namespace bondstatic {

namespace {

template <class Item, class Value>
auto collect(const std::vector<Item>& items, Value value) {
  std::vector<decltype(value(items.front()))> values;
  values.reserve(items.size());
  for (const Item& item : items) values.push_back(value(item));
  return values;
}

/// Three components of each particle's six, from `first`.
Column vectors(const std::string& name, const std::vector<Vector6>& of, int first) {
  std::vector<double> values;
  values.reserve(3 * of.size());
  for (const Vector6& v : of)
    for (int i = first; i < first + 3; ++i) values.push_back(v[i]);
  return {name, std::move(values), 3};
}

Column particle_ids(const Model& model) {
  return {"id", collect(model.particles, [](const Particle& particle) { return particle.id; })};
}

Index id_of(const Model& model, Index particle) {
  return model.particles[std::size_t(particle)].id;
}

}  // namespace

std::vector<Column> particle_columns(const Model& model, const State& result) {
  std::vector<Column> columns{particle_ids(model)};
  for (const ParticleQuantity& quantity : particle_quantities()) {
    if (!quantity.column) continue;
    std::vector<double> values(model.particles.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = quantity.of({model.particles[i], result.displacement[i], result.reaction[i]});
    columns.push_back({quantity.name, std::move(values)});
  }
  return columns;
}

std::vector<Column> bond_columns(const Model& model, const State& result) {
  std::vector<Column> columns{
      {"id", collect(model.bonds, [](const Bond& bond) { return bond.id; })},
      {"a", collect(model.bonds, [&](const Bond& bond) { return id_of(model, bond.a); })},
      {"b", collect(model.bonds, [&](const Bond& bond) { return id_of(model, bond.b); })}};
  for (const BondQuantity& quantity : bond_quantities())
    columns.push_back({quantity.name, collect(result.bonds, quantity.of)});
  return columns;
}

std::vector<Column> point_data(const Model& model, const State& result) {
  return {particle_ids(model),
          {"radius", collect(model.particles, [](const Particle& particle) { return particle.radius; })},
          vectors("displacement", result.displacement, 0),
          vectors("rotation", result.displacement, 3),
          vectors("reaction_force", result.reaction, 0),
          vectors("reaction_moment", result.reaction, 3)};
}

}  // namespace bondstatic
