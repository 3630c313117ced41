// What model.vtu says of supports, loads and sections, read back by VTK.
#include "results/grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "io/file_set.hpp"
#include "io/read_by_vtk.hpp"
#include "io/scratch_folder.hpp"
#include "support/models.hpp"

namespace bondstatic {
namespace {

using test::vector6;
using testing::ElementsAre;

/// Four particles in a row with bonds that have a section, have none, and have one of their own.
Model row() {
  Model model;
  for (int i = 0; i < 4; ++i) test::add_particle(model, Vector3(2.0 * i, 0, 0), 1);
  model.blocks = {
      test::block("timoshenko", {{"young", 1}, {"poisson", 0.25}, {"radius_factor", 0.5}}),
      test::block("generic", {{"kn", 1}, {"ks", 1}, {"kt", 1}, {"kb", 1}}),
      test::block(
          "edem-v2",
          {{"normal_stiffness", 1}, {"shear_stiffness", 1}, {"disk_scale", 0.75}, {"torque_feedback", 1}})};
  for (Index k = 0; k < 3; ++k) test::add_bond(model, k, k + 1, k);
  model.load_cases = {"push", "turn"};
  test::fix_all(model, 0);
  Support slides;
  slides.particle = 3;
  slides.fixed = {false, true, false, false, false, true};
  slides.load_case = 1;
  model.supports.push_back(slides);
  test::load(model, 1, vector6(1, 2, 3, 4, 5, 6));
  test::load(model, 1, vector6(10, 0, 0, 0, 0, 10), 0);
  test::load(model, 2, vector6(0, 0, 7), 1);
  return model;
}

State at_rest(const Model& model, const std::string& load_case) {
  State state;
  state.name = load_case;
  state.displacement.assign(model.particles.size(), Vector6::Zero());
  state.reaction = state.displacement;
  state.bonds.resize(model.bonds.size());
  return state;
}

std::map<std::string, std::string> grid_of(const Model& model, const State& state) {
  const test::ScratchFolder scratch;
  FileSet files(scratch / "out");
  write_grid(files.create("model.vtu"), model, state);
  files.commit();
  return test::read_by_vtk((scratch / "out/model.vtu").string(), scratch);
}

/// The numbers of an array, behind its number of components.
std::vector<double> numbers(const std::string& text) {
  std::istringstream words(text);
  std::vector<double> values;
  for (std::string word; words >> word;) values.push_back(std::strtod(word.c_str(), nullptr));
  return values;
}

TEST(Grid, HasSupportsAndLoadsOfItsLoadCase) {
  const Model model = row();
  auto push = grid_of(model, at_rest(model, "push"));
  EXPECT_EQ(push["array point fixed"], "1 63 0 0 0");
  EXPECT_THAT(numbers(push["array point applied_force"]),
              ElementsAre(3, 0, 0, 0, 11, 2, 3, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT(numbers(push["array point applied_moment"]),
              ElementsAre(3, 0, 0, 0, 4, 5, 16, 0, 0, 0, 0, 0, 0));
  auto turn = grid_of(model, at_rest(model, "turn"));
  EXPECT_EQ(turn["array point fixed"], "1 63 0 0 34");
  EXPECT_THAT(numbers(turn["array point applied_force"]), ElementsAre(3, 0, 0, 0, 1, 2, 3, 0, 0, 7, 0, 0, 0));
}

TEST(Grid, OfAStateWithoutLoadCaseHasWhatAllOfThemShare) {
  const Model model = row();
  auto found = grid_of(model, at_rest(model, "no such case"));
  EXPECT_EQ(found["array point fixed"], "1 63 0 0 0");
  EXPECT_THAT(numbers(found["array point applied_force"]),
              ElementsAre(3, 0, 0, 0, 1, 2, 3, 0, 0, 0, 0, 0, 0));
}

TEST(Grid, HasTheRadiusOfEachBondsSection) {
  const Model model = row();
  EXPECT_EQ(grid_of(model, at_rest(model, "push"))["array cell radius"],
            "1 0x1.0000000000000p-1 nan 0x1.8000000000000p-1");
}

TEST(Grid, ImagesAcrossAPeriodicFaceCarryTheLoadsOfTheirParticle) {
  Model model = row();
  model.cell = Cell{Vector3(-1, -1, -1), Vector3(8, 2, 2).asDiagonal()};
  model.bonds.push_back({4, 3, 0, Vector3(2, 0, 0), 1, 1});
  test::load(model, 0, vector6(0, 5, 0));
  auto found = grid_of(model, at_rest(model, "push"));
  EXPECT_EQ(found["array point vtkGhostType"], "1 0 0 0 0 1");
  EXPECT_EQ(found["array point fixed"], "1 63 0 0 0 63");
  EXPECT_THAT(numbers(found["array point applied_force"]),
              ElementsAre(3, 0, 5, 0, 11, 2, 3, 0, 0, 0, 0, 0, 0, 0, 5, 0));
}

}  // namespace
}  // namespace bondstatic
