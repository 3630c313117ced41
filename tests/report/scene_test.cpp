#include "report/scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "bondstatic/error.hpp"
#include "report/grids.hpp"
#include "report/unpacked.hpp"

namespace bondstatic {
namespace {

using test::ScratchFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

/// What read_scene() gives, with its blocks.
struct Read {
  Blocks blocks;
  std::vector<std::string> notes;
  std::vector<PagePlot> plots;
  std::optional<PageScene> scene;

  explicit Read(const std::vector<SceneState>& states, const SceneLimits& limits = {}, bool si = true)
      : scene(read_scene(states, si, limits, blocks, notes, plots)) {}

  std::vector<double> of_particles(const std::string& column, std::size_t state = 0) const {
    return numbers(scene->particle_columns, scene->states.at(state).particle, column);
  }
  std::vector<double> of_bonds(const std::string& column, std::size_t state = 0) const {
    return numbers(scene->bond_columns, scene->states.at(state).bond, column);
  }

 private:
  std::vector<double> numbers(const std::vector<PageColumn>& columns, const std::vector<BlockRef>& refs,
                              const std::string& name) const {
    EXPECT_EQ(columns.size(), refs.size());
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (columns[i].name == name) return test::numbers_of(blocks, refs[i]);
    ADD_FAILURE() << "no column " << name;
    return {};
  }
};

struct Scene : testing::Test {
  const ScratchFolder scratch;
  const test::Whole whole = test::whole_answer({"push", "pull"});

