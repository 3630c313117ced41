#include "case/bond_rows.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bond/parameters.hpp"
#include "case/bond_parameters.hpp"

namespace bondstatic {
namespace {

constexpr int most_faults = 20;

}  // namespace

void check_bond_parameters(Draft& draft, const BondLaw& law, const std::vector<double>& given,
                           const BondRows& rows, const PlaceOf& place_of) {
  if (rows.overrides.empty()) return;  // all rows are as the block says, which is checked there
  const ParameterRules rules = parameter_rules(law);
  std::map<std::size_t, std::vector<std::size_t>> ruled_out;
  for (const auto& column : rows.overrides) ruled_out[column.first] = rules.ruled_out_by(column.first);
  int faulty = 0;
  for (std::size_t row = 0; row < rows.a.size() && faulty < most_faults; ++row) {
    std::vector<double> values = given;
    values.resize(law.parameters.size(), not_given);
    // What a row gives rules out other ways to say the same thing in the block: `radius` a `radius_factor`.
    for (const auto& [p, column] : rows.overrides)
      if (!std::isnan(column[row]))
        for (const std::size_t other : ruled_out.at(p)) values[other] = not_given;
    for (const auto& [p, column] : rows.overrides)
      if (!std::isnan(column[row])) values[p] = column[row];
    std::vector<std::string> complaints;
    complete(rules, values, complaints);
    for (const std::string& text : complaints) {
      const Complaint complaint = explain(law, text);
      draft.reading.fault(place_of(Index(row), law.find(complaint.parameter)), complaint.message,
                          complaint.cure);
    }
    faulty += !complaints.empty();
  }
}

void check_fractions(Draft& draft, const BondRows& rows, const std::function<Place(Index row)>& place_of) {
  int faulty = 0;
  for (std::size_t row = 0; row < rows.fractions.size() && faulty < most_faults; ++row) {
    const double fraction = rows.fractions[row];
    if (std::isnan(fraction) || (fraction > 0 && fraction < 1)) continue;
    ++faulty;
    draft.reading.fault(place_of(Index(row)),
                        fmt::format("contact_point = {} must lie between 0 and 1", fraction),
                        "give the part of the branch from particle a, e.g. 0.5");
  }
}

void check_ends(Draft& draft, const BondRows& rows) {
  if (!draft.particles_known) return;  // ends are then not resolved
  int faulty = 0;
  for (std::size_t row = 0; row < rows.a.size() && faulty < most_faults; ++row)
    if (rows.a[row] == rows.b[row]) {
      ++faulty;
      draft.reading.fault(rows.places[row], "the bond joins a particle to itself", "give two different ids");
    }
}

}  // namespace bondstatic
