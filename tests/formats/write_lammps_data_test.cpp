// A model as a LAMMPS data file and back, to the last digit.
#include <gmock/gmock.h>

#include "formats/export_models.hpp"
#include "formats/readers.hpp"
#include "formats/write/lammps_box.hpp"

namespace bondstatic::test {
namespace {

using testing::HasSubstr;

ForeignModel read_back(const std::string& path) {
  std::vector<Fault> faults;
  const auto found = read_foreign_model(path, {}, {}, faults);
  for (const Fault& fault : faults) ADD_FAILURE() << to_string(fault);
  return found.value_or(ForeignModel{});
}

TEST(LammpsDataRoundTrip, GivesParticlesAndBondsToTheLastBit) {
  const Model model = mixed_model();
  const Exported exported(model, "lammps");
  const ForeignModel back = read_back(exported.path("model.data"));
  ASSERT_EQ(back.particles.size(), model.particles.size());
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    EXPECT_EQ(back.particles[p].id, model.particles[p].id);
    EXPECT_EQ(back.particles[p].position, model.particles[p].position);
    EXPECT_EQ(back.particles[p].radius, model.particles[p].radius);
    EXPECT_EQ(back.particles[p].density, model.particles[p].density);
  }
  ASSERT_EQ(back.bonds.size(), model.bonds.size());
  ASSERT_EQ(back.bond_columns.count("kb"), 1u);
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    const Bond& bond = model.bonds[k];
    EXPECT_EQ(back.bonds[k].a, model.particles[std::size_t(bond.a)].id);
    EXPECT_EQ(back.bonds[k].b, model.particles[std::size_t(bond.b)].id);
    EXPECT_EQ(back.bond_columns.at("kn")[k], exported.properties[k].stiffness.kn);
    EXPECT_EQ(back.bond_columns.at("ks")[k], exported.properties[k].stiffness.ks);
    EXPECT_EQ(back.bond_columns.at("kt")[k], exported.properties[k].stiffness.kt);
    EXPECT_EQ(back.bond_columns.at("kb")[k], exported.properties[k].stiffness.kb);
  }
}

TEST(LammpsDataRoundTrip, KeepsThatNumbersAreSi) {
  const Model model = mixed_model();
  EXPECT_FALSE(read_back(Exported(model, "lammps").path("model.data")).si);
  EXPECT_TRUE(read_back(Exported(model, "lammps", false, true).path("model.data")).si);
}

TEST(LammpsDataRoundTrip, ShiftsIdsThatBeginAtZeroAndSaysSo) {
  Model model = mixed_model();
  for (Particle& particle : model.particles) particle.id -= 1;
  const Exported exported(model, "lammps");
  EXPECT_THAT(joined(exported.notes.remarks), HasSubstr("begin at 1"));
  const ForeignModel back = read_back(exported.path("model.data"));
  ASSERT_EQ(back.particles.size(), model.particles.size());
  EXPECT_EQ(back.particles.front().id, model.particles.front().id + 1);
}

TEST(LammpsDataRoundTrip, KeepsAnObliquePeriodicCell) {
  Model model = mixed_model();
  Cell cell;
  cell.origin = Vector3(-0.5, -0.5, -0.5);
  cell.edges << 8, 1, 0.5, 0, 8, 0.25, 0, 0, 8;
  cell.periodic = {true, true, false};
  model.cell = cell;
  const Exported exported(model, "lammps");
  const ForeignModel back = read_back(exported.path("model.data"));
  ASSERT_TRUE(back.cell.has_value());
  EXPECT_EQ(back.cell->periodic, cell.periodic);
  EXPECT_EQ(back.cell->edges.col(0), cell.edges.col(0));
  EXPECT_EQ(back.cell->edges.col(1), cell.edges.col(1));
  EXPECT_EQ(back.cell->origin.head<2>() - (back.cell->origin[2] + 0.5) / 8 * cell.edges.col(2).head<2>(),
            cell.origin.head<2>());
}

TEST(LammpsDataRoundTrip, KeepsACellThatIsPeriodicInAllDirections) {
  Model model = mixed_model();
  Cell cell;
  cell.origin = Vector3(-0.5, -0.5, -0.5);
  cell.edges << 8, -1, 0.5, 0, 8, 0.25, 0, 0, 8;
  model.cell = cell;
  const ForeignModel back = read_back(Exported(model, "lammps").path("model.data"));
  ASSERT_TRUE(back.cell.has_value());
  EXPECT_EQ(back.cell->periodic, cell.periodic);
  EXPECT_EQ(back.cell->edges, cell.edges);
  EXPECT_EQ(back.cell->origin, cell.origin);
}

TEST(LammpsBox, RefusesACellThatDoesNotLieAsLammpsWantsIt) {
  Cell cell;
  cell.edges << 0, 8, 0, 8, 0, 0, 0, 0, 8;
  try {
    lammps_box(cell, {Vector3::Zero()}, 1);
    FAIL() << "it was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_THAT(error.what(), HasSubstr("cure: turn the model"));
  }
}

TEST(LammpsBox, ReachesBeyondEveryParticleByTheMargin) {
  const LammpsBox box = lammps_box(std::nullopt, {Vector3(0, 0, 0), Vector3(1, 2, 3)}, 0.5);
  EXPECT_EQ(box.low, Vector3(-0.5, -0.5, -0.5));
  EXPECT_EQ(box.high, Vector3(1.5, 2.5, 3.5));
  EXPECT_EQ(box.boundary(), "f f f");
}

}  // namespace
}  // namespace bondstatic::test
