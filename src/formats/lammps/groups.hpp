// Groups of particles as LAMMPS input scripts make them (docs.lammps.org/group.html).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "formats/foreign_model.hpp"
#include "formats/lammps/commands.hpp"

namespace bondstatic {

/// Whole numbers first, first + step, ... up to last.
struct WholeRange {
  Index first = 0;
  Index last = 0;
  Index step = 1;

  bool contains(Index value) const {
    return value >= first && value <= last &&
           (std::uint64_t(value) - std::uint64_t(first)) % std::uint64_t(step) == 0;
  }
};

/// A whole number of at most 18 digits.
std::optional<Index> script_whole(std::string_view text);

/// A `group` command; several of one name add up.
struct ScriptGroup {
  enum class Style {
    type,
    id,
    subtract,
    unite,
    intersect,
    clear,
    unknown  ///< by region, variable, molecule, ...: its members cannot be told from the script
  };
  std::string name;
  Style style = Style::unknown;
  std::vector<WholeRange> ranges;     ///< of type, id
  std::vector<std::string> operands;  ///< groups
  Place place;
};

/// Nothing where the command makes no group or is at fault.
std::optional<ScriptGroup> read_script_group(const ScriptCommand& command, ImportNotes& notes,
                                             std::vector<Fault>& faults);

/// Which particles of the model a group has; nothing where that cannot be told.
using Members = std::optional<std::vector<char>>;

/// Members of every group at the end of the commands, "all" among them. Types are those of the model's groups
/// "type N". A group that is used and never made is a fault.
std::map<std::string, Members> script_group_members(const std::vector<ScriptGroup>& groups,
                                                    const ForeignModel& model, std::vector<Fault>& faults);

}  // namespace bondstatic
