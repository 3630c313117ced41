// What the pages of all kinds of runs are put together from.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/json_value.hpp"
#include "report/page_data.hpp"

namespace bondstatic {

/// PageUnits are known where a case is in SI only.
struct PageUnits {
  bool si = false;
  std::string of(const std::string& unit) const { return si ? unit : ""; }
  /// "energy, J"
  std::string in(const std::string& name, const std::string& unit) const;
  PageAxis axis(const std::string& name, const std::string& unit, bool log = false) const;
};

/// From "units" of a summary.
PageUnits units_of(const JsonValue& summary);

/// A table of a name and a value in each row; what is not there has no row.
class Facts {
 public:
  explicit Facts(const std::string& title) : table_{title, {"quantity", "value"}, {}} {}
  Facts& add(const std::string& name, const std::optional<double>& value);
  Facts& add(const std::string& name, const std::optional<std::string>& value);
  Facts& add(const std::string& name, const char* value) { return add(name, std::string(value)); }
  /// Appends the table, unless it has no rows.
  void put_into(std::vector<PageTable>& tables) &&;

 private:
  PageTable table_;
};

PageField field(double value);  ///< nothing where it is NaN
PageField field(const std::optional<double>& value);
PageField field(const std::optional<std::string>& value);

/// Without the columns that have nothing in any row; not appended where no row is left.
void put_table(std::vector<PageTable>& tables, PageTable table);

/// Without series that have no point; not appended where no series is left. On log axes what is not positive
/// is a gap.
void put_plot(std::vector<PagePlot>& plots, PagePlot plot);

/// Whether positive numbers are better told apart on a log axis: over two decades between them.
bool wants_log(const std::vector<PageSeries>& series);

/// A value that all the others are to be below, from the first to the last category or x.
PageSeries limit_line(const std::string& name, double value, double from, double to);

/// 0, 1, ...: where categories lie.
std::vector<double> places(std::size_t count);

/// "11, 12, 13 and 40 more"
std::string id_text(const JsonValue& ids);

/// ": shear", or nothing for a load case without a name.
std::string suffix_of(const std::string& load_case);

/// "1 bond", "12 bonds"
std::string count_text(Index count, const std::string& what);

}  // namespace bondstatic
