#include "case/imported_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bondstatic/bond_law.hpp"
#include "formats/write/toml.hpp"
#include "io/nearest_name.hpp"

namespace bondstatic {
namespace {

constexpr const char* fill_in = "# FILL IN";

/// One line of ASCII: what files call themselves may hold anything.
std::string plain(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  return text;
}

bool has_radii(const ForeignModel& model) {
  return !model.particles.empty() && !std::isnan(model.particles.front().radius);
}

std::string particles_block(const ForeignModel& model) {
  std::string text = "\n[[particles]]\nfile = \"particles.csv\"\n";
  if (!has_radii(model)) text += fmt::format("{}: no file gives radii.\n# radius = 1e-3\n", fill_in);
  std::vector<Index> count(model.group_names.size());
  for (const int group : model.group) ++count[std::size_t(group)];
  std::string groups;
  for (std::size_t g = 0; g < count.size(); ++g)
    if (count[g] > 0 && !model.group_names[g].empty())
      groups += fmt::format("{}{} ({})", groups.empty() ? "" : ", ", toml_text(plain(model.group_names[g])),
                            count[g]);
  if (!groups.empty()) text += "# its groups: " + groups + "\n";
  return text;
}

/// The model's own groups that together are exactly the group; empty where none are.
std::vector<std::string> made_of(const ForeignModel& model, const ForeignGroup& group) {
  if (model.group.empty()) return {};
  std::vector<Index> inside(model.group_names.size()), all(model.group_names.size());
  for (const int g : model.group) ++all[std::size_t(g)];
  for (const Index p : group.members) ++inside[std::size_t(model.group[std::size_t(p)])];
  std::vector<std::string> names;
  for (std::size_t g = 0; g < all.size(); ++g) {
    if (inside[g] == 0) continue;
    if (inside[g] != all[g] || model.group_names[g].empty()) return {};
    names.push_back(model.group_names[g]);
  }
  return names;
}

std::string group_block(const ForeignModel& model, const ForeignGroup& group) {
  std::string list;
  std::vector<std::string> names = made_of(model, group);
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + toml_text(name);
  if (names.empty())
    for (const Index p : group.members)
      list += fmt::format("{}{}", list.empty() ? "" : ", ", model.particles[std::size_t(p)].id);
  return fmt::format("\n[[groups]]                      # {} particles\nname = {}\nat = {{ {} = [{}] }}\n",
                     group.members.size(), toml_text(group.name), names.empty() ? "id" : "group", list);
}

/// Lines of the parameters of law "generic" that are to be given.
std::string parameter_lines(const std::vector<std::string>& names) {
  const BondLaw* generic = find_bond_law("generic");
  std::string text;
  for (const std::string& name : names)
    text += fmt::format(
        "# {} = 1e6                      # {}, {}\n", name,
        generic->parameters[std::size_t(generic->find(name))].meaning,
        name.starts_with("kn") || name.starts_with("ks") ? "force per length" : "moment per radian");
  return text;
}

std::string bonds_block(const ForeignModel& model, const ImportedCase& about) {
  std::string text = "\n[[bonds]]\n";
  const std::vector<std::string> missing = missing_stiffness(model);
  if (model.bonds.empty())
    text += fmt::format(
        "{}: no file gives bonds. They form where spheres of so many radii touch:\n"
        "contact_radius_factor = 1.0\n",
        fill_in);
  else
    text += "file = \"bonds.csv\"\n";
  if (about.parallel_bonds)
    text += "existing = \"add\"                # some pairs are bonded more than once\n";
  text += "law = \"generic\"\n";
  if (missing.empty()) return text;
  text += fmt::format(
      "{}: {} of the bonds{}. Or choose another law (`bondstatic laws`), which makes them from moduli.\n",
      fill_in, name_list(missing), model.bonds.empty() ? "" : ", which no file gives for all of them");
  return text + parameter_lines(missing);
}

std::string selector(const std::string& group) {
  return group == "all" ? "{ all = true }" : fmt::format("{{ group = {} }}", toml_text(group));
}

std::string support_block(const ForeignSupport& support) {
  static constexpr const char* names[6] = {"x", "y", "z", "rx", "ry", "rz"};
  std::string fixed;
  for (std::size_t i = 0; i < 6; ++i)
    if (support.fixed[i]) fixed += fmt::format("{}\"{}\"", fixed.empty() ? "" : ", ", names[i]);
  const bool all = std::find(support.fixed.begin(), support.fixed.end(), false) == support.fixed.end();
  return fmt::format("\n[[supports]]                    # {}\nat = {}\nfix = {}\n", plain(support.origin),
                     selector(support.group), all ? "\"all\"" : "[" + fixed + "]");
}

std::string load_block(const ForeignLoad& load) {
  const std::string at = load.gravity && load.group == "all" ? "" : "at = " + selector(load.group) + "\n";
  return fmt::format("\n[[loads]]                       # {}\n{}{} = {}\n", plain(load.origin), at,
                     load.gravity ? "gravity" : "force", toml_vector(load.value));
}

/// A group to write examples with.
std::string example_selector(const ForeignModel& model, const char* otherwise) {
  for (const std::string& name : model.group_names)
    if (!name.empty()) return selector(plain(name));
  return fmt::format("{{ {} = {{ axis = \"z\", within = {} }} }}", otherwise,
                     has_radii(model) ? fmt::format("{}", model.particles.front().radius) : "1e-3");
}

std::string examples(const ForeignModel& model, const ForeignSetup& setup) {
  std::string text;
  const bool cell = model.cell.has_value();
  if (setup.supports.empty())
    text += fmt::format("\n{}{}: who is held.\n# [[supports]]\n# at = {}\n# fix = \"all\"\n", fill_in,
                        cell ? ", if anything but the cell holds it" : "", example_selector(model, "lowest"));
  if (setup.loads.empty())
    text += fmt::format("\n{}: what loads it{}.\n# [[loads]]\n# at = {}\n# total_force = [0, 0, -1]\n",
                        fill_in, cell ? "; strain = { xx = 1e-3 } strains the cell" : "",
                        example_selector(model, "highest"));
  return text;
}

}  // namespace

std::vector<std::string> missing_stiffness(const ForeignModel& model) {
  std::vector<std::string> missing;
  for (const char* name : {"kn", "ks", "kt", "kb"}) {
    const auto found = model.bond_columns.find(name);
    const auto absent = [](double value) { return std::isnan(value); };
    if (found == model.bond_columns.end() || found->second.empty() ||
        std::any_of(found->second.begin(), found->second.end(), absent))
      missing.emplace_back(name);
  }
  return missing;
}

std::vector<std::string> to_be_filled_in(const ForeignModel& model, const ForeignSetup& setup) {
  std::vector<std::string> missing;
  if (!has_radii(model)) missing.emplace_back("the radius of the particles");
  if (model.bonds.empty()) missing.emplace_back("where bonds form");
  if (const auto names = missing_stiffness(model); !names.empty())
    missing.push_back(fmt::format("the stiffness of the bonds ({}), or another law", name_list(names)));
  if (setup.supports.empty() && !model.cell) missing.emplace_back("supports");
  if (setup.loads.empty() && !model.cell) missing.emplace_back("loads");
  return missing;
}

std::string imported_case(const ForeignModel& model, const ForeignSetup& setup, const ImportedCase& about) {
  const std::string title = model.title.empty() ? about.origin : model.title;
  std::string text = fmt::format("# From {}: {}{}\ntitle = {}\n", plain(about.origin), plain(model.format),
                                 model.si ? "; SI units" : "", toml_text(plain(title)));
  text += particles_block(model);
  if (model.cell) text += toml_cell(*model.cell);
  for (const ForeignGroup& group : setup.groups) text += group_block(model, group);
  text += bonds_block(model, about);
  for (const ForeignSupport& support : setup.supports) text += support_block(support);
  for (const ForeignLoad& load : setup.loads) text += load_block(load);
  return text + examples(model, setup);
}

}  // namespace bondstatic
