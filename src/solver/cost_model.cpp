#include "solver/cost_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bondstatic {

namespace {

std::string seconds_text(double seconds) {
  if (seconds < 1e-3) return "less than 1 ms";
  if (seconds < 1) return fmt::format("{:.0f} ms", 1e3 * seconds);
  if (seconds < 300) return fmt::format("{:.3g} s", seconds);
  if (seconds < 3 * 3600) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.0f} h", seconds / 3600);
}

}  // namespace

std::string size_text(double bytes) {
  if (bytes < 1e6) return fmt::format("{:.0f} kB", std::ceil(bytes / 1e3));
  return bytes < 1e9 ? fmt::format("{:.3g} MB", bytes / 1e6) : fmt::format("{:.3g} GB", bytes / 1e9);
}

std::string figures(const Cost& cost) {
  return fmt::format("{} and {}", seconds_text(cost.seconds), size_text(cost.bytes));
}

Cost direct_cost(const AnalysisReport& analysis, const DirectRates& rates, int threads) {
  const double faster = std::pow(std::max(1, threads), rates.thread_exponent);
  return {rates.per_flop * analysis.factor_flops / faster +
              rates.per_factor_entry * double(analysis.factor_entries) +
              rates.per_matrix_entry * double(analysis.matrix_entries),
          analysis.predicted_bytes};
}

double factorisation_seconds(const AnalysisReport& analysis, const DirectRates& rates) {
  return rates.per_flop * analysis.factor_flops + rates.per_factor_entry * double(analysis.factor_entries);
}

double kept_factor_seconds(const AnalysisReport& analysis, Index links) {
  constexpr double back_substitution = 1.3e-9;  // an entry of the factor, which is read twice
  constexpr double product = 1.5e-7;            // a link
  return back_substitution * double(analysis.factor_entries) + product * double(links);
}

Cost linear_cost(Index bodies, Index links, const LinearRates& rates, int threads) {
  const double faster = std::pow(std::max(1, threads), rates.thread_exponent);
  return {(rates.seconds_per_body * double(bodies) + rates.seconds_per_link * double(links)) / faster,
          rates.bytes_per_body * double(bodies) + rates.bytes_per_link * double(links)};
}

double solution_bytes(double links, double bodies) {
  constexpr double extended = 96, plain = 48;  // six numbers a body or a link
  // Recovery holds most: resultants and their magnitudes in extended precision beside the state.
  return (extended + 16 + 104) * links + (3 * extended + 4 * plain) * bodies;
}

Choice choose_solver(std::span<const Candidate> candidates, double memory) {
  if (candidates.empty()) throw std::invalid_argument("choose_solver: no candidate");
  const auto bytes = [](const Candidate& a, const Candidate& b) { return a.cost.bytes < b.cost.bytes; };
  const auto least = std::min_element(candidates.begin(), candidates.end(), bytes);
  const std::string at_hand = size_text(memory);
  if (least->cost.bytes > memory)
    return {least->solver,
            fmt::format("{} takes least memory, {}, of which {} are at hand", least->solver,
                        size_text(least->cost.bytes), at_hand),
            false};
  const auto latest = [](const Candidate& c) { return c.doubt * c.cost.seconds; };
  auto best = least;
  for (auto one = candidates.begin(); one != candidates.end(); ++one)
    if (one->cost.bytes <= memory &&
        (latest(*one) < latest(*best) || (latest(*one) == latest(*best) && one < best)))
      best = one;
  std::string reason = fmt::format("{}: predicted {}", best->solver, figures(best->cost));
  for (const Candidate& other : candidates) {
    if (&other == &*best) continue;
    reason += fmt::format(", {} {}{}", other.solver, figures(other.cost),
                          other.cost.bytes > memory ? fmt::format(" of {} at hand", at_hand) : "");
  }
  return {best->solver, reason, true};
}

}  // namespace bondstatic
