// The case as tables and a case file that reads them: each bond a generic one with its own four stiffnesses.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <tuple>

#include "bond/contact_point.hpp"
#include "formats/write/export_formats.hpp"
#include "formats/write/toml.hpp"
#include "io/csv_writer.hpp"

namespace bondstatic {

namespace {

constexpr const char* particle_table = "particles.csv";
constexpr const char* undense_table = "particles_without_density.csv";
constexpr const char* bond_table = "bonds.csv";
constexpr double mid_length = 0.5;

using Numbers = std::array<double, 6>;
Numbers numbers(const Vector6& v) {
  Numbers out;
  std::copy(v.begin(), v.end(), out.begin());
  return out;
}

Column ids(const Model& model, const std::vector<Index>& of) {
  std::vector<Index> out;
  for (const Index p : of) out.push_back(model.particles[std::size_t(p)].id);
  return {"id", std::move(out)};
}

void write_particles(const Model& model, const std::vector<Index>& of, OutputFile& file, bool with_density) {
  std::vector<Column> columns{ids(model, of)};
  const auto add = [&](const std::string& name, const std::function<double(const Particle&)>& value) {
    columns.push_back({name, Index(of.size()), Column::Numbers<double>([&, value](Index i) {
                         return value(model.particles[std::size_t(of[std::size_t(i)])]);
                       })});
  };
  for (const int i : {0, 1, 2}) add({"xyz"[i]}, [i](const Particle& p) { return p.position[i]; });
  add("radius", [](const Particle& p) { return p.radius; });
  if (with_density) add("density", [](const Particle& p) { return p.density; });
  write_csv(file, columns);
}

/// A bond whose section couples shear and bending is the same bond without coupling at another contact point:
/// where a shear force alone turns nothing.
BondProperties uncoupled(BondProperties bond, double length) {
  if (bond.stiffness.coupling != 0 && bond.stiffness.ks > 0) {
    const double distance = bond.stiffness.coupling / bond.stiffness.ks;
    bond.stiffness = moved(bond.stiffness, distance);
    bond.stiffness.coupling = 0;
    bond.fraction += distance / length;
  }
  return bond;
}

void write_bonds(const ExportInput& input, OutputFile& file, ExportNotes& notes) {
  const Model& model = input.model;
  const auto count = Index(model.bonds.size());
  std::vector<BondProperties> bonds;
  Index coupled = 0, without_feedback = 0;
  bool off_middle = false, has_radius = false;
  for (std::size_t k = 0; k < model.bonds.size(); ++k) {
    coupled += input.properties[k].stiffness.coupling != 0;
    without_feedback += !input.properties[k].moments_fed_back;
    bonds.push_back(uncoupled(input.properties[k], model.bonds[k].branch.norm()));
    off_middle = off_middle || bonds.back().fraction != mid_length;
    has_radius = has_radius || !std::isnan(bonds.back().radius);
  }
  if (coupled > 0)
    notes.remarks.push_back(fmt::format(
        "{} bonds couple shear and bending: written at the contact point where they do not. It is "
        "the same bond, but its moment is that about another point.",
        coupled));
  if (const Index other_image = bonds_to_other_images(model); other_image > 0)
    notes.not_expressed.push_back(
        fmt::format("{} of {} bonds do not go to the one nearest image of their far end, which a table of "
                    "bonds means. Repeat the cell (2x2x2) before exporting.",
                    other_image, count));
  if (without_feedback > 0)
    notes.remarks.push_back(fmt::format(
        "{} bonds keep their moments to themselves (torque feedback off): written with kt = kb = 0, "
        "which is the same equilibrium; stresses lack those moments.",
        without_feedback));

  std::vector<Column> columns;
  const auto add_ids = [&](const std::string& name, Index Bond::*end) {
    columns.push_back({name, count, Column::Numbers<Index>([&model, end](Index k) {
                         return model.particles[std::size_t(model.bonds[std::size_t(k)].*end)].id;
                       })});
  };
  const auto add = [&](const std::string& name, const std::function<double(const BondProperties&)>& value) {
    columns.push_back({name, count, Column::Numbers<double>([&bonds, value](Index k) {
                         return value(bonds[std::size_t(k)]);
                       })});
  };
  columns.push_back(
      {"id", count, Column::Numbers<Index>([&model](Index k) { return model.bonds[std::size_t(k)].id; })});
  add_ids("a", &Bond::a);
  add_ids("b", &Bond::b);
  add("kn", [](const BondProperties& bond) { return bond.stiffness.kn; });
  add("ks", [](const BondProperties& bond) { return bond.stiffness.ks; });
  add("kt", [](const BondProperties& b) { return b.moments_fed_back ? b.stiffness.kt : 0.0; });
  add("kb", [](const BondProperties& b) { return b.moments_fed_back ? b.stiffness.kb : 0.0; });
  if (off_middle) add("contact_point", [](const BondProperties& bond) { return bond.fraction; });
  if (has_radius) add("radius", [](const BondProperties& bond) { return bond.radius; });
  write_csv(file, columns);
}

std::string at_ids(const Model& model, const std::vector<Index>& particles) {
  std::string text = "at = { id = [";
  constexpr std::size_t a_line = 16;
  for (std::size_t i = 0; i < particles.size(); ++i)
    text += fmt::format("{}{}",
                        i == 0            ? ""
                        : i % a_line == 0 ? ",\n  "
                                          : ", ",
                        model.particles[std::size_t(particles[i])].id);
  return text + "] }\n";
}

std::string of_case(const Model& model, Index load_case) {
  return load_case == every_case ? ""
                                 : "case = " + toml_text(model.load_cases[std::size_t(load_case)]) + "\n";
}

std::string supports_text(const Model& model) {
  const char* const names[] = {"x", "y", "z", "rx", "ry", "rz"};
  std::map<std::tuple<std::array<bool, 6>, Numbers, Index>, std::size_t> known;
  std::vector<std::pair<const Support*, std::vector<Index>>> blocks;
  for (const Support& support : model.supports) {
    const auto [found, is_new] =
        known.try_emplace({support.fixed, numbers(support.value), support.load_case}, blocks.size());
    if (is_new) blocks.push_back({&support, {}});
    blocks[found->second].second.push_back(support.particle);
  }
  std::string text;
  for (const auto& [support, particles] : blocks) {
    std::string values;
    for (int i = 0; i < 6; ++i)
      if (support->fixed[std::size_t(i)])
        values +=
            fmt::format("{}{} = {}", values.empty() ? "" : ", ", names[i], toml_number(support->value[i]));
    if (values.empty()) continue;
    text += fmt::format("\n[[supports]]\n{}values = {{ {} }}\n{}", at_ids(model, particles), values,
                        of_case(model, support->load_case));
  }
  return text;
}

std::string loads_text(const Model& model) {
  std::map<std::tuple<Numbers, Index, Index>, std::size_t> known;
  std::map<std::pair<Index, Index>, Index> times;  // how often a particle has been loaded in a case
  std::vector<std::pair<const Load*, std::vector<Index>>> blocks;
  for (const Load& load : model.loads) {
    // The second load on a particle goes to a block of its own even if it equals the first.
    const Index before = times[{load.particle, load.load_case}]++;
    const auto [found, is_new] =
        known.try_emplace({numbers(load.force), load.load_case, before}, blocks.size());
    if (is_new) blocks.push_back({&load, {}});
    blocks[found->second].second.push_back(load.particle);
  }
  std::string text;
  for (const auto& [load, particles] : blocks)
    text += fmt::format("\n[[loads]]\n{}force = {}\nmoment = {}\n{}", at_ids(model, particles),
                        toml_vector(load->force.head<3>()), toml_vector(load->force.tail<3>()),
                        of_case(model, load->load_case));
  for (const Strain& strain : model.strains) {
    const Matrix3& e = strain.value;
    text +=
        fmt::format("\n[[loads]]\nstrain = {{ xx = {}, yy = {}, zz = {}, yz = {}, xz = {}, xy = {} }}\n{}",
                    toml_number(e(0, 0)), toml_number(e(1, 1)), toml_number(e(2, 2)), toml_number(e(1, 2)),
                    toml_number(e(0, 2)), toml_number(e(0, 1)), of_case(model, strain.load_case));
  }
  return text;
}

}  // namespace

void write_csv_case(const ExportInput& input, FileSet& files, ExportNotes& notes) {
  const Model& model = input.model;
  std::vector<Index> dense, undense;
  for (std::size_t p = 0; p < model.particles.size(); ++p)
    (std::isnan(model.particles[p].density) ? undense : dense).push_back(Index(p));
  const bool some = !dense.empty();
  const std::string other_table = some ? undense_table : particle_table;

  std::string text = "title = " + toml_text(input.title) + "\n";
  if (input.si) text += "# numbers are SI\n";
  if (model.cell) text += toml_cell(*model.cell);
  if (some) {
    write_particles(model, dense, create(files, notes, particle_table), true);
    text += fmt::format("\n[[particles]]\nfile = \"{}\"\n", particle_table);
  }
  if (!undense.empty()) {
    write_particles(model, undense, create(files, notes, other_table), false);
    text += fmt::format("\n[[particles]]\nfile = \"{}\"\n", other_table);
  }
  if (!model.bonds.empty()) {
    write_bonds(input, create(files, notes, bond_table), notes);
    text += fmt::format("\n[[bonds]]\nfile = \"{}\"\nlaw = \"generic\"\nexisting = \"add\"\n", bond_table);
  }
  text += supports_text(model) + loads_text(model);
  if (input.drop_unsupported) text += "\n[solve]\nunsupported = \"drop\"\n";
  if (some && !undense.empty())
    notes.remarks.push_back("Particles without a density are in a table of their own, behind the others.");
  notes.remarks.push_back("[[outputs]], [[groups]] and the options of the case are not in its copy.");
  create(files, notes, "case.toml").append(text);
  notes.next_steps = {"bondstatic solve case.toml"};
}

}  // namespace bondstatic
