#include "formats/lammps/sections.hpp"

#include <algorithm>

#include "io/nearest_name.hpp"
#include "io/number_field.hpp"

namespace bondstatic {
namespace {

constexpr int lines_between_reports = 1 << 14;

const std::vector<std::string> known_sections{"Atoms",
                                              "Velocities",
                                              "Masses",
                                              "Ellipsoids",
                                              "Lines",
                                              "Triangles",
                                              "Bodies",
                                              "Bonds",
                                              "Angles",
                                              "Dihedrals",
                                              "Impropers",
                                              "Atom Type Labels",
                                              "Bond Type Labels",
                                              "Angle Type Labels",
                                              "Dihedral Type Labels",
                                              "Improper Type Labels",
                                              "Pair Coeffs",
                                              "PairIJ Coeffs",
                                              "Bond Coeffs",
                                              "Angle Coeffs",
                                              "Dihedral Coeffs",
                                              "Improper Coeffs",
                                              "BondBond Coeffs",
                                              "BondAngle Coeffs",
                                              "MiddleBondTorsion Coeffs",
                                              "EndBondTorsion Coeffs",
                                              "AngleTorsion Coeffs",
                                              "AngleAngleTorsion Coeffs",
                                              "BondBond13 Coeffs",
                                              "AngleAngle Coeffs"};

std::string trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  while (!text.empty() && blanks.find(text.back()) != blanks.npos) text.remove_suffix(1);
  return std::string(text);
}

}  // namespace

std::string nearest_lammps_section(const std::string& name) {
  const bool known = std::find(known_sections.begin(), known_sections.end(), name) != known_sections.end();
  return known ? "" : nearest_name(name, known_sections);
}

DataSections::DataSections(LineReader& reader, std::string first, const ReadOptions& options,
                           std::vector<Fault>& faults)
    : reader_(reader),
      options_(options),
      faults_(faults),
      skipped_faults_(faults),
      pending_(std::move(first)),
      pending_line_(reader.line()) {}

/// Rows begin with a number, or with a type label that numbers follow; names of sections are words.
bool DataSections::names_a_section(std::string_view line) {
  split_at_blanks(line, words_);
  return !words_.empty() && std::all_of(words_.begin(), words_.end(),
                                        [](std::string_view word) { return !is_number_field(word); });
}

bool DataSections::next_section() {
  if (!ended_) skip_rows();
  if (pending_.empty() || reader_.failed()) return false;
  const std::size_t comment = std::min(pending_.find('#'), pending_.size());
  name_ = trimmed(std::string_view(pending_).substr(0, comment));
  style_ = trimmed(std::string_view(pending_).substr(std::min(comment + 1, pending_.size())));
  name_line_ = pending_line_;
  pending_.clear();
  ended_ = false;
  const auto skipped = reader_.next(faults_);
  if (!skipped) {
    ended_ = true;
  } else {
    split_at_blanks(*skipped, words_);
    if (!words_.empty())
      skipped_faults_.add(reader_.place(),
                          "LAMMPS reads over the line after a section's name, and this one is not empty",
                          "put an empty line between \"" + shown(name_) + "\" and its rows");
  }
  return true;
}

std::optional<std::string_view> DataSections::next_row() {
  while (!ended_) {
    const auto line = reader_.next(faults_);
    if (!line) {
      ended_ = true;
      break;
    }
    if (options_.progress && reader_.line() % lines_between_reports == 0) options_.progress(reader_.part());
    const std::size_t first = line->find_first_not_of(" \t");
    if (first == std::string_view::npos || (*line)[first] == '#') continue;
    const char c = (*line)[first];
    const bool may_be_number = (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
    if (may_be_number || !names_a_section(*line)) return line;
    pending_ = std::string(*line);
    pending_line_ = reader_.line();
    ended_ = true;
  }
  return std::nullopt;
}

Index DataSections::skip_rows() {
  Index count = 0;
  while (next_row()) ++count;
  return count;
}

}  // namespace bondstatic
