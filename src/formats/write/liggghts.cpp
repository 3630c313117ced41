// Files for LIGGGHTS with bonds (richti83/LIGGGHTS-WITH-BONDS): a data file for atom_style hybrid granular
// bond/gran, whose Atoms columns are id type x y z, then those of granular (diameter density) and of
// bond/gran (molecule), and the commands that give its bonds their coefficients. The conventions are those of
// bond/codes.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "bond/translate.hpp"
#include "formats/write/export_formats.hpp"
#include "formats/write/lammps_box.hpp"
#include "formats/write/lammps_roles.hpp"
#include "io/ordered_blocks.hpp"

namespace bondstatic {

namespace {

constexpr Index lines_a_block = 8192;
constexpr double rounding = 1e-9;

/// Coefficients rb, Sn, St of each bond as a type, and how far what they make is from what is wanted.
struct GranBonds {
  std::vector<std::vector<double>> types;
  std::vector<Index> type;  ///< of each bond, from 1
  Index off_rotation = 0;   ///< bonds whose kt or kb cannot be had
  double farthest = 0;      ///< of those, largest relative error
  Index departing = 0;      ///< bonds that do not rest under rigid motions there
  Index moved = 0;          ///< bonds with another contact point
  double longest = 0;
};

GranBonds gran_bonds(const ExportInput& input, const BondCode& code) {
  GranBonds out;
  std::map<std::vector<double>, Index> known;
  for (std::size_t k = 0; k < input.model.bonds.size(); ++k) {
    const BondSite site = bond_site(input.model, input.model.bonds[k]);
    BondProperties wanted = input.properties[k];
    if (!wanted.moments_fed_back) wanted.stiffness.kt = wanted.stiffness.kb = 0;
    const TranslatedBond bond = translate(code, site, wanted);
    out.moved += std::abs(bond.wanted.fraction - bond.realised.fraction) > rounding;
    out.departing += code.departure && code.departure(site) > rounding;
    out.longest = std::max(out.longest, site.length);
    const SectionStiffness &real = bond.realised.stiffness, &want = bond.wanted.stiffness;
    double off = std::abs(want.coupling) > 0 ? 1 : 0;
    for (const auto& [a, b] : {std::pair{real.kt, want.kt}, std::pair{real.kb, want.kb}})
      if (a != b) off = std::max(off, std::abs(a - b) / std::max(std::abs(a), std::abs(b)));
    out.off_rotation += off > rounding;
    out.farthest = std::max(out.farthest, off);
    const auto [found, is_new] = known.try_emplace(bond.stored, Index(out.types.size()) + 1);
    if (is_new) out.types.push_back(bond.stored);
    out.type.push_back(found->second);
  }
  return out;
}

void tell(const ExportInput& input, const GranBonds& bonds, const BondCode& code, ExportNotes& notes) {
  const std::size_t all = input.model.bonds.size();
  if (bonds.off_rotation > 0)
    notes.not_expressed.push_back(fmt::format(
        "{} of {} bonds have a twisting or bending stiffness that bond_style gran cannot have (up to "
        "{:.3g} of it off): it knows three numbers, and {}.",
        bonds.off_rotation, all, bonds.farthest, code.fit));
  if (bonds.moved > 0)
    notes.not_expressed.push_back(
        fmt::format("{} of {} bonds act at another contact point; in bond_style gran: {}.", bonds.moved, all,
                    code.contact_point_text));
  if (bonds.departing > 0)
    notes.not_expressed.push_back(
        fmt::format("{} of {} bonds join particles that do not touch or are not of one size: {}.",
                    bonds.departing, all, code.departure_text));
  if (const Index other_image = bonds_to_other_images(input.model); other_image > 0)
    notes.not_expressed.push_back(
        fmt::format("{} of {} bonds do not go to the one nearest image of their far end, which LIGGGHTS "
                    "takes. Repeat the "
                    "cell (2x2x2) before exporting.",
                    other_image, all));
  if (input.model.cell && std::any_of(input.model.cell->periodic.begin(), input.model.cell->periodic.end(),
                                      [](bool repeats) { return repeats; }))
    notes.remarks.push_back(
        "Whether a bond across a periodic face is kept depends on the version of the code.");
  if (input.relaxed)
    notes.not_expressed.push_back(
        "bond_style gran adds up forces from increments and cannot be given any: its bonds start without "
        "stress. The data file has the reference positions; the relaxed state is in the tables beside it.");
  notes.remarks.push_back(
      "Some versions multiply the forces of all bonds by 0.995 in each step (`dissipate` in bond_gran.cpp): "
      "such a run has no state of rest under load. Set it to 1 before you compare.");
  notes.remarks.push_back(
      "Coefficients are rb, Sn, St with rb over the smaller particle's radius (LIGGGHTS-WITH-BONDS of "
      "October "
      "2015); where your version takes a length for rb, or moduli, convert them.");
  notes.remarks.push_back("Supports and loads of the case are atom types; their fixes are yours to write.");
}

void write_data(const ExportInput& input, const GranBonds& bonds, const LammpsRoles& roles,
                const LammpsBox& box, Index id_shift, OutputFile& file) {
  const Model& model = input.model;
  file.append("LIGGGHTS data file by bondstatic, atom_style hybrid granular bond/gran\n\n");
  file.append(fmt::format("{} atoms\n{} bonds\n{} atom types\n{} bond types\n\n", model.particles.size(),
                          model.bonds.size(), roles.roles.size(), bonds.types.size()));
  for (int i = 0; i < 3; ++i)
    file.append(fmt::format("{0} {1} {2}lo {2}hi\n", box.low[i], box.high[i], "xyz"[i]));
  if (box.triclinic()) file.append(fmt::format("{} {} {} xy xz yz\n", box.tilt[0], box.tilt[1], box.tilt[2]));
  file.append("\nAtoms\n\n");
  const auto id = [&](Index p) { return model.particles[std::size_t(p)].id + id_shift; };
  write_blocks(file, Index(model.particles.size()), lines_a_block,
               [&](Index begin, Index end, fmt::memory_buffer& text) {
                 for (Index p = begin; p < end; ++p) {
                   const Particle& particle = model.particles[std::size_t(p)];
                   const Vector3& x = particle.position;
                   const double density = std::isnan(particle.density) ? 1 : particle.density;
                   fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {} {} 1\n", id(p),
                                  roles.type[std::size_t(p)], x[0], x[1], x[2], 2 * particle.radius, density);
                 }
               });
  file.append("\nBonds\n\n");
  write_blocks(file, Index(model.bonds.size()), lines_a_block,
               [&](Index begin, Index end, fmt::memory_buffer& text) {
                 for (Index k = begin; k < end; ++k) {
                   const Bond& bond = model.bonds[std::size_t(k)];
                   fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", bond.id,
                                  bonds.type[std::size_t(k)], id(bond.a), id(bond.b));
                 }
               });
}

