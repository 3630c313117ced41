// The law of a [[bonds]] block and its parameters; strengths (bond_strength.hpp) go the same way.
#pragma once

#include <string>
#include <vector>

#include "case/parameter_list.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

/// The law that the block names; null and a fault where there is none of that name. `otherwise` is taken
/// where the block names none; "": that is a fault, too.
const BondLaw* read_law(TableReader& block, const std::string& otherwise = "");

/// The one of `names` that a key gives; "" and a fault where it gives none of them. `more` says where they
/// are explained.
std::string read_one_of(TableReader& table, const std::string& key, const std::vector<std::string>& names,
                        const std::string& more);

/// The table's own parameters in the order of the list, NaN where not given. Checks nothing but their type
/// and unit.
std::vector<double> read_parameters(TableReader& table, const ParameterList& list);

/// Completes and checks them, as faults of the table, and writes the defaults back.
std::vector<double> complete_parameters(TableReader& table, const ParameterList& list,
                                        const std::vector<double>& given);

/// A complaint of ParameterList::complete as a fault; `parameter` names what it is about, "" if that cannot
/// be told.
struct Complaint {
  std::string parameter;
  std::string message;
  std::string cure;
};
Complaint explain(const ParameterList& list, const std::string& complaint);

}  // namespace bondstatic
