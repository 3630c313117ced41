// fracture.csv: a row each bond that broke, in the order of events; what is of an event stands in each of its
// rows.
#pragma once

#include <string>
#include <vector>

#include "report/csv_columns.hpp"

namespace bondstatic {

struct BreakEvent {
  double step = 0;                                ///< from 1
  Index broken = 0;                               ///< bonds that break in it
  double load = 0, displacement = 0;              ///< just before
  double load_after = 0, displacement_after = 0;  ///< NaN where nothing is left to carry
  double factor = 0, runner_up = 0, released = 0;
  double strain_energy = 0, work = 0, dissipated = 0;  ///< after
  Index avalanche = 0;
  std::string bonds;            ///< "bond 12 (3 to 7), tension", of more: "and 2 more"
  std::vector<double> outputs;  ///< just before
};

struct BreakAvalanche {
  std::size_t first = 0, last = 0;  ///< events
  Index broken = 0;
  double released = 0;
};

struct FractureHistory {
  std::vector<std::string> outputs;
  std::vector<BreakEvent> events;
  std::vector<BreakAvalanche> avalanches;

  /// Bonds broken by the first so many events.
  Index broken_after(double events) const;
};

/// Throws InputError where the table is not what fracture writes.
FractureHistory read_fracture_history(const std::string& file, const CsvColumns& csv);

}  // namespace bondstatic
