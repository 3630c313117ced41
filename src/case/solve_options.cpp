#include "case/solve_options.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "bondstatic/linear_solver.hpp"

namespace bondstatic {
namespace {

/// Bytes of "8 GB" or "500 MiB"; NaN where the text is not like that.
double parse_bytes(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, double>, 9> units{{{"B", 1},
                                                                      {"kB", 1e3},
                                                                      {"MB", 1e6},
                                                                      {"GB", 1e9},
                                                                      {"TB", 1e12},
                                                                      {"KiB", 0x1p10},
                                                                      {"MiB", 0x1p20},
                                                                      {"GiB", 0x1p30},
                                                                      {"TiB", 0x1p40}}};
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !(number >= 0) || std::isinf(number)) return not_given;
  text.remove_prefix(std::size_t(end - text.data()));
  while (text.starts_with(' ')) text.remove_prefix(1);
  for (const auto& [name, bytes] : units)
    if (text == name) return number * bytes;
  return not_given;
}

double read_memory_limit(TableReader& solve) {
  const Node* node = solve.find("memory_limit");
  if (!node || !node->is_text())
    return solve.number_or("memory_limit", 0, dimension::none, Allowed::not_negative);
  const double bytes = parse_bytes(node->text);
  if (!std::isnan(bytes)) return bytes;
  solve.reading().fault(node->place, fmt::format("memory_limit = {} is no amount of memory", shown(*node)),
                        "write bytes, or for instance \"8 GB\" or \"500 MiB\"");
  return 0;
}

}  // namespace

StaticOptions read_solve_options(Reading& reading, Node& table) {
  TableReader solve(reading, table, "[solve]");
  StaticOptions options;
  std::vector<std::string> solvers{"auto"};
  for (const SolverInfo& info : available_solvers()) solvers.push_back(info.name);
  options.solver = solve.choice_or("solver", options.solver, solvers);
  options.tolerance = solve.number_or("tolerance", options.tolerance, dimension::none, Allowed::positive);
  const std::string unsupported =
      solve.choice_or("unsupported", "error", std::vector<std::string>{"error", "drop"});
  options.unsupported = unsupported == "drop" ? Unsupported::drop : Unsupported::error;
  options.memory_limit = read_memory_limit(solve);
  const Index threads = solve.whole_or("threads", 0, 0);
  options.threads = int(threads);
  if (threads > 4096) {
    reading.fault(solve.place_of("threads"), fmt::format("threads = {} must be at most 4096", threads),
                  "write threads = 0 for the cores at hand");
    options.threads = 0;
  }
  solve.finish();
  return options;
}

}  // namespace bondstatic