Index most_bonds(const Model& model) {
  std::vector<Index> bonds(model.particles.size());
  for (const Bond& bond : model.bonds)
    for (const Index p : {bond.a, bond.b}) ++bonds[std::size_t(p)];
  return *std::max_element(bonds.begin(), bonds.end());
}

std::string commands(const ExportInput& input, const GranBonds& bonds, const LammpsRoles& roles,
                     const LammpsBox& box, const ExportNotes& notes) {
  std::string text;
  for (const std::string& note : notes.not_expressed) text += "# ANOTHER MODEL: " + note + '\n';
  for (const std::string& note : notes.remarks) text += "# Note: " + note + '\n';
  text += fmt::format("atom_style   hybrid granular bond/gran n_bondtypes {} bonds_per_atom {}\n",
                      bonds.types.size(), most_bonds(input.model));
  text += fmt::format(
      "atom_modify  map array\nboundary     {}\nnewton       off\ncommunicate  single vel yes\nunits        "
      "si\n{}"
      "read_data    model.data\n",
      box.boundary(), box.large_tilt() ? "box          tilt large\n" : "");
  for (std::size_t t = 0; t < roles.roles.size(); ++t)
    text += fmt::format("# atom type {}: {}, {} particles\n", t + 1, roles.roles[t].text(),
                        roles.roles[t].particles);
  text += "# bonds that come within the skin of a face break: the box is wider than that\n";
  text += fmt::format("neighbor     {:.6g} bin\nneigh_modify delay 0\n", 0.3 * bonds.longest);
  text += "# rb Sn St, then 1 (break by stress) and strengths that no bond reaches\nbond_style   gran\n";
  for (std::size_t t = 0; t < bonds.types.size(); ++t) {
    const std::vector<double>& c = bonds.types[t];
    text += fmt::format("bond_coeff   {} {} {} {} 1 1e+30 1e+30\n", t + 1, c[0], c[1], c[2]);
  }
  return text;
}

}  // namespace

void write_liggghts(const ExportInput& input, FileSet& files, ExportNotes& notes) {
  const Model& model = input.model;
  need_bonds(model, "LIGGGHTS");
  const BondCode& code = *find_bond_code("liggghts-bond-gran");
  const GranBonds bonds = gran_bonds(input, code);
  const LammpsRoles roles = lammps_roles(input);
  tell(input, bonds, code, notes);
  std::vector<Vector3> places;
  double largest = bonds.longest;
  Index first = 1;
  bool without_density = false;
  for (const Particle& particle : model.particles) {
    places.push_back(particle.position);
    largest = std::max(largest, 2 * particle.radius);
    first = std::min(first, particle.id);
    without_density = without_density || std::isnan(particle.density);
  }
  if (without_density)
    notes.remarks.push_back(
        "Particles without a density have density 1 there, which the state at rest does not "
        "depend on.");
  if (first < 1) notes.remarks.push_back("Ids begin at 1 there: all are larger by 1 than in the case.");
  const LammpsBox box = lammps_box(model.cell, places, largest);
  write_data(input, bonds, roles, box, 1 - first, create(files, notes, "model.data"));
  create(files, notes, "in.liggghts").append(commands(input, bonds, roles, box, notes));
  notes.next_steps = {"liggghts -in in.liggghts   (a build with bonds, and with your fixes and run)"};
}

}  // namespace bondstatic
