#include "results/columns.hpp"

#include <algorithm>

#include "bond/bond_radii.hpp"
#include "model/boundary.hpp"
#include "results/quantities.hpp"

namespace bondstatic {

namespace {

/// Of each item what `value` makes of it; the items must outlive the column.
template <class Item, class Value>
Column column_of(const std::string& name, const std::vector<Item>& items, Value value) {
  using Number = decltype(value(items.front()));
  return {name, Index(items.size()),
          Column::Numbers<Number>([&items, value](Index i) { return value(items[std::size_t(i)]); })};
}

/// Three components of each particle's six, from `first`.
Column vectors(const std::string& name, const std::vector<Vector6>& of, int first) {
  return {name, 3 * Index(of.size()),
          Column::Numbers<double>([&of, first](Index i) { return of[std::size_t(i / 3)][first + i % 3]; }),
          3};
}

Column particle_ids(const Model& model) {
  return column_of("id", model.particles, [](const Particle& particle) { return particle.id; });
}

Index load_case_of(const Model& model, const State& state) {
  const auto found = std::find(model.load_cases.begin(), model.load_cases.end(), state.name);
  return found == model.load_cases.end() ? every_case : Index(found - model.load_cases.begin());
}

/// Three components of each particle's load, from `first`.
Column loads(const std::string& name, const std::shared_ptr<const Boundary>& boundary, int first) {
  return {name, 3 * Index(boundary->load.size()), Column::Numbers<double>([boundary, first](Index i) {
            return boundary->load[std::size_t(i / 3)][first + i % 3];
          }),
          3};
}

}  // namespace

std::vector<Column> particle_columns(const Model& model, const State& result) {
  const Index count = Index(model.particles.size());
  std::vector<Column> columns{particle_ids(model)};
  for (const ParticleQuantity& quantity : particle_quantities()) {
    if (!quantity.column) continue;
    columns.push_back({quantity.name, count, Column::Numbers<double>([&, of = quantity.of](Index i) {
                         const auto p = std::size_t(i);
                         return of({model.particles[p], result.displacement[p], result.reaction[p]});
                       })});
  }
  return columns;
}

std::vector<Column> bond_ends(const Model& model) {
  // Ids alone stay in the cache where particles would not.
  const auto ids = std::make_shared<std::vector<Index>>();
  for (const Particle& particle : model.particles) ids->push_back(particle.id);
  const auto id_of = [ids](Index particle) { return (*ids)[std::size_t(particle)]; };
  return {column_of("id", model.bonds, [](const Bond& bond) { return bond.id; }),
          column_of("a", model.bonds, [id_of](const Bond& bond) { return id_of(bond.a); }),
          column_of("b", model.bonds, [id_of](const Bond& bond) { return id_of(bond.b); })};
}

std::vector<Column> bond_columns(const Model& model, const State& result) {
  std::vector<Column> columns = bond_ends(model);
  for (const BondQuantity& quantity : bond_quantities())
    columns.push_back(column_of(quantity.name, result.bonds, quantity.of));
  return columns;
}

std::vector<Column> point_data(const Model& model, const State& result) {
  Boundary found = boundary_of(model, load_case_of(model, result));
  found.prescribed = {};
  const auto boundary = std::make_shared<const Boundary>(std::move(found));
  const Column fixed("fixed", Index(boundary->free.size()), Column::Numbers<Index>([boundary](Index i) {
                       return Index(0x3f & ~boundary->free[std::size_t(i)]);
                     }));
  return {particle_ids(model),
          column_of("radius", model.particles, [](const Particle& particle) { return particle.radius; }),
          vectors("displacement", result.displacement, 0),
          vectors("rotation", result.displacement, 3),
          vectors("reaction_force", result.reaction, 0),
          vectors("reaction_moment", result.reaction, 3),
          fixed,
          loads("applied_force", boundary, 0),
          loads("applied_moment", boundary, 3)};
}

std::vector<Column> line_data(const Model& model, const State& result, int threads) {
  std::vector<Column> columns = bond_columns(model, result);
  columns.emplace_back("radius", bond_radii(model, threads));
  return columns;
}

}  // namespace bondstatic
