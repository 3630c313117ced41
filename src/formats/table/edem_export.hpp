// EDEM's export of results data as text: blocks under "TIME: t", in each the queries of its configuration,
// as "Q01 : Particle Position X: v v v", or as headings of columns above rows of values
// (EDEM Analyst, "Exporting Results Data"; the layout as read by GeneralFunctions/MUSENStringFunctions.h
// and SystemStructure.cpp, ImportFromEDEMTextFormat, of msolids/musen).
#pragma once

#include "formats/table/columns.hpp"
#include "io/line_reader.hpp"

namespace bondstatic {

/// "TIME: 0.4", "Q01 : Particle ID: 1 2 3".
bool heads_edem_block(std::string_view line);

/// The block of the step asked for, counted from 1, or the last; `line` is the one read already.
std::optional<TableColumns> read_edem_blocks(LineReader& reader, std::string line, const ReadOptions& options,
                                             const WantColumn& want, std::vector<std::string> left_lines,
                                             std::vector<Fault>& faults);

}  // namespace bondstatic
