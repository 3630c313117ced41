// The deck: every command as LAMMPS documents it, every number that of the model.
#include <gmock/gmock.h>

#include <map>

#include "bondstatic/error.hpp"
#include "formats/export_models.hpp"

namespace bondstatic::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

/// Arguments of a command behind its name, by what the LAMMPS manual says of it; fixes and computes by style.
const std::map<std::string, std::size_t>& documented() {
  static const std::map<std::string, std::size_t> counts{{"units", 1},
                                                         {"atom_style", 1},
                                                         {"boundary", 3},
                                                         {"newton", 2},
                                                         {"comm_modify", 4},
                                                         {"special_bonds", 8},
                                                         {"read_data", 2},
                                                         {"pair_style", 2},
                                                         {"pair_coeff", 2},
                                                         {"neighbor", 2},
                                                         {"neigh_modify", 6},
                                                         {"bond_style", 5},
                                                         {"bond_coeff", 13},
                                                         {"timestep", 1},
                                                         {"variable", 3},
                                                         {"thermo_style", 4},
                                                         {"thermo", 1},
                                                         {"thermo_modify", 3},
                                                         {"run", 1},
                                                         {"include", 1},
                                                         {"fix nve", 3},
                                                         {"fix nve/bpm/sphere", 3},
                                                         {"fix freeze", 3},
                                                         {"fix damping/cundall", 5},
                                                         {"fix addforce", 6},
                                                         {"fix setforce", 6},
                                                         {"fix addtorque/atom", 6},
                                                         {"fix settorque/atom", 6},
                                                         {"compute reduce", 5},
                                                         {"compute property/atom", 7},
                                                         {"compute property/local", 6},
                                                         {"compute bond/local", 7}};
  return counts;
}

void expect_documented(const std::string& deck) {
  for (const Words& line : command_lines(deck)) {
    std::string name = line[0];
    if (name == "group" || name == "dump" || name == "dump_modify" || name == "set") continue;  // lists
    if (name == "fix" || name == "compute") name += ' ' + line.at(3);
    const auto found = documented().find(name);
    ASSERT_NE(found, documented().end()) << name;
    EXPECT_EQ(line.size() - 1, found->second) << name;
  }
}

/// The lines of a command.
std::vector<Words> lines_of(const std::string& deck, const std::string& command) {
  std::vector<Words> out;
  for (const Words& line : command_lines(deck))
    if (line[0] == command) out.push_back(line);
  return out;
}

TEST(LammpsDeck, EveryCommandHasItsDocumentedArguments) {
  expect_documented(Exported(mixed_model(), "lammps").text("in.lammps"));
  expect_documented(Exported(mixed_model(), "lammps", true).text("in.lammps"));
}

TEST(LammpsDeck, OneBondTypeADistinctStiffnessToTheLastDigit) {
  const Model model = mixed_model();
  const Exported exported(model, "lammps");
  const std::vector<Words> types = lines_of(exported.text("in.lammps"), "bond_coeff");
  ASSERT_EQ(types.size(), 2u);
  const auto bonds =
      command_lines(exported.text("model.data").substr(exported.text("model.data").find("\nBonds")));
  ASSERT_EQ(bonds.size(), model.bonds.size() + 1);
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    const Words& type = types.at(std::stoul(bonds[k + 1][1]) - 1);
    const SectionStiffness& c = exported.properties[k].stiffness;
    EXPECT_EQ(std::stod(type[2]), c.kn);
    EXPECT_EQ(std::stod(type[3]), c.ks);
    EXPECT_EQ(std::stod(type[4]), c.kt);
    EXPECT_EQ(std::stod(type[5]), c.kb);
  }
}

TEST(LammpsDeck, SupportsAndLoadsBecomeGroupsAndFixes) {
  const std::string deck = Exported(mixed_model(), "lammps").text("in.lammps");
  const std::vector<Words> fixes = lines_of(deck, "fix");
  EXPECT_THAT(fixes, Contains(Words{"fix", "held", "held", "freeze"}));
  EXPECT_THAT(fixes, Contains(Words{"fix", "hold_yz", "hold_yz", "setforce", "NULL", "0.0", "0.0"}));
  EXPECT_THAT(deck, HasSubstr("addforce 2 -0.3333333333333333 -10"));
  EXPECT_THAT(deck, HasSubstr("addtorque/atom 0.1 0.2 0.2333333333333333"));
  EXPECT_THAT(deck, HasSubstr("December 2025"));
  // What a support takes must be taken after all else has been added.
  EXPECT_LT(deck.find("addforce"), deck.find("damping/cundall"));
  EXPECT_LT(deck.find("damping/cundall"), deck.find("setforce"));
}

TEST(LammpsDeck, HeldRotationsAreNotIntegratedOrHaveNoTorque) {
  Model model = mixed_model();
  Support all, one;
  all.particle = 15;
  all.fixed[3] = all.fixed[4] = all.fixed[5] = true;
  one.particle = 16;
  one.fixed[5] = true;
  model.supports.insert(model.supports.end(), {all, one});
  const std::vector<Words> fixes = lines_of(Exported(model, "lammps").text("in.lammps"), "fix");
  EXPECT_THAT(fixes, Contains(Words{"fix", "move_gliding", "gliding", "nve"}));
  EXPECT_THAT(fixes, Contains(Words{"fix", "hold_rz", "hold_rz", "settorque/atom", "NULL", "NULL", "0.0"}));
}

