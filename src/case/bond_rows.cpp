#include "case/bond_rows.hpp"

#include <fmt/format.h>

#include <cmath>

#include "case/bond_parameters.hpp"

namespace bondstatic {
namespace {

constexpr int most_faults = 20;

using Overrides = std::map<std::size_t, std::vector<double>>;

void check_rows(Draft& draft, const ParameterList& list, const std::vector<double>& given,
                const Overrides& overrides, std::size_t rows, const PlaceOf& place_of) {
  if (overrides.empty()) return;  // all rows are as the block says, which is checked there
  std::map<std::size_t, std::vector<std::size_t>> ruled_out;
  for (const auto& column : overrides) ruled_out[column.first] = list.ruled_out_by(column.first);
  int faulty = 0;
  std::vector<double> values;
  std::vector<std::string> complaints;
  for (std::size_t row = 0; row < rows && faulty < most_faults; ++row) {
    values = given;
    values.resize(list.parameters->size(), not_given);
    // What a row gives rules out other ways to say the same thing in the block: `radius` a `radius_factor`.
    for (const auto& [p, column] : overrides)
      if (!std::isnan(column[row]))
        for (const std::size_t other : ruled_out.at(p)) values[other] = not_given;
    for (const auto& [p, column] : overrides)
      if (!std::isnan(column[row])) values[p] = column[row];
    complaints.clear();
    list.complete(values, complaints);
    for (const std::string& text : complaints) {
      const Complaint complaint = explain(list, text);
      draft.reading.fault(place_of(Index(row), list.find(complaint.parameter)), complaint.message,
                          complaint.cure);
    }
    faulty += !complaints.empty();
  }
}

}  // namespace

void check_bond_parameters(Draft& draft, const BondLaw& law, const std::vector<double>& given,
                           const BondRows& rows, const PlaceOf& place_of) {
  check_rows(draft, law, given, rows.overrides, rows.a.size(), place_of);
}

void check_bond_strengths(Draft& draft, const GivenStrengths* strengths, const BondRows& rows,
                          const PlaceOf& place_of) {
  if (strengths)
    check_rows(draft, *strengths->criterion, strengths->made.parameters, rows.strengths, rows.a.size(),
               place_of);
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
