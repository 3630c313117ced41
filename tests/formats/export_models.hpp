// Models to be exported, and their files read back as text.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "bondstatic/statics.hpp"
#include "formats/write/export_formats.hpp"
#include "io/scratch_folder.hpp"
#include "support/models.hpp"

namespace bondstatic::test {

/// A small disordered packing of generic bonds of two kinds, densities that differ, lowest layer held, one
/// particle held in y and z only, one loaded by a force and one by a force and a moment.
inline Model mixed_model() {
  std::mt19937_64 random(7);
  Model model = random_packing(
      random, 3, block("generic", {{"kn", 1e6 / 3}, {"ks", 4e5 / 7}, {"kt", 0.05 / 3}, {"kb", 0.08 / 3}}));
  model.blocks[1] = block("generic", {{"kn", 2e6 / 3}, {"ks", 1e5 / 7}, {"kt", 0.5 / 3}, {"kb", 1.0 / 7}});
  Index of_first = 0, of_second = 0;
  for (Bond& bond : model.bonds) {
    bond.block = bond.id % 3 == 0;
    bond.in_block = bond.block == 0 ? of_first++ : of_second++;
  }
  std::uniform_real_distribution<double> densities(1000, 3000);
  for (Particle& particle : model.particles) particle.density = densities(random);
  for (const Index p : {0, 1, 2, 3, 4, 5, 6, 7, 8}) fix_all(model, p);
  Support roller;
  roller.particle = 14;
  roller.fixed[1] = roller.fixed[2] = true;
  model.supports.push_back(roller);
  load(model, 26, vector6(2.0, -1.0 / 3, -10));
  model.loads.push_back({20, vector6(1, 2, 3, 0.1, 0.2, 0.7 / 3), every_case});
  return model;
}

/// Two particles in the primitive cell of a face-centred lattice, whose bond is less than half of each edge
/// but not the nearest image: that lies across two faces.
inline Model skewed_pair() {
  Model model;
  Cell cell;
  cell.edges << 1, 0.5, 0.5, 0, std::sqrt(0.75), std::sqrt(1.0 / 12), 0, 0, std::sqrt(2.0 / 3);
  model.cell = cell;
  add_particle(model, Vector3::Zero(), 0.2);
  add_particle(model, 0.45 * (cell.edges.col(0) + cell.edges.col(1)), 0.2);
  model.blocks = {block("generic", {{"kn", 1e6}, {"ks", 1e6}, {"kt", 10}, {"kb", 10}})};
  add_bond(model, 0, 1);
  for (Particle& particle : model.particles) particle.density = 1000;
  fix_all(model, 0);
  load(model, 1, vector6(0, 0, 1));
  return model;
}

struct Exported {
  ScratchFolder folder;
  ExportNotes notes;
  std::vector<BondProperties> properties;
  StaticSolution solution;

  Exported(const Model& model, const std::string& format, bool relaxed = false, bool si = false) {
    properties = bond_properties(model);
    solution = solve_statics(model, {});
    ExportInput input{.model = model, .properties = properties, .title = "a test"};
    input.state = &solution.cases.front();
    input.relaxed = relaxed;
    input.si = si;
    input.time_step = 1e-6;
    input.steps = 100;
    input.particle_damping = 0.7;
    FileSet files(folder.path());
    for (const ExportFormat& known : export_formats())
      if (known.name == format) known.write(input, files, notes);
    files.commit();
  }
  std::string path(const std::string& name) const { return (folder / name).string(); }
  std::string text(const std::string& name) const { return read_text(folder / name); }
};

/// Words of each line, without comments; empty lines left out.
inline std::vector<std::vector<std::string>> command_lines(const std::string& text) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::vector<std::string> found;
    for (std::string word; words >> word;) found.push_back(word);
    if (!found.empty()) lines.push_back(found);
  }
  return lines;
}

inline std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += sentence + '\n';
  return text;
}

}  // namespace bondstatic::test
