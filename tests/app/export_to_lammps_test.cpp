// The exported deck run by a real LAMMPS, where there is one. Debian's has no package BPM: atom style, bond
// style and the fixes of that package are replaced by their nearest relatives, all else runs as it was
// written.
#ifdef BONDSTATIC_LAMMPS
#include <gmock/gmock.h>

#include <iterator>

#include "app/run_program.hpp"
#include "formats/export_models.hpp"

namespace bondstatic::test {
namespace {

/// Atoms: id molecule type diameter density x y z becomes id type x y z molecule diameter density.
std::string for_hybrid_atoms(const std::string& data) {
  std::istringstream lines(data);
  std::string out;
  bool atoms = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("Atoms")) {
      atoms = true;
      line = "Atoms";
    } else if (line.starts_with("Bonds")) {
      atoms = false;
    }
    std::istringstream words(line);
    const std::vector<std::string> w{std::istream_iterator<std::string>(words), {}};
    if (atoms && w.size() == 8)
      line = w[0] + ' ' + w[2] + ' ' + w[5] + ' ' + w[6] + ' ' + w[7] + ' ' + w[1] + ' ' + w[3] + ' ' + w[4];
    out += line + '\n';
  }
  return out;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// Without what only BPM knows: orientations, damping/cundall, the fixes .../atom; and without names of
/// columns, which Debian's LAMMPS of 2021 does not take.
std::string for_plain_lammps(std::string deck) {
  deck = replaced(deck, "atom_style   bpm/sphere", "atom_style   hybrid bond sphere");
  deck = replaced(deck, "nve/bpm/sphere", "nve/sphere");
  deck = replaced(deck, "bond_style   bpm/rotational break no smooth no", "bond_style   harmonic");
  deck = replaced(deck, " c_q[1] c_q[2] c_q[3] c_q[4]", "");
  std::istringstream lines(deck);
  std::string out;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string command, first;
    words >> command >> first;
    if (command == "bond_coeff") line = command + ' ' + first + " 0.0 1.0";
    const bool unknown = line.find("damping/cundall") != std::string::npos ||
                         line.find("torque/atom") != std::string::npos ||
                         line.find("quat") != std::string::npos || line.find("colname") != std::string::npos;
    if (!unknown) out += line + '\n';
  }
  return out;
}

Ended run_lammps(const Exported& exported) {
  exported.folder.write("model.data", for_hybrid_atoms(exported.text("model.data")));
  exported.folder.write("in.plain", for_plain_lammps(exported.text("in.lammps")));
  // LAMMPS looks for files where it is started.
  return Program({"-c", "cd '" + exported.folder.path().string() +
                            "' && exec '" BONDSTATIC_LAMMPS "' -in in.plain -log none -nocite"},
                 "/bin/sh")
      .end();
}

std::vector<std::vector<std::string>> dumped(const Exported& exported, const std::string& name) {
  const std::string text = exported.text(name);
  return command_lines(text.substr(text.find('\n', text.find("ITEM: ATOMS"))));
}

TEST(LammpsRunsTheDeck, WithSupportsLoadsAndDumps) {
  const Model model = mixed_model();
  const Exported exported(model, "lammps");
  const Ended ended = run_lammps(exported);
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  const auto atoms = dumped(exported, "dump.final");
  ASSERT_EQ(atoms.size(), model.particles.size());
  for (std::size_t p = 0; p < 9; ++p)  // held
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(std::stod(atoms[p][std::size_t(2 + i)]), model.particles[p].position[i]);
  EXPECT_EQ(std::stod(atoms[14][3]), model.particles[14].position[1]) << "held in y";
  EXPECT_NE(std::stod(atoms[26][2]), model.particles[26].position[0]) << "pushed";
}

TEST(LammpsRunsTheDeck, FromTheRelaxedState) {
  const Model model = mixed_model();
  const Exported exported(model, "lammps", true);
  const Ended ended = run_lammps(exported);
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  const auto atoms = dumped(exported, "dump.final");
  ASSERT_EQ(atoms.size(), model.particles.size());
  // Without bonds the particles fly on, from where the deck has put them: the held ones say where.
  for (std::size_t p = 0; p < model.particles.size(); ++p) {
    const Vector3 start = model.particles[p].position + exported.solution.cases[0].displacement[p].head<3>();
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(std::stod(atoms[p][std::size_t(2 + i)]), start[i], 1e-9);
  }
}

TEST(LammpsRunsTheDeck, WithLoadsParticleByParticleInAPeriodicBox) {
  Model model = mixed_model();
  for (Index p = 9; p < 27; ++p) load(model, p, vector6(0, 0.1 * double(p), 0));
  Cell cell;
  cell.origin = Vector3(-0.5, -0.5, -0.5);
  cell.edges << 8, 1, 0.5, 0, 8, 0.25, 0, 0, 8;
  cell.periodic = {true, true, false};
  model.cell = cell;
  const Ended ended = run_lammps(Exported(model, "lammps"));
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
}

TEST(LammpsRunsTheDeck, InABoxTiltedByMoreThanHalfAnEdgeWithTheIdsOfTheCase) {
  Model model = mixed_model();
  for (Particle& particle : model.particles) particle.id -= 1;
  Cell cell;
  cell.origin = Vector3(-0.5, -0.5, -0.5);
  cell.edges << 8, 5, 0, 0, 8, 0, 0, 0, 8;
  model.cell = cell;
  const Exported exported(model, "lammps");
  const Ended ended = run_lammps(exported);
  ASSERT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(exported.text("dump.final"), testing::HasSubstr("ITEM: ATOMS v_case_id type"));
  const auto atoms = dumped(exported, "dump.final");
  ASSERT_EQ(atoms.size(), model.particles.size());
  for (std::size_t p = 0; p < atoms.size(); ++p) EXPECT_EQ(std::stol(atoms[p][0]), model.particles[p].id);
}

TEST(LammpsReadsLiggghtsData, WhoseAtomsAreThoseOfAHybridStyle) {
  const Exported exported(mixed_model(), "liggghts");
  exported.folder.write("in.read",
                        "units si\natom_style hybrid sphere bond\nboundary f f f\nread_data model.data\n");
  const Ended ended = Program({"-c", "cd '" + exported.folder.path().string() +
                                         "' && exec '" BONDSTATIC_LAMMPS "' -in in.read -log none -nocite"},
                              "/bin/sh")
                          .end();
  EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, testing::HasSubstr("27 atoms"));
}

}  // namespace
}  // namespace bondstatic::test
#endif
