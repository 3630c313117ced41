// Results as one HTML file that opens in any browser without a network: the model in three dimensions, plots
// and tables. The page itself is part of the library, where that was built with npm at hand.
#pragma once

#include <string>
#include <vector>

namespace bondstatic {

inline constexpr const char* report_file = "report.html";

/// Throws Error (invalid_input) where this build has no page (the message says how to come by it), or where
/// `file` exists and is no report, or its folder does not; worth calling before long work.
void check_report(const std::string& file);

struct Report {
  std::string file;
  double bytes = 0;
  std::vector<std::string> notes;  ///< what it leaves out, of which folder
};

/// Shows the runs whose results lie in these folders, side by side; the file appears whole or not at all.
/// Throws Error (invalid_input) where a folder holds no results of ours, or damaged ones.
Report write_report(const std::vector<std::string>& folders, const std::string& file);

/// Whether the file is a report. False where there is none.
bool is_report(const std::string& file);

}  // namespace bondstatic
