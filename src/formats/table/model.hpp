// The two kinds of a ForeignModel that come from columns.
#pragma once

#include "formats/foreign_model.hpp"
#include "formats/table/columns.hpp"

namespace bondstatic {

Wanted wanted_of_particles(const std::string& name);
Wanted wanted_of_bonds(const std::string& name);

/// The columns are used up.
void take_particles(TableColumns& table, ForeignModel& model, std::vector<Fault>& faults);
void take_bonds(TableColumns& table, ForeignModel& model, std::vector<Fault>& faults);

/// "columns not taken: ..." where there are any.
void note_columns_left(const TableColumns& table, const std::vector<const TableColumn*>& taken,
                       const std::string& why, ImportNotes& notes);

}  // namespace bondstatic
