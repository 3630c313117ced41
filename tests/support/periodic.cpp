#include "support/periodic.hpp"

#include "model/bond_formation.hpp"
#include "model/hold_cell.hpp"
#include "support/models.hpp"

namespace bondstatic::test {

namespace {

void add_unit_strains(Model& model) {
  model.load_cases.clear();
  for (const UnitStrain& unit : unit_strains()) {
    model.strains.push_back({unit.value, Index(model.load_cases.size())});
    model.load_cases.push_back(unit.name);
  }
}

}  // namespace

Model periodic_model(const std::vector<Vector3>& points, const std::vector<double>& radii, const Cell& cell,
                     const BondBlock& block, double contact_radius_factor) {
  Model model;
  model.cell = cell;
  model.blocks.push_back(block);
  for (std::size_t p = 0; p < points.size(); ++p) add_particle(model, points[p], radii[p]);
  for (const BondedImage& bond : bonded_images(model.particles, cell, {0, contact_radius_factor})) {
    add_bond(model, bond.a, bond.b);
    model.bonds.back().branch += shift_of(cell, bond.image);
  }
  hold_translation(model);
  add_unit_strains(model);
  return model;
}

Model periodic_packing(std::mt19937_64& random, int edge, const BondBlock& block) {
  std::uniform_real_distribution<double> jitter(-0.15, 0.15), radius(0.4, 0.55);
  std::vector<Vector3> points;
  std::vector<double> radii;
  for (int x = 0; x < edge; ++x)
    for (int y = 0; y < edge; ++y)
      for (int z = 0; z < edge; ++z) {
        points.push_back(Vector3(x, y, z) + Vector3(jitter(random), jitter(random), jitter(random)));
        radii.push_back(radius(random));
      }
  return periodic_model(points, radii, {{0, 0, 0}, double(edge) * Matrix3::Identity()}, block, 1.4);
}

Model repeated(const Model& model, const std::array<int, 3>& times) {
  std::vector<Vector3> points;
  std::vector<double> radii;
  Cell cell = *model.cell;
  for (int x = 0; x < times[0]; ++x)
    for (int y = 0; y < times[1]; ++y)
      for (int z = 0; z < times[2]; ++z)
        for (const Particle& particle : model.particles) {
          points.push_back(particle.position + shift_of(*model.cell, {x, y, z}));
          radii.push_back(particle.radius);
        }
  for (int i = 0; i < 3; ++i) cell.edges.col(i) *= times[std::size_t(i)];
  return periodic_model(points, radii, cell, model.blocks[0], 1.4);
}

Model turned(const Model& model, const Matrix3& rotation) {
  Model result = model;
  for (Particle& particle : result.particles) particle.position = rotation * particle.position;
  for (Bond& bond : result.bonds) bond.branch = rotation * bond.branch;
  result.cell->origin = rotation * model.cell->origin;
  result.cell->edges = rotation * model.cell->edges;
  return result;
}

Matrix6 turned_stiffness(const Matrix6& stiffness, const Matrix3& rotation) {
  // Stress turned forth of the stiffness on strain turned back.
  Matrix6 result;
  for (int c = 0; c < 6; ++c) {
    const Matrix3 strain = rotation.transpose() * unit_strains()[std::size_t(c)].value * rotation;
    const Vector6 s = stiffness * voigt_of_strain(strain);
    Matrix3 stress;
    stress << s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2];
    result.col(c) = voigt_of_stress(rotation * stress * rotation.transpose());
  }
  return result;
}

}  // namespace bondstatic::test
