#include "bench/residual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "bench/to_residual.hpp"

namespace bondstatic::bench {

namespace {

constexpr double goal = 1e-8;
constexpr double longest = 900;  // seconds that one run may take
constexpr int repeats = 3;

void keep_fastest(ToResidual& best, const ToResidual& next, bool first) {
  if (first || (next.reached && (!best.reached || next.total() < best.total()))) best = next;
}

void print_row(const std::string& packing, const std::string& solver, const ToResidual& m,
               const std::string& ratio) {
  if (m.rounds == 0) {
    fmt::print("| {} | | {} | {} ||||||||\n", packing, solver, m.note);
    return;
  }
  std::string left;
  for (int round = 0; round < m.rounds; ++round)
    left += fmt::format("{}{:.1e}", round > 0 ? ", " : "", m.left[round]);
  fmt::print("| {} | {} | {} | {:.2f} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {}{} | {:.0f} | {} |\n",
             packing, m.particles, solver, m.set_up, m.iterations, m.solves, m.residuals, m.total(), m.wall,
             left, m.reached ? "" : " (not reached)", 1e-6 * m.peak_bytes, ratio);
  std::fflush(stdout);
}

const Family& family_named(const std::string& name) {
  std::string known;
  for (const Family& family : families()) {
    if (family.name == name) return family;
    known += (known.empty() ? "" : ", ") + family.name;
  }
  throw std::runtime_error("there is no packing \"" + name + "\"; there are " + known);
}

}  // namespace

void race_to_residual(const Race& race) {
  std::vector<std::string> names = race.packings;
  if (names.empty()) names = {"disordered FCC", "FCC, E over 3 decades"};
  std::vector<const Family*> asked;
  for (const std::string& name : names) asked.push_back(&family_named(name));
  fmt::print(
      "One solve to |b - K u| <= {:.0e} |b| on one thread: processor time of the fastest of {} runs, each in "
      "a "
      "process of its own.\n\n"
      "| packing | particles | solver | analysis, set-up s | iterations | iterating s | residuals s | total "
      "s | "
      "on the clock s | true residual after each solve | peak MB | times as fast |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n",
      goal, repeats);
  for (const Family* family : asked) {
    ToResidual petsc, multigrid;
    for (int i = 0; i < repeats; ++i) {
      keep_fastest(petsc, solve_to_residual(*family, race.particles, "petsc", goal, longest), i == 0);
      keep_fastest(multigrid, solve_to_residual(*family, race.particles, "multigrid", goal, longest), i == 0);
    }
    print_row(family->name, "petsc", petsc, "");
    const bool both = petsc.reached && multigrid.reached;
    print_row(family->name, "multigrid", multigrid,
              both ? fmt::format("**{:.1f}**", petsc.total() / multigrid.total()) : "");
  }
}

}  // namespace bondstatic::bench