  std::string file(std::size_t load_case, const std::vector<Column>& more_of_bonds = {}) const {
    return test::write_grid_file(scratch, "case" + std::to_string(load_case), whole.model,
                                 whole.solution.cases[load_case], more_of_bonds);
  }
  std::vector<SceneState> both() const {
    return {{{file(0)}, "push", "push", {}}, {{file(1)}, "pull", "pull", {}}};
  }
};

constexpr double single = 0x1p-23;  // of positions and answers below 2

TEST_F(Scene, HasEveryParticleAndBondWithItsNumbers) {
  const Read read(both());
  const PageScene& scene = *read.scene;
  const auto particles = whole.model.particles.size(), bonds = whole.model.bonds.size();
  EXPECT_EQ(scene.all_particles, Index(particles));
  EXPECT_EQ(scene.drawn_particles, Index(particles));
  EXPECT_EQ(scene.all_bonds, Index(bonds));
  EXPECT_THAT(read.notes, IsEmpty());
  EXPECT_EQ(scene.length_unit, "m");

  std::map<Index, std::size_t> particle_of, bond_of;
  for (std::size_t p = 0; p < particles; ++p) particle_of[whole.model.particles[p].id] = p;
  for (std::size_t k = 0; k < bonds; ++k) bond_of[whole.model.bonds[k].id] = k;
  const auto ids = test::ids_of(read.blocks, scene.particle_id),
             bond_ids = test::ids_of(read.blocks, scene.bond_id);
  EXPECT_EQ(std::set<Index>(ids.begin(), ids.end()).size(), particles);
  EXPECT_EQ(std::set<Index>(bond_ids.begin(), bond_ids.end()).size(), bonds);
  EXPECT_FALSE(std::is_sorted(ids.rbegin(), ids.rend()));

  const auto position = test::numbers_of(read.blocks, scene.position),
             radius = test::numbers_of(read.blocks, scene.radius);
  const auto turned = read.of_particles("rotation", 1);
  for (std::size_t row = 0; row < particles; ++row) {
    const std::size_t p = particle_of.at(ids[row]);
    const Particle& particle = whole.model.particles[p];
    EXPECT_NEAR(radius[row], particle.radius, single);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(position[3 * row + i] + scene.origin[Index(i)], particle.position[Index(i)], 4 * single);
      EXPECT_NEAR(turned[3 * row + i], whole.solution.cases[1].displacement[p][Index(3 + i)], single);
    }
  }
  const auto a = test::rows_of(read.blocks, scene.bond_a), b = test::rows_of(read.blocks, scene.bond_b);
  const auto force = read.of_bonds("normal_force", 0);
  for (std::size_t row = 0; row < bonds; ++row) {
    const std::size_t k = bond_of.at(bond_ids[row]);
    const Bond& bond = whole.model.bonds[k];
    EXPECT_EQ(ids[a[row]], whole.model.particles[std::size_t(bond.a)].id);
    EXPECT_EQ(ids[b[row]], whole.model.particles[std::size_t(bond.b)].id);
    const double expected = whole.solution.cases[0].bonds[k].normal_force;
    EXPECT_EQ(std::isnan(force[row]), std::isnan(expected));
    if (!std::isnan(expected)) {
      EXPECT_NEAR(force[row], expected, single);
    }
  }
}

TEST_F(Scene, OfPiecesIsThatOfOneFile) {
  const Read one({{{file(0)}, "", "", {}}});
  for (const int ranks : {2, 3}) {
    const Read many(
        {{test::write_grid_pieces(scratch, "pieces" + std::to_string(ranks), whole, ranks), "", "", {}}});
    EXPECT_EQ(many.scene->all_particles, one.scene->all_particles);
    EXPECT_EQ(many.scene->origin, one.scene->origin);
    EXPECT_EQ(many.blocks.texts(), one.blocks.texts());
  }
}

TEST_F(Scene, SamplesAreFoundByIdsAndSaid) {
  SceneLimits limits;
  limits.particles = 20;
  limits.sampled_particles = 10;
  limits.sampled_bonds = 30;
  const Read all(both()), read(both(), limits);
  const PageScene& scene = *read.scene;
  EXPECT_EQ(scene.drawn_particles, 10);
  EXPECT_EQ(scene.bond_a.count, 30);
  EXPECT_GT(scene.particle_id.count, 10);  // far ends
  ASSERT_EQ(read.notes.size(), 1u);
  EXPECT_THAT(read.notes[0],
              HasSubstr("10 of 64 particles and 30 of " + std::to_string(whole.model.bonds.size())));

  // The first rows of the whole scene.
  const auto ids = test::ids_of(read.blocks, scene.particle_id),
             all_ids = test::ids_of(all.blocks, all.scene->particle_id);
  EXPECT_TRUE(std::equal(ids.begin(), ids.begin() + 10, all_ids.begin()));
  EXPECT_EQ(std::set<Index>(ids.begin(), ids.end()).size(), ids.size());
  const auto bond_ids = test::ids_of(read.blocks, scene.bond_id),
             all_bonds = test::ids_of(all.blocks, all.scene->bond_id);
  EXPECT_TRUE(std::equal(bond_ids.begin(), bond_ids.end(), all_bonds.begin()));
  // Bonds end at their particles, which go where these go.
  const auto a = test::rows_of(read.blocks, scene.bond_a),
             all_a = test::rows_of(all.blocks, all.scene->bond_a);
  const auto u = read.of_particles("displacement", 1), all_u = all.of_particles("displacement", 1);
  const auto turned = read.of_particles("rotation", 1);
  for (std::size_t row = 0; row < 30; ++row) {
    EXPECT_EQ(ids[a[row]], all_ids[all_a[row]]);
    EXPECT_EQ(u[3 * a[row]], all_u[3 * all_a[row]]);
    EXPECT_EQ(std::isnan(turned[3 * a[row]]), a[row] >= 10);
  }
  // Plots are of all bonds.
  EXPECT_EQ(read.plots.size(), all.plots.size());
  EXPECT_EQ(read.plots.at(0).series.at(0).y, all.plots.at(0).series.at(0).y);
}

TEST_F(Scene, ImagesAcrossAFaceAreFarEnds) {
  Model model;
  for (int i = 0; i < 3; ++i) test::add_particle(model, Vector3(2.0 * i, 0, 0), 1);
  model.blocks = {test::block("generic", {{"kn", 1}, {"ks", 1}, {"kt", 1}, {"kb", 1}})};
  for (Index k = 0; k < 2; ++k) test::add_bond(model, k, k + 1);
  model.cell = Cell{Vector3(-1, -1, -1), Vector3(6, 2, 2).asDiagonal()};
  model.bonds.push_back({3, 2, 0, Vector3(2, 0, 0), 0, 2});
  State state;
  state.displacement.assign(3, Vector6::Ones());
  state.reaction.assign(3, Vector6::Zero());
  state.bonds.resize(3);
  state.strain(0, 0) = 0.5;
  const Read read({{{test::write_grid_file(scratch, "out", model, state)}, "", "", {}}});
  EXPECT_EQ(read.scene->all_particles, 3);
  EXPECT_EQ(read.scene->drawn_particles, 3);
  const auto ids = test::ids_of(read.blocks, read.scene->particle_id);
  ASSERT_EQ(ids.size(), 4u);
  EXPECT_EQ(ids[3], 1);
  EXPECT_EQ(test::numbers_of(read.blocks, read.scene->position)[9] + read.scene->origin.x(), 6);
  EXPECT_EQ(read.of_particles("displacement")[9], 4);  // 1 + 0.5 * 6
  const auto b = test::rows_of(read.blocks, read.scene->bond_b);
  EXPECT_EQ(std::count(b.begin(), b.end(), 3u), 1);
}

TEST_F(Scene, ColumnsOfAllStatesAreThere) {
  const std::vector<Column> of_bonds{{"break_step", std::vector<Index>(whole.model.bonds.size(), 7)}};
  const Read read({{{file(0)}, "", "", 0}, {{file(1, of_bonds)}, "", "", 7}});
  const auto& columns = read.scene->bond_columns;
  const auto found =
      std::find_if(columns.begin(), columns.end(), [](const auto& c) { return c.name == "break_step"; });
  ASSERT_NE(found, columns.end());
  EXPECT_TRUE(found->is_whole);
  EXPECT_FALSE(found->is_signed);
  const auto at = std::size_t(found - columns.begin());
  EXPECT_EQ(read.scene->states[0].bond.at(at).block, -1);
  EXPECT_EQ(read.of_bonds("break_step", 1), std::vector<double>(whole.model.bonds.size(), 7));
  EXPECT_EQ(read.scene->states[1].step, 7);
}

TEST_F(Scene, WhatIsTheSameInAllStatesIsStoredOnce) {
  const Read read({{{file(0)}, "", "", 0}, {{file(0)}, "", "", 1}});
  for (std::size_t i = 0; i < read.scene->particle_columns.size(); ++i)
    EXPECT_EQ(read.scene->states[0].particle[i].block, read.scene->states[1].particle[i].block);
  EXPECT_EQ(read.blocks.size(), Read({{{file(0)}, "", "", 0}}).blocks.size());
}

TEST_F(Scene, ColumnsSayWhatTheyAre) {
  const Read si({{{file(0)}, "", "", {}}}), plain({{{file(0)}, "", "", {}}}, {}, false);
  std::map<std::string, PageColumn> columns;
  for (const PageColumn& column : si.scene->particle_columns) columns[column.name] = column;
  EXPECT_EQ(columns.at("displacement").unit, "m");
  EXPECT_EQ(columns.at("displacement").components, 3);
  EXPECT_EQ(columns.at("reaction_force").unit, "N");
  EXPECT_EQ(columns.at("applied_moment").unit, "N m");
  EXPECT_TRUE(columns.at("fixed").is_whole);
  EXPECT_FALSE(columns.contains("id"));
  columns.clear();
  for (const PageColumn& column : si.scene->bond_columns) columns[column.name] = column;
  EXPECT_EQ(columns.at("normal_force").unit, "N");
  EXPECT_TRUE(columns.at("normal_force").is_signed);
  EXPECT_FALSE(columns.at("shear_force").is_signed);
  EXPECT_EQ(columns.at("mx").unit, "N m");
  EXPECT_EQ(columns.at("sigma").unit, "Pa");
  EXPECT_EQ(columns.at("energy").unit, "J");
  EXPECT_EQ(columns.at("radius").unit, "m");
  for (const char* name : {"id", "a", "b"}) EXPECT_FALSE(columns.contains(name));
  EXPECT_EQ(plain.scene->length_unit, "");
  for (const PageColumn& column : plain.scene->bond_columns) EXPECT_EQ(column.unit, "") << column.name;
}

TEST_F(Scene, RadiusOfSectionsIsThereWhereTheyHaveOne) {
  EXPECT_GE(Read({{{file(0)}, "", "", {}}}).scene->bond_radius.block, 0);
  Model springs = whole.model;
  springs.blocks = {test::block("generic", {{"kn", 1}, {"ks", 1}, {"kt", 1}, {"kb", 1}})};
  for (Bond& bond : springs.bonds) bond.block = 0;
  const Read read(
      {{{test::write_grid_file(scratch, "springs", springs, whole.solution.cases[1])}, "", "", {}}});
  EXPECT_EQ(read.scene->bond_radius.block, -1);
  for (const PageColumn& column : read.scene->bond_columns) EXPECT_NE(column.name, "radius");
}

TEST_F(Scene, OfTooManyStatesAreEvenlySpaced) {
  std::vector<SceneState> states;
  const std::vector<std::string> files{file(0)};
  for (int step = 0; step < 11; ++step) states.push_back({files, "", std::to_string(step), double(step)});
  SceneLimits limits;
  const Read one({states[0]});
  double numbers = 0;
  for (const auto* of : {&one.scene->states[0].particle, &one.scene->states[0].bond})
    for (const BlockRef& ref : *of) numbers += double(ref.count);
  limits.numbers = Index(3.5 * numbers);
  const Read three(states, limits);
  ASSERT_EQ(three.scene->states.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(three.scene->states[i].step, 5.0 * double(i));
  ASSERT_EQ(three.notes.size(), 1u);
  EXPECT_THAT(three.notes[0], HasSubstr("3 of 11 states"));
  limits.numbers = 1;
  EXPECT_EQ(Read(states, limits).scene->states.size(), 2u);
  limits.numbers = Index(11.5 * numbers);
  EXPECT_THAT(Read(states, limits).notes, IsEmpty());
}

TEST_F(Scene, OfTooManyStatesEachLoadCaseHasItsLast) {
  std::vector<SceneState> states;
  const std::vector<std::string> files{file(0)};
  for (const auto& [name, count] : {std::pair{"one", 1}, std::pair{"nine", 9}, std::pair{"five", 5}})
    for (int step = 0; step < count; ++step) states.push_back({files, name, "", double(step)});
  SceneLimits limits;
  const Read all(states);
  double numbers = 0;
  for (const auto* of : {&all.scene->states[0].particle, &all.scene->states[0].bond})
    for (const BlockRef& ref : *of) numbers += double(ref.count);
  const auto shown = [&](double room) {
    limits.numbers = Index(room * numbers);
    std::vector<std::pair<std::string, double>> found;
    const Read read(states, limits);
    for (const PageState& state : read.scene->states) found.emplace_back(state.load_case, *state.step);
    return found;
  };
  EXPECT_THAT(shown(15.5), testing::SizeIs(15));
  EXPECT_THAT(shown(14.5), testing::SizeIs(13)) << "never more than there is room for";
  EXPECT_THAT(shown(9.5),
              ElementsAre(Pair("one", 0), Pair("nine", 0), Pair("nine", 2), Pair("nine", 4), Pair("nine", 6),
                          Pair("nine", 8), Pair("five", 0), Pair("five", 2), Pair("five", 4)));
  EXPECT_THAT(shown(3.5), ElementsAre(Pair("one", 0), Pair("nine", 8), Pair("five", 4)));
  EXPECT_THAT(shown(2.5), ElementsAre(Pair("one", 0), Pair("five", 4)));
}

TEST_F(Scene, StatesOfAnotherModelAreRefused) {
  test::Whole other = whole;
  other.model.particles[7].id = 5000;
  const std::string file_of_other =
      test::write_grid_file(scratch, "other", other.model, other.solution.cases[0]);
  try {
    Read({{{file(0)}, "", "", {}}, {{file_of_other}, "", "", {}}});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::invalid_input);
    EXPECT_THAT(error.what(), HasSubstr(file_of_other + ": is of another model than " + file(0)));
  }
}

TEST_F(Scene, NegativeIdsAreRefused) {
  test::Whole damaged = whole;
  damaged.model.particles[7].id = -2;
  const std::vector<SceneState> states{
      {{test::write_grid_file(scratch, "damaged", damaged.model, damaged.solution.cases[0])}, "", "", {}}};
  EXPECT_THROW(Read{states}, Error);
}

TEST_F(Scene, OfNothingIsNone) {
  EXPECT_FALSE(Read({}).scene);
  EXPECT_FALSE(Read({{{test::write_grid_file(scratch, "none", {}, {})}, "", "", {}}}).scene);
}

TEST_F(Scene, ForcesArePlottedForEveryLoadCaseAndDirectionsOnce) {
  const Read read(both());
  std::vector<std::string> titles;
  for (const PagePlot& plot : read.plots) titles.push_back(plot.title);
  EXPECT_EQ(std::count(titles.begin(), titles.end(), "Normal forces of bonds, load case push"), 1);
  EXPECT_EQ(std::count(titles.begin(), titles.end(), "Normal forces of bonds, load case pull"), 1);
  EXPECT_EQ(std::count(titles.begin(), titles.end(), "Directions of bonds, xy plane"), 1);
  std::vector<SceneState> many;
  for (int i = 0; i < 6; ++i) many.push_back({{file(0)}, std::to_string(i), "", {}});
  EXPECT_THAT(Read(many).notes, ElementsAre(HasSubstr("first 4 of 6 load cases")));
}

}  // namespace
}  // namespace bondstatic
