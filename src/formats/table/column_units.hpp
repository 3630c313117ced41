// Units in the headings of tables: "Position X (mm)".
#pragma once

#include <string>
#include <vector>

#include "bondstatic/units.hpp"
#include "formats/table/columns.hpp"

namespace bondstatic {

/// Headings whose numbers have a dimension.
struct UnitsSeen {
  std::vector<std::string> with, without;
};

/// Brings the numbers to SI where the heading has a unit, and removes it; one that is unknown or of another
/// dimension is a fault.
void bring_to_si(TableColumn& column, Dimension dimension, UnitsSeen& seen, std::vector<Fault>& faults);

bool has_unit_of(const ColumnName& heading, Dimension dimension);

/// Whether any heading says that numbers are SI, or now are; what is assumed of the others goes to the notes.
bool note_units(const UnitsSeen& seen, bool edem, ImportNotes& notes);

}  // namespace bondstatic
