#include "report/column_meaning.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace bondstatic {

namespace {

/// A quantity of the run beside it, or their difference, is of the same kind.
std::string_view kind_of(std::string_view name) {
  for (const std::string_view beginning : {"run_", "difference_", "reaction_"})
    if (name.starts_with(beginning)) name.remove_prefix(beginning.size());
  if (constexpr std::string_view end = "_difference"; name.ends_with(end)) name.remove_suffix(end.size());
  return name;
}

template <std::size_t count>
bool is_among(std::string_view name, const std::array<std::string_view, count>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr std::array<std::string_view, 8> lengths{"radius", "displacement", "x", "y", "z", "ux", "uy", "uz"};
constexpr std::array<std::string_view, 4> angles{"rotation", "rx", "ry", "rz"};
constexpr std::array<std::string_view, 3> force_components{"fx", "fy", "fz"};
constexpr std::array<std::string_view, 3> moment_components{"mx", "my", "mz"};
constexpr std::array<std::string_view, 2> stresses{"sigma", "tau"};
constexpr std::array<std::string_view, 7> magnitudes{"radius", "shear_force", "bending_moment", "tau",
                                                     "energy", "utilisation", "break_step"};

}  // namespace

std::string unit_of(const std::string& name, bool si) {
  const std::string_view kind = kind_of(name);
  if (is_among(kind, angles)) return "rad";
  if (!si) return "";
  if (is_among(kind, lengths)) return "m";
  if (kind == "velocity") return "m/s";
  if (kind.ends_with("force") || is_among(kind, force_components)) return "N";
  if (kind.ends_with("moment") || is_among(kind, moment_components)) return "N m";
  if (is_among(kind, stresses)) return "Pa";
  return kind == "energy" ? "J" : "";
}

PageColumn page_column(const GridArray& array, bool si) {
  const bool is_signed = !array.whole && !is_among(kind_of(array.name), magnitudes);
  return {array.name, unit_of(array.name, si), array.components, is_signed, array.whole};
}

}  // namespace bondstatic