TEST(LammpsDeck, ManyDistinctLoadsGoToFiles) {
  Model model = mixed_model();
  for (Index p = 9; p < 27; ++p) load(model, p, vector6(0, 0.1 * double(p), 0));
  const Exported exported(model, "lammps");
  EXPECT_THAT(exported.text("in.lammps"), AllOf(HasSubstr("addforce v_load_fx v_load_fy v_load_fz"),
                                                HasSubstr("variable     load_fy atomfile load_fy.txt")));
  const auto lines = command_lines(exported.text("load_fy.txt"));
  ASSERT_EQ(lines.size(), 19u);
  EXPECT_EQ(lines[0], Words{"18"});
  EXPECT_EQ(lines[1][0], "10");
  EXPECT_EQ(std::stod(lines[1][1]), 0.1 * 9.0);
}

TEST(LammpsDeck, PrescribedMotionsComeAfterTheBondsHaveTheirReference) {
  Model model = mixed_model();
  model.supports.clear();
  for (const Index p : {0, 1, 2, 3, 4, 5, 6, 7, 8})
    fix_all(model, p, vector6(1e-3, 0, 2e-3, 0, 0, p == 0 ? 1e-3 : 0));
  const Exported exported(model, "lammps");
  const std::string deck = exported.text("in.lammps");
  const std::size_t reference = deck.find("run          0"), set = deck.find("set          atom * x");
  ASSERT_NE(set, std::string::npos);
  EXPECT_LT(reference, set);
  EXPECT_EQ(command_lines(exported.text("start_ux.txt")).size(), 10u);
  EXPECT_EQ(command_lines(exported.text("start_degrees.txt"))[1], (Words{"1", "0.057295779513082325"}));
}

TEST(LammpsDeck, SaysWhatLammpsCannotCarry) {
  Model model = mixed_model();
  for (BondBlock& block : model.blocks) block.contact_point = {ContactPoint::Kind::gap};
  const Exported exported(model, "lammps");
  EXPECT_THAT(joined(exported.notes.not_expressed), HasSubstr("another contact point than mid-length"));
  EXPECT_THAT(exported.text("in.lammps"), HasSubstr("# ANOTHER MODEL:"));
  EXPECT_THAT(joined(Exported(mixed_model(), "lammps").notes.not_expressed), testing::IsEmpty());
}

TEST(LammpsDeck, SaysWhichBondsGoToAnotherImageThanTheNearest) {
  Model model = skewed_pair();
  EXPECT_THAT(joined(Exported(model, "lammps").notes.not_expressed),
              HasSubstr("1 of 1 bonds do not go to the one nearest image"));
  // More than half of an edge, and the nearest image all the same.
  model.bonds[0].branch = 0.55 * model.cell->edges.col(0) - 0.3 * model.cell->edges.col(1);
  model.particles[1].position = model.bonds[0].branch;
  EXPECT_THAT(Exported(model, "lammps").notes.not_expressed, testing::IsEmpty());
}

TEST(LammpsDeck, IsRefusedWhereThereAreNoBonds) {
  Model model;
  add_particle(model, Vector3::Zero(), 1);
  fix_all(model, 0);
  for (const char* format : {"lammps", "liggghts"}) try {
      Exported(model, format);
      ADD_FAILURE() << format << " was written";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::invalid_input);
      EXPECT_THAT(error.what(), HasSubstr("no bonds"));
    }
}

TEST(LammpsDeck, DumpsTheIdsOfTheCaseWhereItsOwnAreOthers) {
  Model model = mixed_model();
  EXPECT_THAT(Exported(model, "lammps").text("in.lammps"), HasSubstr("dump.final id type"));
  for (Particle& particle : model.particles) particle.id -= 1;
  EXPECT_THAT(Exported(model, "lammps").text("in.lammps"),
              AllOf(HasSubstr("variable     case_id atom id-1\n"), HasSubstr("dump.final v_case_id type"),
                    HasSubstr("dump_modify  d colname v_case_id id\n")));
}

TEST(LammpsDeck, ATitleCannotJoinOrOpenLines) {
  // In LAMMPS a trailing & joins lines, and three double quotes open a text, even in comments.
  const Model model = mixed_model();
  const auto properties = bond_properties(model);
  ScratchFolder folder;
  ExportInput input{.model = model, .properties = properties, .title = "evil &\nrun 5 \"\"\" &"};
  input.time_step = input.steps = 1;
  FileSet files(folder.path());
  ExportNotes notes;
  write_lammps(input, files, notes);
  files.commit();
  const std::string deck = read_text(folder / "in.lammps");
  EXPECT_THAT(deck, Not(HasSubstr("&")));
  EXPECT_THAT(deck, Not(HasSubstr("\"\"\"")));
  EXPECT_EQ(lines_of(deck, "run").size(), 2u);
}

}  // namespace
}  // namespace bondstatic::test
