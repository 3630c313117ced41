// The law of a [[bonds]] block and its parameters.
#pragma once

#include <string>
#include <vector>

#include "bondstatic/bond_law.hpp"
#include "case/table_reader.hpp"

namespace bondstatic {

/// The law that the block names; null and a fault where there is none of that name. `otherwise` is taken
/// where the block names none; "": that is a fault, too.
const BondLaw* read_law(TableReader& block, const std::string& otherwise = "");

/// The block's own parameters in the law's order, NaN where not given. Checks nothing but their type and
/// unit.
std::vector<double> read_parameters(TableReader& block, const BondLaw& law);

/// Completes and checks them, as faults of the block, and writes the defaults back.
std::vector<double> complete_parameters(TableReader& block, const BondLaw& law,
                                        const std::vector<double>& given);

/// A complaint of complete_parameters() as a fault; `parameter` names what it is about, "" if that cannot be
/// told.
struct Complaint {
  std::string parameter;
  std::string message;
  std::string cure;
};
Complaint explain(const BondLaw& law, const std::string& complaint);

}  // namespace bondstatic
