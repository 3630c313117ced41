// Types of atoms and bonds in a LAMMPS data file: numbers, or labels for them (documentation page
// "Howto_type_labels").
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>

#include "formats/lammps/sections.hpp"

namespace bondstatic {

inline constexpr Index highest_type = std::numeric_limits<std::int32_t>::max();

class TypeNumbers {
 public:
  TypeNumbers(std::string name, Index highest) : name_(std::move(name)), highest_(highest) {}

  /// Nothing, and a fault, where the field holds none.
  std::optional<Index> number(RowFields& fields, std::size_t field, Index lowest) const;

  /// Section "Atom Type Labels" or "Bond Type Labels".
  void read_labels(DataSections& sections, const LineReader& reader, std::vector<Fault>& faults);

 private:
  std::string name_;
  Index highest_;
  std::map<std::string, Index, std::less<>> labels_;
};

}  // namespace bondstatic
