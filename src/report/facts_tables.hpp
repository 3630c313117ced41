// Tables of what every summary.json says in the same way (results/summary_parts.hpp).
#pragma once

#include <string>

#include "report/json_value.hpp"
#include "report/page_data.hpp"
#include "report/page_parts.hpp"

namespace bondstatic {

/// Title, warnings, what was solved; a note where another version wrote it, or the stamp is missing (throws).
void put_heading(PageRun& run, const JsonValue& summary);

/// Particles, bonds and laws, supports, unknowns, units.
void put_model(PageRun& run, const JsonValue& summary);

/// Which solver, why, threads, its matrix.
void put_solver(PageRun& run, const JsonValue& summary);

/// Errors and balances; a row each load case.
void put_accuracy(PageRun& run, const JsonValue& summary);

/// Seconds by phase, and memory.
void put_time_and_memory(PageRun& run, const JsonValue& summary);

/// Energies and largest displacements; a row each load case.
void put_load_cases(PageRun& run, const JsonValue& summary);

/// Bodies that nothing supports.
void put_left_out(PageRun& run, const JsonValue& summary);

/// "particle 11", "bond 3"; nothing for null.
std::optional<std::string> place_text(const JsonValue& place);

/// {"particle": 11, "magnitude": .., "components": [..]} as fields of a row: magnitude, place, x, y, z.
std::vector<PageField> displacement_fields(const JsonValue& largest);

}  // namespace bondstatic
