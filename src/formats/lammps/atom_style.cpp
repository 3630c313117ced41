#include "formats/lammps/atom_style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/nearest_name.hpp"
#include "io/number_field.hpp"

namespace bondstatic {
namespace {

/// tdpd, whose number of columns is free, is left out.
const std::map<std::string, std::string> styles{
    {"angle", "id molecule type x y z"},
    {"atomic", "id type x y z"},
    {"body", "id type bodyflag mass x y z"},
    {"bond", "id molecule type x y z"},
    {"bpm/sphere", "id molecule type diameter density x y z"},
    {"charge", "id type q x y z"},
    {"dielectric", "id type q x y z mux muy muz area ed em epsilon curvature"},
    {"dipole", "id type q x y z mux muy muz"},
    {"dpd", "id type theta x y z"},
    {"edpd", "id type edpd_temp edpd_cv x y z"},
    {"electron", "id type q espin eradius x y z"},
    {"ellipsoid", "id type ellipsoidflag density x y z"},
    {"full", "id molecule type q x y z"},
    {"line", "id molecule type lineflag density x y z"},
    {"mdpd", "id type rho x y z"},
    {"molecular", "id molecule type x y z"},
    {"peri", "id type volume density x y z"},
    {"smd", "id type molecule volume mass kradius cradius x0 y0 z0 x y z"},
    {"sph", "id type rho esph cv x y z"},
    {"sphere", "id type diameter density x y z"},
    {"spin", "id type x y z spx spy spz sp"},
    {"template", "id type molecule template-index template-atom x y z"},
    {"tri", "id molecule type triangleflag density x y z"},
    {"wavepacket", "id type q espin eradius etag cs_re cs_im x y z"},
};

std::vector<std::string> words(const std::string& text) {
  std::vector<std::string_view> fields;
  split_at_blanks(text, fields);
  return {fields.begin(), fields.end()};
}

std::vector<std::string> style_names() {
  std::vector<std::string> names;
  for (const auto& [name, columns] : styles) names.push_back(name);
  return names;
}

const std::string* columns_of(std::string name) {
  if (name.ends_with("/kk")) name.resize(name.size() - 3);  // the KOKKOS package's variant of a style
  const auto found = styles.find(name);
  return found == styles.end() ? nullptr : &found->second;
}

}  // namespace

int AtomStyle::find(const std::string& column) const {
  const auto found = std::find(columns.begin(), columns.end(), column);
  return found == columns.end() ? -1 : int(found - columns.begin());
}

std::optional<AtomStyle> find_atom_style(const std::string& text, Fault& wrong) {
  std::vector<std::string> names = words(text);
  // Numbers are arguments of a style, such as the 1 of "sphere 1" (radii that vary).
  std::erase_if(names, [](const std::string& name) { return whole_number_field(name).has_value(); });
  const bool hybrid = !names.empty() && (names[0] == "hybrid" || names[0] == "hybrid/kk");
  if (hybrid) names.erase(names.begin());
  if (hybrid && names.empty()) {
    wrong = {
        {},
        "atom style \"hybrid\" does not say of which styles it is made, and so not its columns",
        "give the styles in the order of the input script's atom_style: --atom-style \"hybrid sphere bond\""};
    return std::nullopt;
  }
  for (const std::string& name : names) {
    if (columns_of(name)) continue;
    const std::string near = nearest_name(name, style_names());
    wrong = {
        {},
        fmt::format("atom style \"{}\" is not known", name),
        near.empty() ? "give one of " + name_list(style_names()) : fmt::format("did you mean \"{}\"?", near)};
    return std::nullopt;
  }
  if (names.empty() || (!hybrid && names.size() > 1)) {
    wrong = {{},
             fmt::format("\"{}\" is no atom style", text),
             "give one style, or \"hybrid\" and several: --atom-style \"hybrid sphere bond\""};
    return std::nullopt;
  }
  AtomStyle style;
  style.name = hybrid ? "hybrid" : names[0];
  if (!hybrid) {
    style.columns = words(*columns_of(names[0]));
    return style;
  }
  // Five columns that all styles share come first; what several styles have comes once.
  style.columns = {"id", "type", "x", "y", "z"};
  for (const std::string& name : names) {
    style.name += " " + name;
    for (const std::string& column : words(*columns_of(name)))
      if (style.find(column) < 0) style.columns.push_back(column);
  }
  return style;
}

std::string atom_styles_of_width(std::size_t fields) {
  std::vector<std::string> fitting;
  for (const auto& [name, columns] : styles) {
    const std::size_t width = words(columns).size();
    if (fields == width || fields == width + 3) fitting.push_back(name);
  }
  return name_list(fitting);
}

}  // namespace bondstatic
