#include "formats/lammps/types.hpp"

#include <fmt/format.h>

namespace bondstatic {

std::optional<Index> TypeNumbers::number(RowFields& fields, std::size_t field, Index lowest) const {
  if (!labels_.empty()) {
    const auto found = labels_.find(fields.text(field));
    if (found != labels_.end()) return found->second;
  }
  return fields.whole_number(field, name_, lowest, highest_);
}

void TypeNumbers::read_labels(DataSections& sections, const LineReader& reader, std::vector<Fault>& faults) {
  RowFields fields(reader, faults);
  while (const auto row = sections.next_row()) {
    fields.take(*row);
    if (fields.size() < 2)
      fields.fault(0, "a label needs its type's number before it", "write \"1 NAME\"");
    else if (const auto type = fields.whole_number(0, name_, 1, highest_))
      if (!labels_.emplace(fields.text(1), *type).second)
        fields.fault(1, fmt::format("the label \"{}\" is there twice", shown(fields.text(1))),
                     "give every type a label of its own");
    if (fields.gave_up()) break;
  }
}

}  // namespace bondstatic
